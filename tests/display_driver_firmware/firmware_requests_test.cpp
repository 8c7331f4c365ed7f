// Requests and sessions, as docs/wire_protocol.md tells them.
#include <gmock/gmock.h>

#include <string>

#include "tests/display_driver_firmware/firmware_bench.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class FirmwareRequests : public FirmwareBench {};

TEST_F(FirmwareRequests, identifyTellsWhatItIs) {
  FirmwareOptions options = standard();
  options.name = "a display on a bench";
  options.frameBuffers = 4;
  options.capabilities = 1 | 8;
  start(options);
  const Bytes bytes = firmware_->controlIn(1, 0, 64, 0).value();
  ASSERT_EQ(bytes.size(), 64u);
  EXPECT_TRUE(isWholeRecord(bytes));
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "OCLD");
  EXPECT_EQ(u16(bytes, 4), 1);
  EXPECT_EQ(u16(bytes, 6), 0);
  EXPECT_EQ(u32(bytes, 8), 9u);
  EXPECT_EQ(bytes[12], 4);
  EXPECT_GE(u32(bytes, 16), slow_.sliceBytes());
  EXPECT_GE(u32(bytes, 16), 8 + (kSlices + 7) / 8);
  const Bytes profile = firmware_->controlIn(2, 0, 4096, 0).value();
  EXPECT_EQ(u32(bytes, 20), profile.size());
  EXPECT_EQ(u32(bytes, 24), checksum(profile));
  EXPECT_EQ(std::string(bytes.begin() + 32, bytes.begin() + 60), "a display on a bench" + std::string(8, '\0'));
}

TEST_F(FirmwareRequests, theProfileIsJson) {
  const Bytes bytes = firmware_->controlIn(2, 0, 4096, 0).value();
  EXPECT_EQ(profileFromJsonText(std::string(bytes.begin(), bytes.end()), "test"), standard().profile);
}

TEST_F(FirmwareRequests, theLongestPayloadHoldsEveryMessageOfATinyDisplay) {
  FirmwareOptions options = standard();
  options.profile.slicesPerHalfTurn = 4096;
  options.profile.width = 2;
  options.profile.height = 1;
  Firmware firmware(options);
  EXPECT_GE(u32(firmware.controlIn(1, 0, 64, 0).value(), 16), 8u + 4096 / 8);
}

TEST_F(FirmwareRequests, anAnswerIsCutToWhatTheHostAsksFor) {
  EXPECT_EQ(firmware_->controlIn(1, 0, 10, 0)->size(), 10u);
  EXPECT_EQ(firmware_->controlIn(2, 0, 10, 0)->size(), 10u);
}

TEST_F(FirmwareRequests, whatIsNotInTheTableIsStalled) {
  for (const uint8_t request : std::initializer_list<uint8_t>{0, 3, 5, 6, 255}) {
    EXPECT_FALSE(firmware_->controlIn(request, 0, 64, 0)) << int{request};
  }
  for (const uint8_t request : std::initializer_list<uint8_t>{1, 2, 4}) {
    EXPECT_FALSE(firmware_->controlIn(request, 1, 64, 0)) << int{request};
    EXPECT_FALSE(firmware_->controlOut(request, 0, {}, 0)) << int{request};
  }
  const Bytes one(1);
  EXPECT_FALSE(firmware_->controlOut(5, 0, one, 0));
  EXPECT_FALSE(firmware_->controlOut(5, 1, {}, 0));
  EXPECT_FALSE(firmware_->controlOut(6, 0, {}, 0));
  EXPECT_FALSE(firmware_->controlOut(3, 2, armRecord(1), 0));
}

TEST_F(FirmwareRequests, aWrongArmIsStalledAndTheSessionStays) {
  Bytes record = armRecord(77);
  for (size_t bit = 0; bit < 8 * record.size(); ++bit) {
    record[bit / 8] = static_cast<uint8_t>(record[bit / 8] ^ 1u << (bit % 8));
    EXPECT_FALSE(firmware_->controlOut(3, 1, record, 0)) << "bit " << bit;
    record[bit / 8] = static_cast<uint8_t>(record[bit / 8] ^ 1u << (bit % 8));
  }
  EXPECT_FALSE(firmware_->controlOut(3, 1, ByteSpan(record).first(15), 0));
  EXPECT_FALSE(firmware_->controlOut(3, 1, armRecord(0), 0));
  EXPECT_FALSE(firmware_->controlOut(3, 1, armRecord(77, 2), 0));
  EXPECT_EQ(u32(telemetry(), 4), kSession);
  whole(1);
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
}

TEST_F(FirmwareRequests, aHostWithAHigherMinorVersionIsUnderstood) {
  EXPECT_TRUE(firmware_->controlOut(3, 1, armRecord(77, 1, 9), 0));
  EXPECT_EQ(u32(telemetry(), 4), 77u);
}

TEST_F(FirmwareRequests, reservedBytesOfArmAreIgnored) {
  Bytes record = armRecord(77);
  record[9] = 5;
  record.resize(12);
  putChecksum(record);
  EXPECT_TRUE(firmware_->controlOut(3, 1, record, 0));
}

TEST_F(FirmwareRequests, telemetryTellsHowItIs) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({2, 3});
  const Bytes bytes = telemetry();
  ASSERT_EQ(bytes.size(), 64u);
  EXPECT_TRUE(isWholeRecord(bytes));
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "OCLT");
  EXPECT_EQ(u32(bytes, 4), kSession);
  EXPECT_EQ(u64(bytes, 8), static_cast<uint64_t>(now_));
  EXPECT_EQ(u64(bytes, 16), 2u);
  EXPECT_NEAR(u32(bytes, 24) * 0x1p-32, 0.5, 1e-3);  // a microsecond of 42 ms
  EXPECT_NEAR(u32(bytes, 28), 1e9 / standard().profile.refreshHertz(), 1);
  EXPECT_EQ(u32(bytes, 40), 1u);
  EXPECT_EQ(u32(bytes, 44), 1u);
  EXPECT_EQ(u32(bytes, 48), 0u);
  EXPECT_EQ(u32(bytes, 52), 0u);
  EXPECT_EQ(u16(bytes, 56), 0u);
  EXPECT_EQ(bytes[58], 1);
}

TEST_F(FirmwareRequests, telemetryCountsRefreshesThatShowedAnOldFrame) {
  begin(1);
  present(1, {1, 0});
  turnTo({3, 2});
  for (size_t i = 0; i < kSlices; ++i) {
    slice(1, i);
  }
  end(1);
  turnTo({4, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {4, 0}, kLate)));
  EXPECT_EQ(u32(telemetry(), 52), 3u);  // those with the numbers 1, 2 and 3
}

TEST_F(FirmwareRequests, theScreenIsIdleWithoutASession) {
  ASSERT_TRUE(firmware_->controlOut(3, 0, armRecord(0), 0));
  EXPECT_EQ(u32(telemetry(), 4), 0u);
  EXPECT_EQ(telemetry()[58], 0);
}

TEST_F(FirmwareRequests, aNewSessionForgetsFramesEventsAndTheRestOfTheStream) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  begin(2);
  slice(2, 0);
  const Bytes half = message(kSlice, 2, planes(2, 1), kRaw, 1);
  send(ByteSpan(half).first(40));
  arm(99);
  EXPECT_THAT(events(), IsEmpty());
  turnTo({2, 0});
  EXPECT_THAT(events(), IsEmpty());
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {3, 0})));
}

TEST_F(FirmwareRequests, whatIsShownStaysButIsNoBaseInANewSession) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({1, 0});
  arm(99);
  turnTo({3, 0});
  EXPECT_EQ(image(2)[4], (std::pair<uint32_t, size_t>(1, 5)));
  begin(2, 1);
  EXPECT_THAT(events(), ElementsAre(isError(8, 2)));
}

TEST_F(FirmwareRequests, messagesOfTheSessionBeforeArePassedOver) {
  const Bytes old = message(kFrameBegin, 1, frameBeginPayload(0, all()));
  arm(99);
  send(old);
  whole(1);
  send(old);
  whole(2);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isArrived(2)));
}

TEST_F(FirmwareRequests, withoutASessionTheStreamIsThrownAway) {
  ASSERT_TRUE(firmware_->controlOut(3, 0, armRecord(0), 0));
  session_ = 0;
  whole(1);
  send(Bytes(1000, 0x4f));
  EXPECT_THAT(events(), IsEmpty());
  arm(5);
  whole(1);
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
}

TEST_F(FirmwareRequests, resetForgetsEverythingAndShowsDarkness) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({2, 3});
  begin(2, 77);  // an error
  ASSERT_TRUE(firmware_->controlOut(5, 0, {}, now_));
  session_ = 0;
  EXPECT_THAT(events(), IsEmpty());
  const Bytes bytes = telemetry();
  EXPECT_EQ(u32(bytes, 4), 0u);
  EXPECT_EQ(u64(bytes, 16), 2u);  // refreshes are counted on
  for (const size_t counter : {40u, 44u, 48u, 52u}) {
    EXPECT_EQ(u32(bytes, counter), 0u) << counter;
  }
  EXPECT_EQ(u16(bytes, 56), 0u);
  turnTo({4, 0});
  EXPECT_EQ(image(2)[2].first, 1u);
  EXPECT_EQ(image(2)[3].first, 0u);
  EXPECT_EQ(images_[3], Slices(kSlices, Bytes(slow_.sliceBytes())));
}

TEST_F(FirmwareRequests, atLeast64EventsAreKept) {
  for (uint32_t frame = 1; frame <= 64; ++frame) {
    begin(frame, 1000);
  }
  EXPECT_EQ(events().size(), 64u);
}

TEST_F(FirmwareRequests, eventsComeWhole) {
  begin(1, 1000);
  begin(2, 1000);
  EXPECT_TRUE(firmware_->takeEvents(31).empty());
  EXPECT_EQ(firmware_->takeEvents(63).size(), 32u);
  EXPECT_THAT(events(), ElementsAre(isError(8, 2)));
}

}  // namespace
}  // namespace ocelli::test
