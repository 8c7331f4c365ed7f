#include "display_driver/wire/message_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "display_driver/wire/frame_encoder.h"
#include "oc_core/base/random.h"

namespace ocelli::wire {
namespace {

constexpr uint32_t kSession = 5;

/// Frames numbered from 1, each a message with a payload of its own.
std::vector<uint8_t> someMessages(uint32_t count) {
  std::vector<uint8_t> bytes;
  MessageWriter writer(kSession);
  for (uint32_t frame = 1; frame <= count; ++frame) {
    writer.slice(bytes, frame, 0, {0, std::vector<uint8_t>(10 * frame, static_cast<uint8_t>('O'))});
  }
  return bytes;
}

struct Seen {
  std::vector<uint32_t> frames;
  std::vector<ErrorCode> problems;
  size_t refusals = 0;

  MessageReader::Handler handler() {
    return {.message =
                [this](const Message& message) {
                  if (refusals > 0) {
                    --refusals;
                    return false;
                  }
                  EXPECT_EQ(message.payload.size(), 10 * message.header.frame);
                  frames.push_back(message.header.frame);
                  return true;
                },
            .problem = [this](ErrorCode code, uint32_t) { problems.push_back(code); }};
  }
};

Seen readAll(std::span<const uint8_t> bytes, size_t piece) {
  Seen seen;
  MessageReader reader(1000);
  reader.begin(kSession);
  for (size_t at = 0; at < bytes.size();) {
    const size_t count = std::min(piece, bytes.size() - at);
    EXPECT_EQ(reader.read(bytes.subspan(at, count), seen.handler()), count);
    at += count;
  }
  return seen;
}

TEST(MessageReader, messagesComeOutHoweverTheBytesAreCut) {
  const std::vector<uint8_t> bytes = someMessages(5);
  for (size_t piece = 1; piece < 100; ++piece) {
    const Seen seen = readAll(bytes, piece);
    EXPECT_EQ(seen.frames, (std::vector<uint32_t>{1, 2, 3, 4, 5}));
    EXPECT_TRUE(seen.problems.empty());
  }
}

TEST(MessageReader, aWrongPayloadLosesOneMessage) {
  std::vector<uint8_t> bytes = someMessages(4);
  bytes[kHeaderBytes + 10 + kHeaderBytes + 3] ^= 1;
  const Seen seen = readAll(bytes, 7);
  EXPECT_EQ(seen.frames, (std::vector<uint32_t>{1, 3, 4}));
  EXPECT_EQ(seen.problems, (std::vector{ErrorCode::kChecksum}));
}

// Wherever bytes are cut out or put in, at most the two messages around the place are lost.
TEST(MessageReader, findsItsPlaceAgain) {
  const std::vector<uint8_t> whole = someMessages(6);
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const int change : {-3, 3}) {
      std::vector<uint8_t> bytes = whole;
      const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      if (change < 0) {
        bytes.erase(place, place + std::min<std::ptrdiff_t>(3, bytes.end() - place));
      } else {
        bytes.insert(place, 3, static_cast<uint8_t>('O'));
      }
      const Seen seen = readAll(bytes, 11);
      EXPECT_GE(seen.frames.size(), 4u) << "at " << at;
    }
  }
}

TEST(MessageReader, aMissingMessageIsNoticed) {
  const std::vector<uint8_t> bytes = someMessages(4);
  std::vector<uint8_t> cut(bytes.begin(), bytes.begin() + kHeaderBytes + 10);
  cut.insert(cut.end(), bytes.begin() + 2 * kHeaderBytes + 30, bytes.end());
  const Seen seen = readAll(cut, 1000);
  EXPECT_EQ(seen.frames, (std::vector<uint32_t>{1, 3, 4}));
  EXPECT_EQ(seen.problems, (std::vector{ErrorCode::kSequence}));
}

TEST(MessageReader, otherSessionsAreLeftOut) {
  std::vector<uint8_t> bytes;
  MessageWriter(kSession - 1).slice(bytes, 1, 0, {0, std::vector<uint8_t>(10)});
  MessageWriter(kSession).slice(bytes, 2, 0, {0, std::vector<uint8_t>(20)});
  const Seen seen = readAll(bytes, 13);
  EXPECT_EQ(seen.frames, (std::vector<uint32_t>{2}));
  EXPECT_TRUE(seen.problems.empty());
}

TEST(MessageReader, aRefusedMessageComesAgainAndNothingIsTakenMeanwhile) {
  const std::vector<uint8_t> bytes = someMessages(3);
  Seen seen;
  seen.refusals = 3;
  MessageReader reader(1000);
  reader.begin(kSession);
  size_t taken = reader.read(bytes, seen.handler());
  EXPECT_EQ(taken, kHeaderBytes + 10);
  EXPECT_EQ(reader.read(std::span(bytes).subspan(taken), seen.handler()), 0u);
  EXPECT_EQ(reader.read({}, seen.handler()), 0u);
  taken += reader.read(std::span(bytes).subspan(taken), seen.handler());
  EXPECT_EQ(taken, bytes.size());
  EXPECT_EQ(seen.frames, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_TRUE(seen.problems.empty());
}

TEST(MessageReader, payloadsBeyondTheLimitAreRefused) {
  std::vector<uint8_t> bytes;
  MessageWriter writer(kSession);
  writer.slice(bytes, 1, 0, {0, std::vector<uint8_t>(1001)});
  writer.slice(bytes, 2, 0, {0, std::vector<uint8_t>(20)});
  const Seen seen = readAll(bytes, 100);
  EXPECT_EQ(seen.frames, (std::vector<uint32_t>{2}));
  ASSERT_FALSE(seen.problems.empty());
  EXPECT_EQ(seen.problems.front(), ErrorCode::kLength);
}

TEST(MessageReader, noiseGivesOneProblemAndNoMessage) {
  std::vector<uint8_t> noise(20000);
  Random random(3);
  for (uint8_t& byte : noise) {
    byte = static_cast<uint8_t>(random.next());
  }
  const Seen seen = readAll(noise, 512);
  EXPECT_TRUE(seen.frames.empty());
  EXPECT_EQ(seen.problems.size(), 1u);
}

}  // namespace
}  // namespace ocelli::wire
