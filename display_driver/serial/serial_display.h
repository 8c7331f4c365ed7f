// The display's side of a serial line (docs/serial_protocol.md): packets in front of an emulated display. It knows no
// clock and no thread, and no line: bytes and times come from the caller.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display_driver/firmware/emulated_device.h"
#include "display_driver/serial/serial_frame.h"
#include "display_driver/serial/serial_stream.h"

namespace ocelli {

class SerialDisplay {
 public:
  /// What it takes before the device has used it; a microcontroller may have less.
  static constexpr size_t kCapacity = 2048;

  /// The device must outlive it.
  explicit SerialDisplay(EmulatedDevice& device) : device_(device), stream_(kCapacity) {}

  /// Bytes that came over the line.
  void read(std::span<const uint8_t> bytes, DeviceMicroseconds now);
  /// The line is gone: what comes next is a new connection.
  void disconnect();
  /// Moves everything on, and adds what is due to line().
  void advance(DeviceMicroseconds now);
  /// Bytes for the line; the caller takes from the front what the line took.
  std::vector<uint8_t>& line() { return line_; }

  uint64_t damagedPackets() const { return reader_.damaged(); }
  uint64_t resent() const { return events_.resent(); }

 private:
  void take(const serial::Packet& packet, DeviceMicroseconds now);
  void open(uint32_t connection);
  void answer(std::span<const uint8_t> request, DeviceMicroseconds now);
  void feedDevice(DeviceMicroseconds now);

  EmulatedDevice& device_;
  serial::PacketReader reader_;
  uint32_t connection_ = 0;  ///< 0: none
  serial::SerialReceiver stream_;
  serial::SerialSender events_;
  std::vector<uint8_t> lastRequest_;
  std::vector<std::vector<uint8_t>> lastAnswer_;  ///< its packets' contents
  DeviceMicroseconds creditTold_ = 0;
  std::vector<uint8_t> line_;
};

}  // namespace ocelli
