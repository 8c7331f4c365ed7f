#include "display_driver/serial/serial_stream.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

namespace ocelli::serial {
namespace {

using namespace std::chrono_literals;

std::vector<uint8_t> countedBytes(size_t count) {
  std::vector<uint8_t> bytes(count);
  for (size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<uint8_t>((i * 2654435761u) >> 24);
  }
  return bytes;
}

/// Sends over a line that loses one packet in so many, in either direction; 0: none. Returns how long it took.
std::chrono::milliseconds sendOver(size_t oneIn, size_t bytesToSend, uint64_t seed, SerialSender& sender,
                                   uint64_t begin = 0) {
  Random random(seed);
  SerialReceiver receiver(1000, begin);
  const std::vector<uint8_t> all = countedBytes(bytesToSend);
  std::vector<uint8_t> received;
  sender.append(all);
  Time now{};
  const auto arrives = [&] { return oneIn == 0 || random.below(oneIn) != 0; };
  const auto creditTold = [&] {
    if (receiver.hasNews() || now.time_since_epoch() % 100ms == 0ms) {
      const std::vector<uint8_t> content = creditContent(receiver.tell());
      if (arrives()) {
        EXPECT_TRUE(sender.hear(content, now));
      }
    }
  };
  for (; !sender.isIdle() && now.time_since_epoch() < 1h; now += 1ms) {
    creditTold();
    if (const auto packet = sender.next(now); packet && arrives()) {
      EXPECT_TRUE(receiver.take(*packet));
    }
    // It is slower than the line: the limit holds the sender back.
    const size_t use = std::min<size_t>(receiver.bytes().size(), 150);
    EXPECT_LE(receiver.bytes().size(), 1000u);
    received.insert(received.end(), receiver.bytes().begin(), receiver.bytes().begin() + static_cast<long>(use));
    receiver.use(use);
  }
  received.insert(received.end(), receiver.bytes().begin(), receiver.bytes().end());
  EXPECT_EQ(received, all);
  return std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch());
}

TEST(SerialStream, bytesComeInOrderAndNoneTwice) {
  SerialSender sender;
  const auto time = sendOver(0, 50000, 1, sender);
  EXPECT_LE(time, 400ms);  // 150 bytes a millisecond, and some for the end
  EXPECT_EQ(sender.resent(), 0u);
  EXPECT_EQ(sender.taken(), 50000u);
}

TEST(SerialStream, lostPacketsAreSentAgainWhicheverTheyAre) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SerialSender sender;
    sendOver(5, 20000, seed, sender);
    EXPECT_GT(sender.resent(), 0u);
  }
}

TEST(SerialStream, positionsWrapAround) {
  constexpr uint64_t kBegin = (uint64_t{1} << 32) - 5000;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SerialSender sender(kBegin);
    sendOver(5, 20000, seed, sender, kBegin);
    EXPECT_EQ(sender.taken(), kBegin + 20000);
  }
}

TEST(SerialStream, contentsThatCannotBeAreRefused) {
  SerialSender sender;
  EXPECT_FALSE(sender.hear({}, {}));
  EXPECT_FALSE(sender.hear(creditContent({.taken = 7, .limit = 100}), {})) << "nothing was sent";
  EXPECT_TRUE(sender.hear(creditContent({.taken = 0, .limit = 100}), {}));
  SerialReceiver receiver(100);
  EXPECT_FALSE(receiver.take(std::vector<uint8_t>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace ocelli::serial
