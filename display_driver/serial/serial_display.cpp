#include "display_driver/serial/serial_display.h"

#include <algorithm>
#include <optional>

namespace ocelli {
namespace {

using serial::PacketType;

constexpr DeviceMicroseconds kCreditEvery = 100000;
constexpr size_t kMaxWaiting = 2048;  // bytes for the line; events wait in the device meanwhile
constexpr size_t kRequestHead = 7;
constexpr size_t kMaxParts = 255;

serial::Time timeOf(DeviceMicroseconds now) {
  return serial::Time(std::chrono::microseconds(now));
}

}  // namespace

void SerialDisplay::read(std::span<const uint8_t> bytes, DeviceMicroseconds now) {
  reader_.read(bytes, [&](const serial::Packet& packet) { take(packet, now); });
}

void SerialDisplay::open(uint32_t connection) {
  if (connection != connection_) {  // else the host has not heard the answer
    connection_ = connection;
    stream_ = serial::SerialReceiver(kCapacity);
    events_ = serial::SerialSender();
    lastRequest_.clear();
    lastAnswer_.clear();
    line_.clear();
    line_.push_back(0);
  }
  std::vector<uint8_t> content;
  serial::addNumber(content, connection, 4);
  serial::addPacket(line_, PacketType::kOpened, content);
  serial::addPacket(line_, PacketType::kCredit, serial::creditContent(stream_.tell()));
}

void SerialDisplay::disconnect() {
  connection_ = 0;
  reader_ = {};
  line_.clear();
}

void SerialDisplay::take(const serial::Packet& packet, DeviceMicroseconds now) {
  if (packet.type == PacketType::kOpen) {
    if (packet.content.size() == 4 && serial::numberAt(packet.content, 0, 4) != 0) {
      open(static_cast<uint32_t>(serial::numberAt(packet.content, 0, 4)));
    }
    return;
  }
  if (connection_ == 0) {
    return;
  }
  if (packet.type == PacketType::kData) {
    stream_.take(packet.content);
    feedDevice(now);
  } else if (packet.type == PacketType::kHeard) {
    events_.hear(packet.content, timeOf(now));
  } else if (packet.type == PacketType::kRequest) {
    answer(packet.content, now);
  }
}

/// Bytes that a transfer of USB would have lost with a stall or a short end are there still: they are offered again.
void SerialDisplay::feedDevice(DeviceMicroseconds now) {
  while (!stream_.bytes().empty()) {
    const EmulatedDevice::Taken taken = device_.takeBulk(stream_.bytes(), now);
    stream_.use(taken.bytes);
    if (device_.halted()) {
      device_.clearHalt();
    }
    if (taken.bytes == 0 && taken.outcome == EmulatedDevice::Outcome::kGoOn) {
      return;
    }
  }
}

void SerialDisplay::answer(std::span<const uint8_t> request, DeviceMicroseconds now) {
  if (request.size() < kRequestHead) {
    return;
  }
  if (!std::ranges::equal(request, lastRequest_)) {  // else the host has not heard the answer
    const auto value = static_cast<uint16_t>(serial::numberAt(request, 3, 2));
    const auto length = static_cast<size_t>(serial::numberAt(request, 5, 2));
    std::optional<std::vector<uint8_t>> bytes;
    if (request[1] == serial::kRequestIn && request.size() == kRequestHead) {
      bytes = device_.controlIn(request[2], value, length, now);
    } else if (request[1] == serial::kRequestOut && request.size() == kRequestHead + length &&
               device_.controlOut(request[2], value, request.subspan(kRequestHead), now)) {
      bytes.emplace();
    }
    const std::vector<uint8_t> all = bytes.value_or(std::vector<uint8_t>());
    const size_t parts = std::max<size_t>(1, (all.size() + serial::kMaxPacketBytes - 1) / serial::kMaxPacketBytes);
    const bool refused = !bytes || parts > kMaxParts;
    lastRequest_.assign(request.begin(), request.end());
    lastAnswer_.clear();
    for (size_t part = 0; part < (refused ? 1 : parts); ++part) {
      const size_t first = part * serial::kMaxPacketBytes;
      const size_t last = refused ? 0 : std::min(all.size(), first + serial::kMaxPacketBytes);
      std::vector<uint8_t> content{request[0], static_cast<uint8_t>(refused ? 1 : 0), static_cast<uint8_t>(part),
                                   static_cast<uint8_t>(refused ? 1 : parts)};
      content.insert(content.end(), all.begin() + static_cast<std::ptrdiff_t>(std::min(first, last)),
                     all.begin() + static_cast<std::ptrdiff_t>(last));
      lastAnswer_.push_back(std::move(content));
    }
  }
  for (const std::vector<uint8_t>& content : lastAnswer_) {
    serial::addPacket(line_, PacketType::kAnswer, content);
  }
}

void SerialDisplay::advance(DeviceMicroseconds now) {
  device_.advance(now);
  if (connection_ == 0) {
    return;
  }
  feedDevice(now);
  if (line_.size() < kMaxWaiting && events_.end() - events_.taken() < kMaxWaiting) {
    events_.append(device_.takeEvents(kMaxWaiting, now));
  }
  while (line_.size() < kMaxWaiting) {
    const auto packet = events_.next(timeOf(now));
    if (!packet) {
      break;
    }
    serial::addPacket(line_, PacketType::kEvents, *packet);
  }
  if (stream_.hasNews() || now - creditTold_ >= kCreditEvery) {
    serial::addPacket(line_, PacketType::kCredit, serial::creditContent(stream_.tell()));
    creditTold_ = now;
  }
}

}  // namespace ocelli
