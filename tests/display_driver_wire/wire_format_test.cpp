#include "display_driver/wire/wire_format.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace ocelli::wire {
namespace {

std::span<const uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Any one wrong bit must be seen where there is a checksum.
template <class From>
void expectEveryBitCounts(std::vector<uint8_t> bytes, From&& from) {
  for (size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1u << (bit % 8)));
    EXPECT_FALSE(from(bytes)) << "bit " << bit;
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1u << (bit % 8)));
  }
  EXPECT_TRUE(from(bytes));
}

// The check value of CRC-32C, and the first three examples of RFC 3720, appendix B.4.
TEST(WireFormat, checksumIsThatOfTheStandard) {
  EXPECT_EQ(crc32c(bytesOf("123456789")), 0xe3069283u);
  const std::vector<uint8_t> zeros(32, 0);
  const std::vector<uint8_t> ones(32, 0xff);
  std::vector<uint8_t> rising(32);
  for (size_t i = 0; i < rising.size(); ++i) {
    rising[i] = static_cast<uint8_t>(i);
  }
  EXPECT_EQ(crc32c(zeros), 0x8a9136aau);
  EXPECT_EQ(crc32c(ones), 0x62a8ab43u);
  EXPECT_EQ(crc32c(rising), 0x46dd794eu);
  EXPECT_EQ(crc32c({}), 0u);
}

TEST(WireFormat, checksumGoesOnOverPieces) {
  EXPECT_EQ(crc32c(bytesOf("56789"), crc32c(bytesOf("1234"))), 0xe3069283u);
}

TEST(WireFormat, identityComesBack) {
  const Identity identity{.capabilities = kCanZstd | kCanDelta,
                          .frameBuffers = 3,
                          .maxPayloadBytes = 221184,
                          .profileBytes = 300,
                          .profileChecksum = 0x12345678,
                          .name = "a display"};
  const std::vector<uint8_t> bytes = toBytes(identity);
  ASSERT_EQ(bytes.size(), kIdentityBytes);
  EXPECT_EQ(identityFrom(bytes), identity);
  expectEveryBitCounts(bytes, [](const auto& some) { return identityFrom(some).has_value(); });
  EXPECT_FALSE(identityFrom(std::span(bytes).first(63)));
}

TEST(WireFormat, longNamesAreCut) {
  const std::optional<Identity> identity = identityFrom(toBytes(Identity{.name = std::string(100, 'n')}));
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->name, std::string(kNameBytes, 'n'));
}

TEST(WireFormat, telemetryComesBack) {
  DeviceTelemetry telemetry{.session = 7,
                            .timeMicroseconds = uint64_t{1} << 40,
                            .refresh = uint64_t{1} << 33,
                            .refreshShare = 0x80000000,
                            .refreshNanoseconds = 41666667,
                            .phaseErrorMicrodegrees = -1500,
                            .temperatureMillicelsius = -12500,
                            .framesArrived = 5,
                            .framesShown = 4,
                            .framesDropped = 1,
                            .underruns = 2,
                            .lastError = ErrorCode::kNoBase,
                            .state = DeviceState::kArmed};
  EXPECT_EQ(telemetryFrom(toBytes(telemetry)), telemetry);
  expectEveryBitCounts(toBytes(telemetry), [](const auto& some) { return telemetryFrom(some).has_value(); });
  telemetry.temperatureMillicelsius.reset();
  EXPECT_EQ(telemetryFrom(toBytes(telemetry)), telemetry);
}

TEST(WireFormat, headersComeBack) {
  const MessageHeader header{.type = MessageType::kSlice,
                             .coding = static_cast<uint8_t>(static_cast<uint8_t>(Coding::kZstd) | kDeltaFlag),
                             .slice = 197,
                             .session = 0xdeadbeef,
                             .sequence = 12,
                             .frame = 3,
                             .payloadBytes = 1000,
                             .payloadChecksum = 0x01020304};
  const auto bytes = toBytes(header);
  EXPECT_EQ(headerFrom(bytes), header);
  expectEveryBitCounts({bytes.begin(), bytes.end()}, [](const auto& some) { return headerFrom(some).has_value(); });
}

// The example of docs/wire_protocol.md: a firmware author compares with these bytes.
TEST(WireFormat, aHeaderHasTheBytesThatTheDocumentShows) {
  const auto bytes = toBytes(MessageHeader{.type = MessageType::kPresent,
                                           .session = 0x11223344,
                                           .sequence = 5,
                                           .frame = 6,
                                           .payloadBytes = 12,
                                           .payloadChecksum = crc32c(toBytes(Present{.refresh = 1000, .slice = 3}))});
  std::string text;
  for (const uint8_t byte : bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  EXPECT_EQ(text, "4f434c4d040000004433221105000000060000000c0000005595e4e4ab4a303c");
}

TEST(WireFormat, frameBeginComesBackAndItsCountsMustAgree) {
  FrameBegin begin{.base = 4, .records = std::vector<bool>(11)};
  begin.records[0] = begin.records[7] = begin.records[8] = true;
  std::vector<uint8_t> bytes = toBytes(begin);
  ASSERT_EQ(bytes.size(), frameBeginBytes(11));
  const std::optional<FrameBegin> back = frameBeginFrom(bytes, 11);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->base, begin.base);
  EXPECT_EQ(back->records, begin.records);
  EXPECT_FALSE(frameBeginFrom(bytes, 12));
  bytes[6] = 2;
  EXPECT_FALSE(frameBeginFrom(bytes, 11));  // three bits are set
  bytes[6] = 4;
  bytes[9] |= 0x80;
  EXPECT_FALSE(frameBeginFrom(bytes, 11));  // a slice that there is not
}

TEST(WireFormat, presentComesBackAndUnknownFlagsAreRefused) {
  for (int flags = 0; flags < 8; ++flags) {
    const Present present{.refresh = uint64_t{1} << 50,
                          .slice = 77,
                          .atNextRefresh = (flags & 1) != 0,
                          .tearWhenLate = (flags & 2) != 0,
                          .coarseWhenLate = (flags & 4) != 0};
    EXPECT_EQ(presentFrom(toBytes(present)), present);
  }
  auto bytes = toBytes(Present{});
  bytes[10] = 8;
  EXPECT_FALSE(presentFrom(bytes));
}

TEST(WireFormat, eventsComeBack) {
  const Event event{.type = EventType::kShown,
                    .flags = kEventLate | kEventTorn,
                    .code = 12,
                    .session = 9,
                    .frame = 8,
                    .timeMicroseconds = uint64_t{1} << 45,
                    .refresh = 77};
  const auto bytes = toBytes(event);
  EXPECT_EQ(eventFrom(bytes), event);
  expectEveryBitCounts({bytes.begin(), bytes.end()}, [](const auto& some) { return eventFrom(some).has_value(); });
}

TEST(WireFormat, armComesBack) {
  const std::optional<Arm> arm = armFrom(toBytes(Arm{.session = 99}));
  ASSERT_TRUE(arm);
  EXPECT_EQ(arm->session, 99u);
  EXPECT_EQ(arm->majorVersion, kMajorVersion);
  expectEveryBitCounts(toBytes(Arm{.session = 99}), [](const auto& some) { return armFrom(some).has_value(); });
}

}  // namespace
}  // namespace ocelli::wire
