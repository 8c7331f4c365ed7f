#include "display_driver/serial/serial_frame.h"

#include "display_driver/wire/wire_format.h"
#include "oc_core/base/check.h"

namespace ocelli::serial {
namespace {

constexpr size_t kChecksumBytes = 4;
constexpr size_t kMaxCoded = kMaxBody + 1;

}  // namespace

void addNumber(std::vector<uint8_t>& content, uint64_t number, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) {
    content.push_back(static_cast<uint8_t>(number >> (8 * i) & 0xff));
  }
}

uint64_t numberAt(std::span<const uint8_t> content, size_t offset, size_t bytes) {
  uint64_t number = 0;
  for (size_t i = 0; i < bytes; ++i) {
    number |= uint64_t{content[offset + i]} << (8 * i);
  }
  return number;
}

void addPacket(std::vector<uint8_t>& line, PacketType type, std::span<const uint8_t> content) {
  std::vector<uint8_t> body{static_cast<uint8_t>(type)};
  body.insert(body.end(), content.begin(), content.end());
  addNumber(body, wire::crc32c(body), kChecksumBytes);
  OC_CHECK(body.size() <= kMaxBody, "a packet is too long");
  // Each code byte says how far it is to the next one, which stands in the place of a 0.
  size_t code = line.size();
  line.push_back(1);
  for (const uint8_t byte : body) {
    if (byte == 0) {
      code = line.size();
      line.push_back(1);
    } else {
      line.push_back(byte);
      ++line[code];
    }
  }
  line.push_back(0);
}

bool PacketReader::decode() {
  std::vector<uint8_t> body;
  for (size_t at = 0; at < coded_.size();) {
    const size_t code = coded_[at];
    if (at > 0) {
      body.push_back(0);
    }
    if (at + code > coded_.size()) {
      return false;
    }
    body.insert(body.end(), coded_.begin() + static_cast<std::ptrdiff_t>(at + 1),
                coded_.begin() + static_cast<std::ptrdiff_t>(at + code));
    at += code;
  }
  if (body.size() < 1 + kChecksumBytes) {
    return false;
  }
  const size_t length = body.size() - kChecksumBytes;
  if (wire::crc32c(std::span(body).first(length)) != numberAt(body, length, kChecksumBytes)) {
    return false;
  }
  packet_.type = static_cast<PacketType>(body[0]);
  packet_.content.assign(body.begin() + 1, body.begin() + static_cast<std::ptrdiff_t>(length));
  return true;
}

void PacketReader::read(std::span<const uint8_t> bytes, const std::function<void(const Packet&)>& visit) {
  for (const uint8_t byte : bytes) {
    if (byte != 0) {
      tooLong_ = tooLong_ || coded_.size() >= kMaxCoded;
      if (!tooLong_) {
        coded_.push_back(byte);
      }
      continue;
    }
    if (!coded_.empty()) {  // several zeros in a row are no packet
      if (!tooLong_ && decode()) {
        visit(packet_);
      } else {
        ++damaged_;
      }
    }
    coded_.clear();
    tooLong_ = false;
  }
}

}  // namespace ocelli::serial
