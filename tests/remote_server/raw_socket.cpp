#include "tests/remote_server/raw_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <utility>
#include <vector>

namespace ocelli::test {
namespace {

constexpr std::string_view kKey = "dGhlIHNhbXBsZSBub25jZQ==";  // the example of RFC 6455, section 1.3
constexpr std::string_view kAccept = "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=";
constexpr std::string_view kMask = "\x5a\xc3\x17\x88";
constexpr size_t kReadBytes = size_t{64} << 10;

sockaddr_in addressOf(const std::string& host, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  inet_pton(AF_INET, host.c_str(), &address.sin_addr);
  return address;
}

void appendNumber(std::string& bytes, uint64_t number, int count) {
  for (int i = count - 1; i >= 0; --i) {
    bytes += static_cast<char>(number >> (8 * i));
  }
}

}  // namespace

RawSocket::RawSocket(int port, const std::string& from) : descriptor_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_in here = addressOf(from, 0);
  const sockaddr_in there = addressOf("127.0.0.1", port);
  // A port is chosen when it connects: otherwise the ports of an address run out.
  const int yes = 1;
  setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
  setsockopt(descriptor_, IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &yes, sizeof(yes));
  if (bind(descriptor_, reinterpret_cast<const sockaddr*>(&here), sizeof(here)) != 0 ||
      connect(descriptor_, reinterpret_cast<const sockaddr*>(&there), sizeof(there)) != 0) {
    close();
  }
}

RawSocket::~RawSocket() {
  close();
}

RawSocket::RawSocket(RawSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), hasEnded_(other.hasEnded_) {}

void RawSocket::close() {
  if (descriptor_ >= 0) {
    ::close(std::exchange(descriptor_, -1));
  }
}

void RawSocket::reset() {
  const linger atOnce{1, 0};
  setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &atOnce, sizeof(atOnce));
  close();
}

bool RawSocket::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

std::string RawSocket::receive(size_t maxBytes, std::chrono::milliseconds patience) {
  pollfd waiting{descriptor_, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) {
    return {};
  }
  std::string bytes(maxBytes, '\0');
  const ssize_t count = recv(descriptor_, bytes.data(), bytes.size(), 0);
  hasEnded_ = count <= 0;
  bytes.resize(count > 0 ? static_cast<size_t>(count) : 0);
  return bytes;
}

std::string RawSocket::receiveAll(std::chrono::milliseconds patience) {
  std::string all;
  for (std::string part = receive(kReadBytes, patience); !part.empty(); part = receive(kReadBytes, patience)) {
    all += part;
  }
  return all;
}

std::string bytesOf(const Frame& frame) {
  constexpr uint64_t kMaxOfByte = 125;
  constexpr uint64_t kMaxOfTwoBytes = 65535;
  const uint64_t length = frame.saidLength.value_or(frame.payload.size());
  std::string bytes;
  bytes += static_cast<char>((frame.isLast ? 0x80 : 0) | frame.reservedBits << 4 | frame.opcode);
  const int masked = frame.isMasked ? 0x80 : 0;
  if (length <= kMaxOfByte) {
    bytes += static_cast<char>(masked | static_cast<int>(length));
  } else if (length <= kMaxOfTwoBytes) {
    bytes += static_cast<char>(masked | 126);
    appendNumber(bytes, length, 2);
  } else {
    bytes += static_cast<char>(masked | 127);
    appendNumber(bytes, length, 8);
  }
  if (!frame.isMasked) {
    return bytes + frame.payload;
  }
  bytes += kMask;
  for (size_t i = 0; i < frame.payload.size(); ++i) {
    bytes += static_cast<char>(frame.payload[i] ^ kMask[i % kMask.size()]);
  }
  return bytes;
}

std::string bytesOf(const Handshake& handshake, int port) {
  std::string request = "GET " + handshake.path + " HTTP/1.1\r\nHost: ";
  request += handshake.host.empty() ? "127.0.0.1:" + std::to_string(port) : handshake.host;
  request += "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ";
  request += std::string(kKey) + "\r\n";
  request += handshake.origin.empty() ? "" : "Origin: " + handshake.origin + "\r\n";
  return request + handshake.more + "\r\n";
}

TestWebSocket::TestWebSocket(int port, const Handshake& handshake, const std::string& from) : socket_(port, from) {
  if (!socket_.isConnected() || !socket_.send(bytesOf(handshake, port))) {
    return;
  }
  constexpr std::string_view kEnd = "\r\n\r\n";
  while (buffer_.find(kEnd) == std::string::npos) {
    const std::string part = socket_.receive(kReadBytes);
    if (part.empty()) {
      answer_ = std::move(buffer_);
      return;
    }
    buffer_ += part;
  }
  const size_t end = buffer_.find(kEnd) + kEnd.size();
  answer_ = buffer_.substr(0, end);
  buffer_.erase(0, end);
  isOpen_ = answer_.starts_with("HTTP/1.1 101") && answer_.find(kAccept) != std::string::npos;
  if (!isOpen_) {
    answer_ += buffer_ + socket_.receiveAll();
  }
}

bool TestWebSocket::fill(size_t bytes, Clock::time_point deadline) {
  while (buffer_.size() < bytes) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    const std::string part = socket_.receive(kReadBytes, std::max(left, std::chrono::milliseconds(0)));
    if (part.empty()) {
      return false;
    }
    buffer_ += part;
  }
  return true;
}

std::optional<Frame> TestWebSocket::receive(std::chrono::milliseconds patience) {
  return receiveUntil(Clock::now() + patience);
}

std::optional<Frame> TestWebSocket::receiveUntil(Clock::time_point deadline) {
  for (;;) {
    size_t head = 2;
    if (!fill(head, deadline)) {
      return std::nullopt;
    }
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(buffer_[i]); };
    uint64_t length = byte(1) & 0x7fU;
    const size_t extra = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (!fill(head + extra, deadline)) {
      return std::nullopt;
    }
    if (extra > 0) {
      length = 0;
      for (size_t i = 0; i < extra; ++i) {
        length = length << 8U | byte(head + i);
      }
    }
    head += extra;
    if (!fill(head + length, deadline)) {
      return std::nullopt;
    }
    Frame frame{.opcode = byte(0) & 0x0f, .payload = buffer_.substr(head, length), .isLast = (byte(0) & 0x80) != 0};
    frame.isMasked = (byte(1) & 0x80) != 0;
    buffer_.erase(0, head + length);
    if (frame.opcode != Frame::kPing) {
      return frame;
    }
    if (answersPings_) {
      send({.opcode = Frame::kPong, .payload = frame.payload});
    }
  }
}

int TestWebSocket::closeCode(const Frame& frame) {
  return frame.opcode == Frame::kClose && frame.payload.size() >= 2
             ? static_cast<unsigned char>(frame.payload[0]) << 8 | static_cast<unsigned char>(frame.payload[1])
             : 0;
}

int TestWebSocket::awaitClose(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  while (const std::optional<Frame> frame = receiveUntil(deadline)) {
    if (frame->opcode == Frame::kClose) {
      send({.opcode = Frame::kClose, .payload = frame->payload});
      return closeCode(*frame);
    }
  }
  return socket_.hasEnded() ? 0 : -1;
}

}  // namespace ocelli::test
