#include "display_driver/wire/frame_encoder.h"

#include <gtest/gtest.h>

#include "display_driver/wire/frame_assembler.h"
#include "display_driver/wire/message_reader.h"
#include "oc_core/base/random.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli::wire {
namespace {

constexpr uint32_t kAllCapabilities = kCanZstd | kCanRunLength | kCanDelta;

/// A frame's messages, in batches of this many slices.
std::vector<uint8_t> messagesOf(MessageWriter& writer, FrameEncoder& encoder, uint32_t frame, uint32_t base,
                                size_t batch, size_t maxSlices = 1000000) {
  std::vector<uint8_t> bytes;
  writer.frameBegin(bytes, frame, {base, encoder.records()});
  size_t sent = 0;
  while (sent < maxSlices && encoder.slicesLeft() > 0) {
    for (const FrameEncoder::Coded& coded : encoder.next(std::min(batch, maxSlices - sent))) {
      writer.slice(bytes, frame, coded.slice, coded.coded);
      ++sent;
    }
  }
  writer.frameEnd(bytes, frame);
  return bytes;
}

/// What an assembler makes of them.
struct Assembled {
  Volume volume;
  ErrorCode error = ErrorCode::kNone;
  bool ended = false;
};

Assembled assemble(std::span<const uint8_t> bytes, const DisplayProfile& profile, const Volume* base,
                   FrameAssembler& assembler) {
  Assembled result{Volume(profile)};
  MessageReader reader(Volume(profile).layout().sliceBytes);
  reader.begin(1);
  const auto note = [&](ErrorCode error) { result.error = result.error == ErrorCode::kNone ? error : result.error; };
  reader.read(
      bytes,
      {.message =
           [&](const Message& message) {
             if (message.header.type == MessageType::kFrameBegin) {
               const auto begin = frameBeginFrom(message.payload, static_cast<size_t>(profile.storedSlices()));
               assembler.begin(begin.value(), base, result.volume);
             } else if (message.header.type == MessageType::kSlice) {
               note(assembler.slice(message.header, message.payload));
             } else {
               result.ended = true;
               note(assembler.end(frameEndFrom(message.payload).value()));
             }
             return true;
           },
       // Sessions begin anew in these tests, so that sequence numbers do not tell anything.
       .problem = [&](ErrorCode error, uint32_t) { note(error == ErrorCode::kSequence ? result.error : error); }});
  return result;
}

TEST(FrameEncoder, framesComeTogetherAgain) {
  for (const int bits : {1, 3}) {
    const DisplayProfile profile = smallProfile(11, bits);
    FrameEncoder encoder(profile, kAllCapabilities);
    FrameAssembler assembler(profile, kAllCapabilities);
    MessageWriter writer(1);
    Volume shown(profile);
    Random random(5);
    for (uint32_t frame = 1; frame < 20; ++frame) {
      Volume volume = frame % 3 == 0 ? Volume(profile) : shown;
      lightSome(volume, random, 0.002);
      const Volume* base = frame % 4 == 1 ? nullptr : &shown;
      encoder.begin(volume, base, std::nullopt);
      const std::vector<uint8_t> bytes =
          messagesOf(writer, encoder, frame, base == nullptr ? 0 : frame - 1, 1 + frame % 5);
      const Assembled assembled = assemble(bytes, profile, base, assembler);
      EXPECT_EQ(assembled.error, ErrorCode::kNone);
      EXPECT_TRUE(assembled.ended);
      EXPECT_TRUE(assembled.volume == volume) << "frame " << frame;
      shown = volume;
    }
  }
}

TEST(FrameEncoder, slicesThatAreTheSameAreLeftOut) {
  const DisplayProfile profile = smallProfile();
  const Volume before = madeVolume(profile, 1);
  Volume after = before;
  after.light(4, 1, 2, 7);
  FrameEncoder encoder(profile, kAllCapabilities);
  encoder.begin(after, &before, std::nullopt);
  EXPECT_EQ(encoder.slicesLeft(), before == after ? 0u : 1u);
  EXPECT_TRUE(encoder.records()[4]);
  const std::vector<int> others = {1, 2};
  encoder.begin(after, &before, others);  // the caller knows better
  EXPECT_EQ(encoder.slicesLeft(), 0u);
  encoder.begin(Volume(profile), nullptr, std::nullopt);
  EXPECT_EQ(encoder.slicesLeft(), 0u);
}

TEST(FrameAssembler, aFrameThatIsGivenUpIsACoarseVolume) {
  const DisplayProfile profile = smallProfile(16);
  const Volume volume = madeVolume(profile, 2, 0.2);
  FrameEncoder encoder(profile, kAllCapabilities);
  FrameAssembler assembler(profile, kAllCapabilities);
  encoder.begin(volume, nullptr, std::nullopt);
  MessageWriter writer(1);
  Assembled assembled = assemble(messagesOf(writer, encoder, 1, 0, 4, 4), profile, nullptr, assembler);
  EXPECT_EQ(assembled.error, ErrorCode::kIncomplete);
  ASSERT_TRUE(assembler.fillGaps(assembled.volume));
  // Slices 0, 4, 8 and 12 have come; each of the others shows the nearest of them.
  for (int i = 0; i < 16; ++i) {
    const int nearest = std::min(4 * ((i + 1) / 4), 12);
    EXPECT_TRUE(std::ranges::equal(std::as_const(assembled.volume).slice(i), volume.slice(nearest))) << i;
  }
}

TEST(FrameAssembler, slicesThatAreNotDueAreRefused) {
  const DisplayProfile profile = smallProfile();
  const Volume volume = madeVolume(profile, 2);
  FrameAssembler assembler(profile, kAllCapabilities);
  Volume target(profile);
  FrameBegin begin{.records = std::vector<bool>(11)};
  begin.records[3] = true;
  const auto sliceAt = [&](uint16_t slice) {
    const std::span<const uint8_t> planes = volume.slice(3);
    const MessageHeader header{.type = MessageType::kSlice, .slice = slice, .payloadChecksum = crc32c(planes)};
    return assembler.slice(header, planes);
  };
  assembler.begin(begin, nullptr, target);
  EXPECT_EQ(sliceAt(2), ErrorCode::kSlice);
  EXPECT_EQ(sliceAt(11), ErrorCode::kSlice);
  EXPECT_EQ(sliceAt(3), ErrorCode::kNone);
  EXPECT_EQ(sliceAt(3), ErrorCode::kSlice);
}

}  // namespace
}  // namespace ocelli::wire
