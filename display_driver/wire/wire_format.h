// The bytes of the wire protocol 1.0 as both sides and their tests share them (docs/wire_protocol.md says all of it).
// All numbers are little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ocelli::wire {

inline constexpr uint16_t kMajorVersion = 1;
inline constexpr uint16_t kMinorVersion = 0;

/// How a host finds displays: by these of their interface.
inline constexpr uint8_t kInterfaceClass = 0xff;
inline constexpr uint8_t kInterfaceSubclass = 0x4f;
inline constexpr uint8_t kInterfaceProtocol = 0x01;

/// Vendor requests to the interface.
enum class Request : uint8_t {
  kIdentify = 1,   ///< in, kIdentityBytes
  kProfile = 2,    ///< in, the display profile as JSON
  kArm = 3,        ///< out, kArmBytes: value 1 begins a session, value 0 ends it
  kTelemetry = 4,  ///< in, kTelemetryBytes
  kReset = 5,      ///< out, nothing: forget everything that came, session and faults
};

/// Of the bulk stream to the device.
enum class MessageType : uint8_t {
  kFrameBegin = 1,
  kSlice = 2,
  kFrameEnd = 3,
  kPresent = 4,
};

/// How the payload of a slice holds its bit planes.
enum class Coding : uint8_t {
  kRaw = 0,
  kRunLength = 1,
  kZstd = 2,
};
/// Added to the coding: the content is the XOR of the slice and that of the base frame.
inline constexpr uint8_t kDeltaFlag = 0x80;

/// Of IDENTIFY. Raw slices every device takes.
inline constexpr uint32_t kCanRunLength = 1;
inline constexpr uint32_t kCanZstd = 2;
inline constexpr uint32_t kCanDelta = 4;
inline constexpr uint32_t kCanCoarse = 8;       ///< shows a frame of which a part has come
inline constexpr uint32_t kCanAnyPhase = 0x10;  ///< changes frames at any slice, not just at slice 0

/// Of the event stream to the host.
enum class EventType : uint8_t {
  kArrived = 1,  ///< the frame is whole and right: it is acknowledged
  kShown = 2,    ///< its first slice is being shown
  kDropped = 3,  ///< it was whole, but a newer one took its place before it was shown
  kError = 4,    ///< `code` is an ErrorCode; the frame, if any, is lost
};
inline constexpr uint8_t kEventLate = 1;    ///< shown after its phase
inline constexpr uint8_t kEventCoarse = 2;  ///< shown in part
inline constexpr uint8_t kEventTorn = 4;    ///< shown from the middle of a refresh on

enum class ErrorCode : uint16_t {
  kNone = 0,
  kChecksum = 1,  ///< of a message or its payload
  kSequence = 2,  ///< a message is missing
  kUnknownType = 3,
  kLength = 4,  ///< of a payload: not possible for its message
  kUnknownCoding = 5,
  kContent = 6,      ///< a payload does not decode to a slice
  kSlice = 7,        ///< no such slice, not announced, or sent twice
  kNoBase = 8,       ///< the base frame is not there
  kOutOfPlace = 9,   ///< a message that cannot come here
  kIncomplete = 10,  ///< a frame ended before all of its slices had come
  kNotLocked = 11,   ///< the rotation is not locked
  kTooHot = 12,
  kInternal = 13,
};
const char* nameOf(ErrorCode code);

inline constexpr size_t kIdentityBytes = 64;
inline constexpr size_t kArmBytes = 16;
inline constexpr size_t kTelemetryBytes = 64;
inline constexpr size_t kEventBytes = 32;
inline constexpr size_t kHeaderBytes = 32;
inline constexpr size_t kFrameEndBytes = 8;
inline constexpr size_t kPresentBytes = 12;
inline constexpr size_t kMaxProfileBytes = 4096;
inline constexpr size_t kNameBytes = 28;
inline constexpr std::array<uint8_t, 4> kMessageMark = {'O', 'C', 'L', 'M'};

/// CRC-32C (Castagnoli, RFC 3720) of bytes that follow others with the checksum `before`.
uint32_t crc32c(std::span<const uint8_t> bytes, uint32_t before = 0);
/// The same of a number, as its 4 bytes: FRAME_END has that of the payloads' checksums.
uint32_t crc32cOfNumber(uint32_t number, uint32_t before);

struct Identity {
  uint16_t majorVersion = kMajorVersion;
  uint16_t minorVersion = kMinorVersion;
  uint32_t capabilities = 0;
  uint8_t frameBuffers = 2;
  uint32_t maxPayloadBytes = 0;  ///< of a slice message
  uint32_t profileBytes = 0;
  uint32_t profileChecksum = 0;
  std::string name;  ///< at most kNameBytes of UTF-8

  bool operator==(const Identity&) const = default;
};

struct Arm {
  uint32_t session = 0;  ///< not 0, and another one each time
  uint16_t majorVersion = kMajorVersion;
  uint16_t minorVersion = kMinorVersion;
};

enum class DeviceState : uint8_t {
  kIdle = 0,
  kArmed = 1,
  kSpinningUp = 2,
  kFault = 3,
};

struct DeviceTelemetry {
  uint32_t session = 0;  ///< 0: none
  uint64_t timeMicroseconds = 0;
  uint64_t refresh = 0;
  uint32_t refreshShare = 0;  ///< of the refresh that has passed, in 2^-32
  uint32_t refreshNanoseconds = 0;
  int32_t phaseErrorMicrodegrees = 0;
  std::optional<int32_t> temperatureMillicelsius;
  uint32_t framesArrived = 0;
  uint32_t framesShown = 0;
  uint32_t framesDropped = 0;
  uint32_t underruns = 0;
  ErrorCode lastError = ErrorCode::kNone;
  DeviceState state = DeviceState::kIdle;

  bool operator==(const DeviceTelemetry&) const = default;
};

struct MessageHeader {
  MessageType type = MessageType::kFrameBegin;
  uint8_t coding = 0;  ///< of slices: a Coding, perhaps with kDeltaFlag
  uint16_t slice = 0;  ///< of slices
  uint32_t session = 0;
  uint32_t sequence = 0;  ///< counts the messages of a session from 0
  uint32_t frame = 0;
  uint32_t payloadBytes = 0;
  uint32_t payloadChecksum = 0;

  bool operator==(const MessageHeader&) const = default;
};

struct FrameBegin {
  uint32_t base = 0;  ///< the frame that slices without a record are taken from, and deltas refer to; 0: a dark one
  std::vector<bool> records;  ///< which slices have one
};
size_t frameBeginBytes(size_t slices);

struct FrameEnd {
  uint32_t records = 0;   ///< that were sent: less than announced where the host gave the frame up
  uint32_t checksum = 0;  ///< CRC-32C of their payload checksums, as 4 bytes each, in the order sent
};

struct Present {
  uint64_t refresh = 0;
  uint16_t slice = 0;
  bool atNextRefresh = false;  ///< after it is there; refresh and slice mean nothing
  bool tearWhenLate = false;
  bool coarseWhenLate = false;

  bool operator==(const Present&) const = default;
};

struct Event {
  EventType type = EventType::kArrived;
  uint8_t flags = 0;
  uint16_t code = 0;  ///< of errors an ErrorCode, of shown frames the slice
  uint32_t session = 0;
  uint32_t frame = 0;  ///< 0: none
  uint64_t timeMicroseconds = 0;
  uint32_t refresh = 0;  ///< its low 32 bits

  bool operator==(const Event&) const = default;
};

// To bytes.
std::vector<uint8_t> toBytes(const Identity& identity);
std::vector<uint8_t> toBytes(const Arm& arm);
std::vector<uint8_t> toBytes(const DeviceTelemetry& telemetry);
std::array<uint8_t, kHeaderBytes> toBytes(const MessageHeader& header);
std::vector<uint8_t> toBytes(const FrameBegin& begin);
std::array<uint8_t, kFrameEndBytes> toBytes(const FrameEnd& end);
std::array<uint8_t, kPresentBytes> toBytes(const Present& present);
std::array<uint8_t, kEventBytes> toBytes(const Event& event);

// From bytes that may be anything: nullopt where they are not such a thing.
std::optional<Identity> identityFrom(std::span<const uint8_t> bytes);
std::optional<Arm> armFrom(std::span<const uint8_t> bytes);
std::optional<DeviceTelemetry> telemetryFrom(std::span<const uint8_t> bytes);
/// Of kHeaderBytes. Any type is taken: see isKnown().
std::optional<MessageHeader> headerFrom(std::span<const uint8_t> bytes);
bool isKnown(MessageType type);
std::optional<FrameBegin> frameBeginFrom(std::span<const uint8_t> payload, size_t slices);
std::optional<FrameEnd> frameEndFrom(std::span<const uint8_t> payload);
std::optional<Present> presentFrom(std::span<const uint8_t> payload);
std::optional<Event> eventFrom(std::span<const uint8_t> bytes);

}  // namespace ocelli::wire
