#include "display_driver/wire/wire_format.h"

#include <algorithm>
#include <cstring>

#include "oc_core/base/check.h"
#include "oc_core/checksum/crc32c.h"

namespace ocelli::wire {
namespace {

using Mark = std::array<uint8_t, 4>;
constexpr Mark kIdentityMark = {'O', 'C', 'L', 'D'};
constexpr Mark kTelemetryMark = {'O', 'C', 'L', 'T'};
constexpr Mark kEventMark = {'O', 'C', 'L', 'E'};
constexpr uint32_t kUnknownTemperature = 0x80000000;
constexpr uint16_t kAtNextRefreshFlag = 1;
constexpr uint16_t kTearFlag = 2;
constexpr uint16_t kCoarseFlag = 4;
constexpr uint16_t kPresentFlags = kAtNextRefreshFlag | kTearFlag | kCoarseFlag;

/// Appends little-endian numbers to bytes of a fixed size.
class Writer {
 public:
  explicit Writer(std::span<uint8_t> bytes) : bytes_(bytes) {}

  void mark(const Mark& mark) { put(mark); }
  void u8(uint8_t value) { number(value, 1); }
  void u16(uint16_t value) { number(value, 2); }
  void u32(uint32_t value) { number(value, 4); }
  void u64(uint64_t value) { number(value, 8); }
  void put(std::span<const uint8_t> some) {
    OC_CHECK(at_ + some.size() <= bytes_.size(), "a record is larger than its size");
    std::ranges::copy(some, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ += some.size();
  }
  void skip(size_t count) { at_ += count; }
  /// The CRC of all that stands before it: always the last field.
  void checksum() {
    u32(crc32c(bytes_.first(at_)));
    OC_CHECK(at_ == bytes_.size(), "a record has another size");
  }

 private:
  void number(uint64_t value, size_t count) {
    OC_CHECK(at_ + count <= bytes_.size(), "a record is larger than its size");
    for (size_t i = 0; i < count; ++i) {
      bytes_[at_ + i] = static_cast<uint8_t>(value >> (8 * i));
    }
    at_ += count;
  }

  std::span<uint8_t> bytes_;
  size_t at_ = 0;
};

class Reader {
 public:
  explicit Reader(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  bool mark(const Mark& mark) { return std::ranges::equal(take(mark.size()), mark); }
  uint8_t u8() { return static_cast<uint8_t>(number(1)); }
  uint16_t u16() { return static_cast<uint16_t>(number(2)); }
  uint32_t u32() { return static_cast<uint32_t>(number(4)); }
  uint64_t u64() { return number(8); }
  std::span<const uint8_t> take(size_t count) {
    OC_CHECK(at_ + count <= bytes_.size(), "a record was not checked for its size");
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

 private:
  uint64_t number(size_t count) {
    uint64_t value = 0;
    const std::span<const uint8_t> some = take(count);
    for (size_t i = 0; i < count; ++i) {
      value |= static_cast<uint64_t>(some[i]) << (8 * i);
    }
    return value;
  }

  std::span<const uint8_t> bytes_;
  size_t at_ = 0;
};

/// Of records whose last field is the CRC of the others.
bool isWhole(std::span<const uint8_t> bytes, size_t size) {
  return bytes.size() == size && Reader(bytes.subspan(size - 4)).u32() == crc32c(bytes.first(size - 4));
}

}  // namespace

uint32_t crc32c(std::span<const uint8_t> bytes, uint32_t before) {
  return ocelli::crc32c(bytes, before);
}

uint32_t crc32cOfNumber(uint32_t number, uint32_t before) {
  std::array<uint8_t, 4> bytes{};
  Writer(bytes).u32(number);
  return crc32c(bytes, before);
}

const char* nameOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNone:
      return "no error";
    case ErrorCode::kChecksum:
      return "a checksum was wrong";
    case ErrorCode::kSequence:
      return "a message was missing";
    case ErrorCode::kUnknownType:
      return "a message of an unknown type";
    case ErrorCode::kLength:
      return "a payload of an impossible length";
    case ErrorCode::kUnknownCoding:
      return "a slice in an unknown coding";
    case ErrorCode::kContent:
      return "a slice that could not be decoded";
    case ErrorCode::kSlice:
      return "a slice that was not due";
    case ErrorCode::kNoBase:
      return "the base frame was not there";
    case ErrorCode::kOutOfPlace:
      return "a message out of place";
    case ErrorCode::kIncomplete:
      return "the frame ended early";
    case ErrorCode::kNotLocked:
      return "the rotation is not locked";
    case ErrorCode::kTooHot:
      return "the display is too hot";
    case ErrorCode::kInternal:
      return "an error inside the display";
  }
  return "an error unknown to protocol 1.0";
}

std::vector<uint8_t> toBytes(const Identity& identity) {
  std::vector<uint8_t> bytes(kIdentityBytes);
  Writer writer(bytes);
  writer.mark(kIdentityMark);
  writer.u16(identity.majorVersion);
  writer.u16(identity.minorVersion);
  writer.u32(identity.capabilities);
  writer.u8(identity.frameBuffers);
  writer.skip(3);
  writer.u32(identity.maxPayloadBytes);
  writer.u32(identity.profileBytes);
  writer.u32(identity.profileChecksum);
  writer.skip(4);
  const size_t length = std::min(identity.name.size(), kNameBytes);
  writer.put({reinterpret_cast<const uint8_t*>(identity.name.data()), length});
  writer.skip(kNameBytes - length);
  writer.checksum();
  return bytes;
}

std::optional<Identity> identityFrom(std::span<const uint8_t> bytes) {
  if (!isWhole(bytes, kIdentityBytes)) {
    return std::nullopt;
  }
  Reader reader(bytes);
  if (!reader.mark(kIdentityMark)) {
    return std::nullopt;
  }
  Identity identity;
  identity.majorVersion = reader.u16();
  identity.minorVersion = reader.u16();
  identity.capabilities = reader.u32();
  identity.frameBuffers = reader.u8();
  reader.take(3);
  identity.maxPayloadBytes = reader.u32();
  identity.profileBytes = reader.u32();
  identity.profileChecksum = reader.u32();
  reader.take(4);
  const std::span<const uint8_t> name = reader.take(kNameBytes);
  identity.name.assign(name.begin(), std::ranges::find(name, uint8_t{0}));
  return identity;
}

std::vector<uint8_t> toBytes(const Arm& arm) {
  std::vector<uint8_t> bytes(kArmBytes);
  Writer writer(bytes);
  writer.u32(arm.session);
  writer.u16(arm.majorVersion);
  writer.u16(arm.minorVersion);
  writer.skip(4);
  writer.checksum();
  return bytes;
}

std::optional<Arm> armFrom(std::span<const uint8_t> bytes) {
  if (!isWhole(bytes, kArmBytes)) {
    return std::nullopt;
  }
  Reader reader(bytes);
  Arm arm;
  arm.session = reader.u32();
  arm.majorVersion = reader.u16();
  arm.minorVersion = reader.u16();
  return arm;
}

std::vector<uint8_t> toBytes(const DeviceTelemetry& telemetry) {
  std::vector<uint8_t> bytes(kTelemetryBytes);
  Writer writer(bytes);
  writer.mark(kTelemetryMark);
  writer.u32(telemetry.session);
  writer.u64(telemetry.timeMicroseconds);
  writer.u64(telemetry.refresh);
  writer.u32(telemetry.refreshShare);
  writer.u32(telemetry.refreshNanoseconds);
  writer.u32(static_cast<uint32_t>(telemetry.phaseErrorMicrodegrees));
  writer.u32(telemetry.temperatureMillicelsius ? static_cast<uint32_t>(*telemetry.temperatureMillicelsius)
                                               : kUnknownTemperature);
  writer.u32(telemetry.framesArrived);
  writer.u32(telemetry.framesShown);
  writer.u32(telemetry.framesDropped);
  writer.u32(telemetry.underruns);
  writer.u16(static_cast<uint16_t>(telemetry.lastError));
  writer.u8(static_cast<uint8_t>(telemetry.state));
  writer.skip(1);
  writer.checksum();
  return bytes;
}

std::optional<DeviceTelemetry> telemetryFrom(std::span<const uint8_t> bytes) {
  if (!isWhole(bytes, kTelemetryBytes)) {
    return std::nullopt;
  }
  Reader reader(bytes);
  if (!reader.mark(kTelemetryMark)) {
    return std::nullopt;
  }
  DeviceTelemetry telemetry;
  telemetry.session = reader.u32();
  telemetry.timeMicroseconds = reader.u64();
  telemetry.refresh = reader.u64();
  telemetry.refreshShare = reader.u32();
  telemetry.refreshNanoseconds = reader.u32();
  telemetry.phaseErrorMicrodegrees = static_cast<int32_t>(reader.u32());
  const uint32_t temperature = reader.u32();
  if (temperature != kUnknownTemperature) {
    telemetry.temperatureMillicelsius = static_cast<int32_t>(temperature);
  }
  telemetry.framesArrived = reader.u32();
  telemetry.framesShown = reader.u32();
  telemetry.framesDropped = reader.u32();
  telemetry.underruns = reader.u32();
  telemetry.lastError = static_cast<ErrorCode>(reader.u16());
  telemetry.state = static_cast<DeviceState>(reader.u8());
  return telemetry;
}

std::array<uint8_t, kHeaderBytes> toBytes(const MessageHeader& header) {
  std::array<uint8_t, kHeaderBytes> bytes{};
  Writer writer(bytes);
  writer.mark(kMessageMark);
  writer.u8(static_cast<uint8_t>(header.type));
  writer.u8(header.coding);
  writer.u16(header.slice);
  writer.u32(header.session);
  writer.u32(header.sequence);
  writer.u32(header.frame);
  writer.u32(header.payloadBytes);
  writer.u32(header.payloadChecksum);
  writer.checksum();
  return bytes;
}

std::optional<MessageHeader> headerFrom(std::span<const uint8_t> bytes) {
  OC_CHECK(bytes.size() == kHeaderBytes, "a header of another size");
  Reader reader(bytes);
  if (!reader.mark(kMessageMark) || !isWhole(bytes, kHeaderBytes)) {
    return std::nullopt;
  }
  MessageHeader header;
  header.type = static_cast<MessageType>(reader.u8());
  header.coding = reader.u8();
  header.slice = reader.u16();
  header.session = reader.u32();
  header.sequence = reader.u32();
  header.frame = reader.u32();
  header.payloadBytes = reader.u32();
  header.payloadChecksum = reader.u32();
  return header;
}

bool isKnown(MessageType type) {
  switch (type) {
    case MessageType::kFrameBegin:
    case MessageType::kSlice:
    case MessageType::kFrameEnd:
    case MessageType::kPresent:
      return true;
  }
  return false;
}

size_t frameBeginBytes(size_t slices) {
  return 8 + (slices + 7) / 8;
}

std::vector<uint8_t> toBytes(const FrameBegin& begin) {
  std::vector<uint8_t> bytes(frameBeginBytes(begin.records.size()));
  Writer writer(bytes);
  writer.u32(begin.base);
  writer.u16(static_cast<uint16_t>(begin.records.size()));
  writer.u16(static_cast<uint16_t>(std::ranges::count(begin.records, true)));
  for (size_t i = 0; i < begin.records.size(); ++i) {
    bytes[8 + i / 8] = static_cast<uint8_t>(bytes[8 + i / 8] | (begin.records[i] ? 1u << (i % 8) : 0u));
  }
  return bytes;
}

std::optional<FrameBegin> frameBeginFrom(std::span<const uint8_t> payload, size_t slices) {
  if (payload.size() != frameBeginBytes(slices)) {
    return std::nullopt;
  }
  Reader reader(payload);
  FrameBegin begin;
  begin.base = reader.u32();
  const size_t count = reader.u16();
  const auto records = static_cast<std::ptrdiff_t>(reader.u16());
  if (count != slices) {
    return std::nullopt;
  }
  const auto bitAt = [&](size_t i) { return (payload[8 + i / 8] >> (i % 8) & 1) != 0; };
  begin.records.resize(slices);
  for (size_t i = 0; i < slices; ++i) {
    begin.records[i] = bitAt(i);
  }
  for (size_t i = slices; i < 8 * (payload.size() - 8); ++i) {
    if (bitAt(i)) {
      return std::nullopt;
    }
  }
  return std::ranges::count(begin.records, true) == records ? std::optional(begin) : std::nullopt;
}

std::array<uint8_t, kFrameEndBytes> toBytes(const FrameEnd& end) {
  std::array<uint8_t, kFrameEndBytes> bytes{};
  Writer writer(bytes);
  writer.u32(end.records);
  writer.u32(end.checksum);
  return bytes;
}

std::optional<FrameEnd> frameEndFrom(std::span<const uint8_t> payload) {
  if (payload.size() != kFrameEndBytes) {
    return std::nullopt;
  }
  Reader reader(payload);
  FrameEnd end;
  end.records = reader.u32();
  end.checksum = reader.u32();
  return end;
}

std::array<uint8_t, kPresentBytes> toBytes(const Present& present) {
  std::array<uint8_t, kPresentBytes> bytes{};
  Writer writer(bytes);
  writer.u64(present.refresh);
  writer.u16(present.slice);
  writer.u16(static_cast<uint16_t>((present.atNextRefresh ? kAtNextRefreshFlag : 0) |
                                   (present.tearWhenLate ? kTearFlag : 0) |
                                   (present.coarseWhenLate ? kCoarseFlag : 0)));
  return bytes;
}

std::optional<Present> presentFrom(std::span<const uint8_t> payload) {
  if (payload.size() != kPresentBytes) {
    return std::nullopt;
  }
  Reader reader(payload);
  Present present;
  present.refresh = reader.u64();
  present.slice = reader.u16();
  const uint16_t flags = reader.u16();
  present.atNextRefresh = (flags & kAtNextRefreshFlag) != 0;
  present.tearWhenLate = (flags & kTearFlag) != 0;
  present.coarseWhenLate = (flags & kCoarseFlag) != 0;
  return (flags & ~kPresentFlags) == 0 ? std::optional(present) : std::nullopt;
}

std::array<uint8_t, kEventBytes> toBytes(const Event& event) {
  std::array<uint8_t, kEventBytes> bytes{};
  Writer writer(bytes);
  writer.mark(kEventMark);
  writer.u8(static_cast<uint8_t>(event.type));
  writer.u8(event.flags);
  writer.u16(event.code);
  writer.u32(event.session);
  writer.u32(event.frame);
  writer.u64(event.timeMicroseconds);
  writer.u32(event.refresh);
  writer.checksum();
  return bytes;
}

std::optional<Event> eventFrom(std::span<const uint8_t> bytes) {
  if (!isWhole(bytes, kEventBytes)) {
    return std::nullopt;
  }
  Reader reader(bytes);
  if (!reader.mark(kEventMark)) {
    return std::nullopt;
  }
  Event event;
  event.type = static_cast<EventType>(reader.u8());
  event.flags = reader.u8();
  event.code = reader.u16();
  event.session = reader.u32();
  event.frame = reader.u32();
  event.timeMicroseconds = reader.u64();
  event.refresh = reader.u32();
  return event;
}

}  // namespace ocelli::wire
