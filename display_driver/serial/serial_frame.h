// Packets on a serial line, between bytes that may be lost or damaged (docs/serial_protocol.md).
//
// A packet is a type, its content and their CRC-32C, at most 254 bytes in all, coded so that no byte of it is 0 (COBS,
// Cheshire and Baker 1999), and a byte of 0 as its end. Whatever happens on the line, a reader is in step again at the
// next 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ocelli::serial {

enum class PacketType : uint8_t {
  kOpen = 1,      ///< host: begins a connection
  kData = 2,      ///< host: bytes of the stream to the display
  kRequest = 3,   ///< host
  kHeard = 4,     ///< host: how far it has the events
  kOpened = 129,  ///< display
  kCredit = 130,  ///< display: how far it has the stream, and what more it takes
  kAnswer = 131,  ///< display: to a request
  kEvents = 132,  ///< display: bytes of the stream of events
};

inline constexpr size_t kMaxBody = 254;
/// Of kData, kEvents, kRequest and kAnswer, besides their heads.
inline constexpr size_t kMaxPacketBytes = 240;

/// Directions of requests: the bmRequestType that USB has for them.
inline constexpr uint8_t kRequestIn = 0xc1;
inline constexpr uint8_t kRequestOut = 0x41;

struct Packet {
  PacketType type = PacketType::kOpen;
  std::vector<uint8_t> content;
};

/// Adds the bytes of a packet to `line`.
void addPacket(std::vector<uint8_t>& line, PacketType type, std::span<const uint8_t> content);

/// Reads packets from the bytes of a line, and passes over what is none.
class PacketReader {
 public:
  void read(std::span<const uint8_t> bytes, const std::function<void(const Packet&)>& visit);
  uint64_t damaged() const { return damaged_; }

 private:
  bool decode();

  std::vector<uint8_t> coded_;  ///< since the last 0
  bool tooLong_ = false;
  Packet packet_;
  uint64_t damaged_ = 0;
};

/// Little-endian numbers at the end and at the front of contents.
void addNumber(std::vector<uint8_t>& content, uint64_t number, size_t bytes);
uint64_t numberAt(std::span<const uint8_t> content, size_t offset, size_t bytes);

}  // namespace ocelli::serial
