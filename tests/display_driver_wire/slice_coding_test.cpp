#include "display_driver/wire/slice_coding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "oc_core/base/random.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli::wire {
namespace {

constexpr uint32_t kEverything = kCanZstd | kCanRunLength | kCanDelta;

std::vector<uint8_t> sparseBytes(size_t count, uint64_t seed, size_t oneIn) {
  std::vector<uint8_t> bytes(count);
  Random random(seed);
  for (uint8_t& byte : bytes) {
    byte = random.below(oneIn) == 0 ? static_cast<uint8_t>(1 + random.below(255)) : uint8_t{0};
  }
  return bytes;
}

TEST(RunLength, whatWasCodedComesBack) {
  for (const size_t oneIn : {1u, 2u, 3u, 10u, 100u, 100000u}) {
    for (const size_t count : {1u, 2u, 7u, 8u, 9u, 127u, 128u, 129u, 40000u}) {
      const std::vector<uint8_t> content = sparseBytes(count, count, oneIn);
      std::vector<uint8_t> back(count, 0x55);
      EXPECT_TRUE(runLengthDecode(runLengthEncode(content), back));
      EXPECT_EQ(back, content) << count << " bytes, one in " << oneIn;
    }
  }
}

// The example of docs/wire_protocol.md.
TEST(RunLength, hasTheBytesThatTheDocumentShows) {
  std::vector<uint8_t> content(200);
  content.insert(content.end(), {1, 2, 0, 3});
  content.resize(208);
  EXPECT_EQ(runLengthEncode(content), (std::vector<uint8_t>{0xc8, 0x01, 4, 1, 2, 0, 3, 4, 0}));
}

TEST(RunLength, refusesWhatIsNoCoding) {
  std::vector<uint8_t> content(10);
  const auto refused = [&](std::vector<uint8_t> payload) { return !runLengthDecode(payload, content); };
  EXPECT_FALSE(refused({10, 0}));
  EXPECT_TRUE(refused({9, 0}));                                      // too few
  EXPECT_TRUE(refused({11, 0}));                                     // too many
  EXPECT_TRUE(refused({0, 10, 1, 2, 3}));                            // bytes are missing
  EXPECT_TRUE(refused({10}));                                        // a count is missing
  EXPECT_TRUE(refused({10, 0, 0, 0}));                               // a pair that says nothing
  EXPECT_TRUE(refused({0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 1, 0}));  // a count without end
  EXPECT_TRUE(refused({0xff, 0xff, 0xff, 0xff, 0x7f, 0}));
  EXPECT_TRUE(refused({}));
}

TEST(SliceCoding, everyCodingGivesTheSliceBack) {
  const DisplayProfile profile = smallProfile(2, 3);
  const Volume before = madeVolume(profile, 1);
  Volume after = before;
  after.light(0, 3, 4, 7);
  const uint32_t sets[] = {0, kCanRunLength, kCanZstd, kCanDelta, kCanRunLength | kCanDelta, kEverything};
  for (const uint32_t capabilities : sets) {
    SliceCoder coder(capabilities);
    SliceDecoder decoder(profile, capabilities);
    std::vector<uint8_t> planes(after.layout().sliceBytes, 0xaa);
    for (const bool withBase : {false, true}) {
      const std::span<const uint8_t> base = withBase ? std::as_const(before).slice(0) : std::span<const uint8_t>();
      const CodedSlice coded = coder.encode(after.slice(0), base);
      EXPECT_EQ((coded.coding & kDeltaFlag) != 0, withBase && (capabilities & kCanDelta) != 0);
      EXPECT_LE(coded.payload.size(), planes.size());
      EXPECT_EQ(decoder.decode(coded.coding, coded.payload, base, planes), ErrorCode::kNone);
      EXPECT_TRUE(std::ranges::equal(planes, after.slice(0)));
    }
  }
}

TEST(SliceCoding, noiseIsSentAsItIs) {
  const DisplayProfile profile = smallProfile();
  const Volume volume = madeVolume(profile, 3, 5);
  const CodedSlice coded = SliceCoder(kCanRunLength).encode(volume.slice(0), {});
  EXPECT_EQ(coded.coding, static_cast<uint8_t>(Coding::kRaw));
}

TEST(SliceCoding, effortChoosesTheCoding) {
  const Volume volume = madeVolume(smallProfile(), 1);
  const auto codingOf = [&](uint32_t capabilities, Effort effort) {
    return static_cast<Coding>(SliceCoder(capabilities, effort).encode(volume.slice(0), {}).coding);
  };
  EXPECT_EQ(codingOf(kEverything, Effort::kSmall), Coding::kZstd);
  EXPECT_EQ(codingOf(kEverything, Effort::kFast), Coding::kRunLength);
  EXPECT_EQ(codingOf(kCanZstd, Effort::kFast), Coding::kZstd);
  EXPECT_EQ(codingOf(kCanRunLength, Effort::kSmall), Coding::kRunLength);
}

// Slices so large that a sample of them is taken.
TEST(SliceCoding, differencesAreSentWhereTheyAreSmaller) {
  DisplayProfile profile = smallProfile(2);
  profile.width = 768;
  profile.height = 256;
  const Volume before = madeVolume(profile, 1, 0.05);
  Volume alike = before;
  Random random(4);
  lightSome(alike, random, 0.002);
  SliceCoder coder(kEverything);
  const auto isDelta = [&](const Volume& after) {
    return (coder.encode(after.slice(0), before.slice(0)).coding & kDeltaFlag) != 0;
  };
  EXPECT_TRUE(isDelta(alike));
  EXPECT_FALSE(isDelta(madeVolume(profile, 2, 0.05)));
}

TEST(SliceCoding, wrongPayloadsAreNamed) {
  const DisplayProfile profile = smallProfile();
  const Volume volume = madeVolume(profile, 1);
  const std::span<const uint8_t> slice = volume.slice(0);
  std::vector<uint8_t> planes(slice.size());
  SliceDecoder decoder(profile, kEverything);
  const auto code = [](Coding coding) { return static_cast<uint8_t>(coding); };
  EXPECT_EQ(decoder.decode(code(Coding::kRaw), slice.first(10), {}, planes), ErrorCode::kContent);
  EXPECT_EQ(decoder.decode(code(Coding::kZstd), slice, {}, planes), ErrorCode::kContent);
  EXPECT_EQ(decoder.decode(3, slice, {}, planes), ErrorCode::kUnknownCoding);
  EXPECT_EQ(decoder.decode(kDeltaFlag, slice, {}, planes), ErrorCode::kNoBase);
  EXPECT_EQ(SliceDecoder(profile, 0).decode(kDeltaFlag, slice, slice, planes), ErrorCode::kUnknownCoding);
  EXPECT_EQ(SliceDecoder(profile, 0).decode(code(Coding::kZstd), slice, slice, planes), ErrorCode::kUnknownCoding);
  std::vector<uint8_t> padded(slice.begin(), slice.end());
  padded[4] |= 0x80;  // column 39 of 37
  EXPECT_EQ(decoder.decode(code(Coding::kRaw), padded, {}, planes), ErrorCode::kContent);
}

TEST(CoarseToFine, everySliceComesOnce) {
  for (const int slices : {1, 2, 3, 7, 8, 24, 198, 396}) {
    std::vector<int> order = coarseToFineOrder(slices);
    std::ranges::sort(order);
    std::vector<int> all(static_cast<size_t>(slices));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
  }
}

// After the first k slices no gap is wider than twice the mean one, and one slice more where they do not divide.
TEST(CoarseToFine, anyFirstPartCoversTheTurn) {
  const int slices = 198;
  const std::vector<int> order = coarseToFineOrder(slices);
  std::vector<int> sent;
  for (const int slice : order) {
    sent.insert(std::ranges::upper_bound(sent, slice), slice);
    int widest = sent.front() + slices - sent.back();
    for (size_t i = 1; i < sent.size(); ++i) {
      widest = std::max(widest, sent[i] - sent[i - 1]);
    }
    EXPECT_LE(widest, 2 * slices / static_cast<int>(sent.size()) + 2) << sent.size();
  }
}

TEST(NearestPresent, takesTheNearest) {
  std::vector<bool> present(8);
  present[2] = present[5] = true;
  EXPECT_EQ(nearestPresent(present), (std::vector<int>{2, 2, 2, 2, 5, 5, 5, 5}));
  EXPECT_EQ(nearestPresent(std::vector<bool>(3)), (std::vector<int>{-1, -1, -1}));
}

}  // namespace
}  // namespace ocelli::wire
