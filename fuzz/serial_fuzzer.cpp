// libFuzzer target: any bytes from a serial line, as they are and once more as packets with checksums that fit, to a
// display and to both ends of a stream. What waits for the line stays small.
#include <cstdlib>

#include "display_driver/serial/serial_display.h"

namespace {

using namespace ocelli;

constexpr size_t kMaxLineBytes = 16384;

/// Of each piece the first byte says its length, the second its type.
std::vector<uint8_t> asPackets(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> line;
  while (bytes.size() >= 2) {
    const size_t length = std::min<size_t>(bytes[0] % 250, bytes.size() - 2);
    serial::addPacket(line, static_cast<serial::PacketType>(bytes[1]), bytes.subspan(2, length));
    bytes = bytes.subspan(2 + length);
  }
  return line;
}

void toDisplay(std::span<const uint8_t> bytes) {
  EmulatedDeviceOptions options;
  DisplayProfile& profile = options.firmware.profile;
  profile.name = "fuzz";
  profile.slicesPerHalfTurn = 4;
  profile.width = profile.height = 8;
  EmulatedDevice device(options);
  SerialDisplay display(device);
  DeviceMicroseconds now = 0;
  for (size_t at = 0; at < bytes.size(); at += 64, now += 1000) {
    display.read(bytes.subspan(at, std::min<size_t>(64, bytes.size() - at)), now);
    display.advance(now);
    std::vector<uint8_t>& line = display.line();
    if (line.size() > 4 * kMaxLineBytes) {
      std::abort();
    }
    line.clear();
  }
}

void toStreams(std::span<const uint8_t> bytes) {
  serial::SerialSender sender;
  serial::SerialReceiver receiver(500);
  sender.append(std::vector<uint8_t>(1000, 7));
  serial::Time now{};
  serial::PacketReader reader;
  reader.read(bytes, [&](const serial::Packet& packet) {
    now += std::chrono::milliseconds(50);
    sender.hear(packet.content, now);
    receiver.take(packet.content);
    sender.next(now);
    if (receiver.bytes().size() > 500 || sender.end() != 1000) {
      std::abort();
    }
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  const std::vector<uint8_t> packets = asPackets(bytes);
  for (const std::span<const uint8_t> each : {bytes, std::span<const uint8_t>(packets)}) {
    toDisplay(each);
    toStreams(each);
  }
  return 0;
}
