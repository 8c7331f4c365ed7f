// Frames: bases, differences, codings, and every way in which a frame can be wrong.
#include <gmock/gmock.h>

#include "tests/display_driver_firmware/firmware_bench.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class FirmwareFrames : public FirmwareBench {
 protected:
  /// An error with this code and the frame 5, and nothing else; then the next frame arrives.
  void expectLost(uint16_t code) {
    EXPECT_THAT(events(), ElementsAre(isError(code, 5)));
    EXPECT_EQ(u16(telemetry(), 56), code);
    slice(5, 5);
    end(5);
    EXPECT_THAT(events(), IsEmpty()) << "of the rest of a lost frame";
    whole(6);
    EXPECT_THAT(events(), ElementsAre(isArrived(6)));
  }
};

TEST_F(FirmwareFrames, aWholeFrameArrivesBitForBit) {
  whole(1);
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
  for (size_t i = 0; i < kSlices; ++i) {
    EXPECT_EQ(arrived_[1].at(i), planes(1, i));
  }
}

TEST_F(FirmwareFrames, theCutOfTheBytesDoesNotMatter) {
  const Bytes bytes = wholeBytes(1);
  for (const uint8_t byte : bytes) {
    send({&byte, 1});
  }
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
}

TEST_F(FirmwareFrames, slicesThatDoNotFollowAreThoseOfTheBase) {
  whole(1);
  begin(2, 1, some({1, 4}));
  slice(2, 4);
  slice(2, 1);
  end(2);
  begin(3, 0, some({2}));
  slice(3, 2);
  end(3);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isArrived(2), isDropped(1), isArrived(3)));
  EXPECT_EQ(arrived_[2], (Slices{planes(1, 0), planes(2, 1), planes(1, 2), planes(1, 3), planes(2, 4), planes(1, 5)}));
  const Bytes dark(slow_.sliceBytes());
  EXPECT_EQ(arrived_[3], (Slices{dark, dark, planes(3, 2), dark, dark, dark}));
}

TEST_F(FirmwareFrames, aFrameOfNoSlicesIsItsBase) {
  whole(1);
  begin(2, 1, some({}));
  end(2);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isArrived(2)));
  EXPECT_EQ(arrived_[2], arrived_[1]);
}

TEST_F(FirmwareFrames, everyCodingGivesTheSlice) {
  whole(1);
  begin(2, 1);
  const auto changed = [&](size_t slice) { return difference(planes(2, slice), planes(1, slice)); };
  sliceWith(2, 0, kRaw, planes(2, 0));
  sliceWith(2, 1, kRunLength, runLengthPayload(planes(2, 1)));
  sliceWith(2, 2, kZstd, zstdPayload(planes(2, 2)));
  sliceWith(2, 3, kRaw | kDifference, changed(3));
  sliceWith(2, 4, kRunLength | kDifference, runLengthPayload(changed(4)));
  sliceWith(2, 5, kZstd | kDifference, zstdPayload(changed(5)));
  end(2);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isArrived(2)));
  for (size_t i = 0; i < kSlices; ++i) {
    EXPECT_EQ(arrived_[2].at(i), planes(2, i)) << i;
  }
}

TEST_F(FirmwareFrames, aFrameThatIsShownIsABase) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({1, 0});
  begin(2, 1, some({0}));
  sliceWith(2, 0, kDifference, difference(planes(2, 0), planes(1, 0)));
  end(2);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0}), isArrived(2)));
  EXPECT_EQ(arrived_[2].at(0), planes(2, 0));
  EXPECT_EQ(arrived_[2].at(1), planes(1, 1));
}

TEST_F(FirmwareFrames, theBaseStaysWhereAnotherFrameIsShownMeanwhile) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({1, 0});
  whole(2);
  present(2, {2, 0});
  begin(3, 1, some({0}));
  turnTo({3, 0});  // 2 took the place of 1
  sliceWith(3, 0, kDifference, difference(planes(3, 0), planes(1, 0)));
  end(3);
  begin(4, 1);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0}), isArrived(2), isShown(2, {2, 0}), isArrived(3),
                                    isError(8, 4)));
  EXPECT_EQ(arrived_[3].at(0), planes(3, 0));
  EXPECT_EQ(arrived_[3].at(1), planes(1, 1));
}

TEST_F(FirmwareFrames, noBase) {
  begin(5, 4);
  EXPECT_THAT(events(), ElementsAre(isError(8, 5)));
}

TEST_F(FirmwareFrames, aFrameThatWasLostIsNoBase) {
  begin(4);
  begin(5, 4);
  EXPECT_THAT(events(), ElementsAre(isError(10, 4), isError(8, 5)));
}

TEST_F(FirmwareFrames, aFrameThatWasDroppedIsNoBase) {
  whole(3);
  whole(4);
  present(4, {}, kAtNextRefresh);
  turnTo({1, 0});
  begin(5, 3);
  EXPECT_THAT(events(), ElementsAre(isArrived(3), isArrived(4), isDropped(3), isShown(4, {1, 0}), isError(8, 5)));
}

TEST_F(FirmwareFrames, aDifferenceOnDarkness) {
  begin(5);
  sliceWith(5, 0, kDifference, planes(5, 0));
  expectLost(8);
}

TEST_F(FirmwareFrames, wrongChecksumOfAPayload) {
  begin(5);
  Bytes bytes = message(kSlice, 5, planes(5, 0), kRaw, 0);
  bytes[40] ^= 1;
  send(bytes);
  expectLost(1);
}

TEST_F(FirmwareFrames, wrongChecksumOfAFrame) {
  begin(5);
  for (size_t i = 0; i < kSlices; ++i) {
    slice(5, i);
  }
  std::swap(sums_[0], sums_[1]);
  end(5);
  expectLost(1);
}

TEST_F(FirmwareFrames, aGapInTheNumbers) {
  begin(5);
  slice(5, 0);
  ++sequence_;
  slice(5, 1);
  expectLost(2);
}

TEST_F(FirmwareFrames, anUnknownType) {
  begin(5);
  send(message(9, 5, {}));
  expectLost(3);
}

TEST_F(FirmwareFrames, impossiblePayloadsOfABegin) {
  const Bytes right = frameBeginPayload(0, some({0, 3}));
  std::vector<Bytes> payloads(6, right);
  payloads[0].pop_back();
  payloads[1].push_back(0);
  payloads[2][4] = kSlices + 1;  // S
  payloads[3][6] = 3;            // how many
  payloads[4][8] |= 1u << kSlices;
  payloads[4][6] = 3;
  payloads[5].clear();
  uint32_t frame = 0;
  for (const Bytes& payload : payloads) {
    send(message(kFrameBegin, ++frame, payload));
    EXPECT_THAT(events(), ElementsAre(isError(4, frame)));
  }
}

TEST_F(FirmwareFrames, impossiblePayloadsOfAnEnd) {
  begin(5);
  send(message(kFrameEnd, 5, Bytes(7)));
  expectLost(4);
}

TEST_F(FirmwareFrames, impossiblePayloadsOfAPresent) {
  for (const Bytes& payload : {Bytes(11), Bytes(13), presentPayload(1, kSlices, 0), presentPayload(1, 0, 8)}) {
    begin(5);
    send(message(kPresent, 5, payload));
    EXPECT_THAT(events(), ElementsAre(isError(4, 5)));
  }
  begin(5);
  send(message(kPresent, 5, presentPayload(1, 60000, kAtNextRefresh)));  // the slice means nothing
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(FirmwareFrames, unknownCodings) {
  for (const uint8_t coding : std::initializer_list<uint8_t>{3, 127}) {
    begin(5);
    sliceWith(5, 0, coding, planes(5, 0));
    EXPECT_THAT(events(), ElementsAre(isError(5, 5)));
  }
}

TEST_F(FirmwareFrames, codingsThatItDoesNotTake) {
  FirmwareOptions options = standard();
  options.capabilities = 0;
  start(options);
  whole(1);
  for (const uint8_t coding : {kRunLength, kZstd, kDifference}) {
    begin(5, 1);
    sliceWith(5, 0, coding, planes(5, 0));
  }
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isError(5, 5), isError(5, 5), isError(5, 5)));
  whole(6);
  EXPECT_THAT(events(), ElementsAre(isArrived(6)));
}

TEST_F(FirmwareFrames, slicesThatDoNotDecode) {
  Bytes padded = planes(5, 0);
  padded[1] = 0x20;  // column 13 of 13
  Bytes shortened = planes(5, 0);
  shortened.pop_back();
  const std::vector<std::pair<uint8_t, Bytes>> wrong = {{kRaw, padded},
                                                        {kRaw, shortened},
                                                        {kRunLength, runLengthPayload(shortened)},
                                                        {kRunLength, {48, 0, 0, 0}},
                                                        {kRunLength, {48}},
                                                        {kRunLength, {}},
                                                        {kZstd, zstdPayload(shortened)},
                                                        {kZstd, planes(5, 0)},
                                                        {kZstd, zstdPayload(padded)}};
  for (const auto& [coding, payload] : wrong) {
    begin(5);
    sliceWith(5, 0, coding, payload);
    EXPECT_THAT(events(), ElementsAre(isError(6, 5)));
  }
}

TEST_F(FirmwareFrames, aDifferenceMayNotLightBitsPastTheWidth) {
  whole(1);
  Bytes changed(slow_.sliceBytes());
  changed[1] = 0x80;
  begin(5, 1);
  sliceWith(5, 0, kDifference, changed);
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isError(6, 5)));
}

TEST_F(FirmwareFrames, slicesThatAreNotAnnouncedOrComeTwiceOrAreNotThere) {
  for (const size_t wrong : {size_t{3}, size_t{1}, kSlices, size_t{65535}}) {
    begin(5, 0, some({1, 2}));
    slice(5, 1);
    sliceWith(5, wrong, kRaw, planes(5, 0));
    EXPECT_THAT(events(), ElementsAre(isError(7, 5)));
  }
}

TEST_F(FirmwareFrames, aSliceOrAnEndWithoutABeginIsReportedOnce) {
  slice(5, 0);
  slice(5, 1);
  end(5);
  EXPECT_THAT(events(), ElementsAre(isError(9, 5)));
  end(6);
  EXPECT_THAT(events(), ElementsAre(isError(9, 6)));
}

TEST_F(FirmwareFrames, aSliceOfAnotherFrame) {
  begin(5);
  sliceWith(7, 0, kRaw, planes(5, 0));
  expectLost(9);
}

TEST_F(FirmwareFrames, aNumberThatIsNotAboveThoseThatArrived) {
  whole(4);
  begin(4);
  begin(3);
  begin(0);
  EXPECT_THAT(events(), ElementsAre(isArrived(4), isError(9, 4), isError(9, 3), isError(9, 0)));
  whole(5);
  EXPECT_THAT(events(), ElementsAre(isArrived(5)));
}

TEST_F(FirmwareFrames, aLostFrameMayComeAgain) {
  begin(5);
  slice(5, 0);
  ++sequence_;
  slice(5, 1);
  whole(5);
  EXPECT_THAT(events(), ElementsAre(isError(2, 5), isArrived(5)));
}

TEST_F(FirmwareFrames, aFrameThatEndsEarly) {
  begin(5);
  slice(5, 0);
  end(5);
  expectLost(10);
}

TEST_F(FirmwareFrames, anEndThatCountsOtherwise) {
  begin(5, 0, some({0}));
  slice(5, 0);
  send(message(kFrameEnd, 5, frameEndPayload(2, sums_)));
  expectLost(10);
}

TEST_F(FirmwareFrames, aFrameThatIsFollowedByAnother) {
  begin(5);
  slice(5, 0);
  whole(6);
  EXPECT_THAT(events(), ElementsAre(isError(10, 5), isArrived(6)));
}

TEST_F(FirmwareFrames, aWrongHeaderLosesThePlaceOnce) {
  begin(5);
  Bytes bytes = message(kSlice, 5, planes(5, 0), kRaw, 0);
  bytes[7] ^= 4;
  send(bytes);
  expectLost(1);
}

TEST_F(FirmwareFrames, aPayloadThatIsTooLongLosesThePlaceOnce) {
  begin(5);
  send(message(kSlice, 5, Bytes(1000, 'O'), kRaw, 0));
  expectLost(4);
}

TEST_F(FirmwareFrames, bytesThatAreMissingLoseThePlaceOnce) {
  for (const size_t left : {1u, 20u, 32u, 33u, 40u}) {
    begin(5);
    const Bytes bytes = message(kSlice, 5, planes(5, 0), kRaw, 0);
    send(ByteSpan(bytes).first(left));
    slice(5, 1);
    end(5);
    whole(6 + static_cast<uint32_t>(left));
    const auto seen = events();
    ASSERT_GE(seen.size(), 2u) << left;
    EXPECT_THAT(seen.front(), isError(1, 5)) << left;
    EXPECT_THAT(seen.back(), isArrived(6 + static_cast<uint32_t>(left))) << left;
    arm(session_ + 1);
  }
}

TEST_F(FirmwareFrames, reservedBytesAreIgnored) {
  begin(5, 0, some({0}));
  slice(5, 0);
  Bytes bytes = message(kFrameEnd, 5, frameEndPayload(1, sums_), 7, 900);
  send(bytes);
  EXPECT_THAT(events(), ElementsAre(isArrived(5)));
}

TEST_F(FirmwareFrames, numbersOfMessagesMayPassTheirLastOne) {
  // As if so many messages had come: after a loss of place the number is taken as it is.
  send(Bytes(40, 1));
  sequence_ = 0xfffffffe;
  whole(5);
  EXPECT_THAT(events(), ElementsAre(isError(1, 0), isArrived(5)));
}

}  // namespace
}  // namespace ocelli::test
