#include "display_driver/firmware/emulated_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "tests/display_driver_firmware/twin_displays.h"

namespace ocelli::test {
namespace {

using Outcome = EmulatedDevice::Outcome;

constexpr uint32_t kSession = 9;

/// A device with a script, a host's stream to it, and the time.
class EmulatedDeviceTest : public testing::Test {
 protected:
  void start(FaultScript faults = {}, double bytesPerSecond = 0) {
    device_.emplace(EmulatedDeviceOptions{{.profile = tinyProfile(6)}, bytesPerSecond, std::move(faults)});
    arm();
  }
  bool arm() {
    sequence_ = 0;
    return device_->controlOut(3, 1, armRecord(kSession), now_);
  }

  void addFrame(uint32_t frame) {
    const auto add = [&](uint8_t type, ByteSpan payload, uint16_t slice = 0) {
      append(stream_, messageBytes({type, 0, slice, kSession, sequence_++, frame}, payload));
    };
    add(kFrameBegin, frameBeginPayload(0, std::vector<bool>(6, true)));
    std::vector<uint32_t> sums;
    for (uint16_t slice = 0; slice < 6; ++slice) {
      const Bytes planes(48, slice == 0 ? static_cast<uint8_t>(frame % 16) : uint8_t{0});
      sums.push_back(checksum(planes));
      add(kSlice, planes, slice);
    }
    add(kFrameEnd, frameEndPayload(6, sums));
  }
  /// Offers what is left of the stream.
  EmulatedDevice::Taken offer() {
    const EmulatedDevice::Taken taken = device_->takeBulk(stream_, now_);
    EXPECT_LE(taken.bytes, stream_.size());
    stream_.erase(stream_.begin(), stream_.begin() + static_cast<std::ptrdiff_t>(taken.bytes));
    return taken;
  }
  struct Counts {
    size_t arrived = 0;
    std::vector<uint16_t> errors;
  };
  Counts counts() {
    Counts counts;
    const Bytes bytes = device_->takeEvents(100000, now_);
    for (size_t at = 0; at < bytes.size(); at += 32) {
      const auto event = eventOf(ByteSpan(bytes).subspan(at, 32));
      counts.arrived += event && event->type == kArrived ? 1 : 0;
      if (event && event->type == kError) {
        counts.errors.push_back(event->code);
      }
    }
    return counts;
  }

  std::optional<EmulatedDevice> device_;
  DeviceMicroseconds now_ = 0;
  uint32_t sequence_ = 0;
  Bytes stream_;
};

constexpr size_t kFrameBytes = 8 * 32 + 9 + 6 * 48 + 8;

TEST_F(EmulatedDeviceTest, withoutFaultsItTakesEverythingAndLosesNothing) {
  start();
  for (uint32_t frame = 1; frame <= 50; ++frame) {
    addFrame(frame);
  }
  EXPECT_EQ(stream_.size(), 50 * kFrameBytes);
  const auto taken = offer();
  EXPECT_EQ(taken.bytes, 50 * kFrameBytes);
  EXPECT_EQ(taken.outcome, Outcome::kGoOn);
  EXPECT_EQ(counts().arrived, 50u);
  EXPECT_TRUE(device_->happened().empty());
  EXPECT_TRUE(device_->quiet());
}

TEST_F(EmulatedDeviceTest, theLinkHasItsRate) {
  constexpr double kRate = 1e6;
  start({}, kRate);
  for (uint32_t frame = 1; frame <= 200; ++frame) {
    addFrame(frame);
  }
  const size_t all = stream_.size();
  size_t taken = 0;
  while (!stream_.empty()) {
    taken += offer().bytes;
    // A link may run ahead by two milliseconds of its rate.
    ASSERT_LE(static_cast<double>(taken), kRate * (static_cast<double>(now_) * 1e-6 + 0.002) + 1);
    now_ += 700;
  }
  EXPECT_EQ(counts().arrived, 200u);
  EXPECT_NEAR(static_cast<double>(now_), static_cast<double>(all) / kRate * 1e6, 3000);
}

TEST_F(EmulatedDeviceTest, aLinkThatIsSlowForAWhile) {
  start({{{.kind = FaultKind::kSlowLink, .at = 10'000, .duration = 100'000, .amount = 10'000}}});
  now_ = 10'000;
  device_->advance(now_);
  now_ = 20'000;
  addFrame(1);
  addFrame(2);
  size_t taken = offer().bytes;
  EXPECT_LE(taken, 512u);
  now_ = 70'000;
  taken += offer().bytes;
  EXPECT_LE(taken, 512u + 512);
  EXPECT_FALSE(device_->quiet());
  now_ = 111'000;
  offer();
  EXPECT_TRUE(stream_.empty());
  EXPECT_TRUE(device_->quiet());
  EXPECT_EQ(counts().arrived, 2u);
}

TEST_F(EmulatedDeviceTest, aStallHaltsThePipeWhereItIsDueUntilItIsCleared) {
  start({{{.kind = FaultKind::kStall, .afterFrames = 2, .afterBytes = 100}}});
  for (uint32_t frame = 1; frame <= 4; ++frame) {
    addFrame(frame);
  }
  size_t bytes = 0;
  EmulatedDevice::Taken taken;
  for (int i = 0; i < 100 && taken.outcome != Outcome::kStall; ++i) {
    taken = offer();
    bytes += taken.bytes;
  }
  EXPECT_EQ(taken.outcome, Outcome::kStall);
  EXPECT_TRUE(device_->halted());
  EXPECT_GE(bytes, kFrameBytes + 100);
  EXPECT_LT(bytes, 2 * kFrameBytes + 100);
  EXPECT_EQ(offer().bytes, 0u);
  device_->clearHalt();
  stream_.clear();
  EXPECT_TRUE(arm());
  addFrame(1);
  counts();
  EXPECT_EQ(offer().outcome, Outcome::kGoOn);
  EXPECT_EQ(counts().arrived, 1u);
  ASSERT_EQ(device_->happened().size(), 1u);
  EXPECT_EQ(device_->happened()[0].fault.kind, FaultKind::kStall);
}

TEST_F(EmulatedDeviceTest, aShortWriteEndsATransferAndNothingIsLost) {
  start({{{.kind = FaultKind::kShortWrite, .afterBytes = 1000}}});
  for (uint32_t frame = 1; frame <= 4; ++frame) {
    addFrame(frame);
  }
  size_t shorts = 0;
  for (int i = 0; i < 100 && !stream_.empty(); ++i) {
    shorts += offer().outcome == Outcome::kShort ? 1 : 0;
  }
  EXPECT_EQ(shorts, 1u);
  EXPECT_TRUE(stream_.empty());
  EXPECT_EQ(counts().arrived, 4u);  // a host that goes on with what is left
}

TEST_F(EmulatedDeviceTest, whatIsUnpluggedTakesNothingAndComesBackAsAfterPowerOn) {
  start({{{.kind = FaultKind::kUnplug, .at = 5'000, .duration = 20'000}}});
  addFrame(1);
  offer();
  addFrame(2);
  now_ = 6'000;
  EXPECT_EQ(offer().bytes, 0u);
  EXPECT_FALSE(device_->pluggedIn());
  EXPECT_TRUE(device_->takeEvents(1000, now_).empty());
  EXPECT_GE(device_->nextChange(now_), now_ + 1);
  EXPECT_LE(device_->nextChange(now_), 26'000);
  now_ = 30'000;
  device_->advance(now_);
  EXPECT_TRUE(device_->pluggedIn());
  const Bytes telemetry = device_->controlIn(4, 0, 64, now_).value();
  EXPECT_EQ(u32(telemetry, 4), 0u);   // no session
  EXPECT_EQ(u32(telemetry, 40), 0u);  // nothing has arrived
  ASSERT_EQ(device_->happened().size(), 1u);
  EXPECT_EQ(device_->happened()[0].begin, 6'000);
  EXPECT_EQ(device_->happened()[0].end, 30'000);
}

TEST_F(EmulatedDeviceTest, aWrongSequenceLosesOneFrame) {
  start({{{.kind = FaultKind::kWrongSequence, .afterBytes = 700}}});
  for (uint32_t frame = 1; frame <= 4; ++frame) {
    addFrame(frame);
  }
  while (!stream_.empty()) {
    offer();
  }
  const Counts seen = counts();
  EXPECT_EQ(seen.arrived, 3u);
  EXPECT_THAT(seen.errors, testing::ElementsAre(2));
}

TEST_F(EmulatedDeviceTest, flippedBitsAreSeen) {
  start({{{.kind = FaultKind::kBitFlips, .afterBytes = 700, .amount = 3}}});
  for (uint32_t frame = 1; frame <= 20; ++frame) {
    addFrame(frame);
  }
  while (!stream_.empty()) {
    offer();
  }
  const Counts seen = counts();
  EXPECT_GE(seen.arrived, 14u);
  EXPECT_LT(seen.arrived, 20u);
  EXPECT_FALSE(seen.errors.empty());
}

TEST_F(EmulatedDeviceTest, phaseDriftTurnsTheScreenOtherwise) {
  start({{{.kind = FaultKind::kPhaseDrift, .at = 100'000, .duration = 2'000'000, .amount = 0.9}}});
  now_ = 2'000'000;
  for (DeviceMicroseconds time = 0; time < now_; time += 1000) {
    device_->advance(time);
  }
  const auto answer =
      device_->controlIn(static_cast<uint8_t>(wire::Request::kTelemetry), 0, wire::kTelemetryBytes, now_);
  const std::optional<wire::DeviceTelemetry> told = wire::telemetryFrom(answer.value());
  ASSERT_TRUE(told);
  EXPECT_EQ(told->state, wire::DeviceState::kSpinningUp);
  EXPECT_FALSE(told->temperatureMillicelsius);  // it has no thermometer
  EXPECT_LT(device_->firmware().rotor().phaseErrorDegrees(), -10);
  EXPECT_FALSE(device_->firmware().rotor().locked());
  for (; now_ < 6'000'000; now_ += 1000) {
    device_->advance(now_);
  }
  EXPECT_TRUE(device_->firmware().rotor().locked());
  EXPECT_TRUE(device_->quiet());
}

TEST_F(EmulatedDeviceTest, fullBuffersTakeNothingForAWhile) {
  start({{{.kind = FaultKind::kFullBuffers, .at = 1'000, .duration = 10'000}}});
  addFrame(1);
  now_ = 2'000;
  const auto taken = offer();
  EXPECT_EQ(taken.bytes, 0u);
  EXPECT_EQ(taken.outcome, Outcome::kGoOn);
  now_ = 13'000;
  offer();
  EXPECT_EQ(counts().arrived, 1u);
}

TEST_F(EmulatedDeviceTest, deafControlFailsAllRequestsForAWhile) {
  start({{{.kind = FaultKind::kDeafControl, .at = 1'000, .duration = 10'000}}});
  now_ = 2'000;
  EXPECT_FALSE(device_->controlIn(1, 0, 64, now_));
  EXPECT_FALSE(arm());
  now_ = 13'000;
  EXPECT_TRUE(device_->controlIn(1, 0, 64, now_));
  EXPECT_TRUE(arm());
}

TEST_F(EmulatedDeviceTest, aFaultTakesEffectOnce) {
  start({{{.kind = FaultKind::kStall, .afterBytes = 100}}});
  for (uint32_t frame = 1; frame <= 4; ++frame) {
    addFrame(frame);
  }
  size_t stalls = 0;
  for (int i = 0; i < 100 && !stream_.empty(); ++i) {
    if (offer().outcome == Outcome::kStall) {
      ++stalls;
      device_->clearHalt();
    }
  }
  EXPECT_EQ(stalls, 1u);
  EXPECT_EQ(counts().arrived, 4u);
}

// Whatever the script does, what is acknowledged is what was sent, and every byte is taken in the end.
TEST_F(EmulatedDeviceTest, randomScripts) {
  class Check : public ArrivalSink {
   public:
    void frameArrived(uint32_t, uint32_t frame, const Volume& volume) override {
      ++arrived;
      EXPECT_EQ(volume.slice(0)[0], frame % 16);
    }
    size_t arrived = 0;
  };
  size_t arrived = 0;
  for (uint64_t seed = 0; seed < 15; ++seed) {
    now_ = 0;
    stream_.clear();
    start(randomFaults(seed, 5, 300'000), seed % 2 == 0 ? 1e6 : 0);
    Check check;
    device_->firmware().setArrivalSink(&check);
    uint32_t frame = 0;
    DeviceMicroseconds stuckSince = 0;
    for (; now_ < 1'000'000; now_ += 1000) {
      if (device_->pluggedIn() && stream_.size() < 2000) {
        addFrame(++frame);
      }
      const auto taken = offer();
      stuckSince = taken.bytes > 0 ? now_ : stuckSince;
      if (taken.outcome == Outcome::kStall) {
        device_->clearHalt();
      }
      // An unplugged device forgets its session; so does a host that sees it.
      if (!device_->pluggedIn()) {
        stream_.clear();
      } else if (const auto telemetry = device_->controlIn(4, 0, 64, now_); telemetry && u32(*telemetry, 4) == 0) {
        stream_.clear();
        arm();
      }
    }
    EXPECT_EQ(device_->happened().size(), 5u) << "seed " << seed;
    EXPECT_TRUE(device_->quiet());
    EXPECT_LT(now_ - stuckSince, 3000) << "seed " << seed;
    arrived += check.arrived;
  }
  EXPECT_GT(arrived, 5000u);
}

}  // namespace
}  // namespace ocelli::test
