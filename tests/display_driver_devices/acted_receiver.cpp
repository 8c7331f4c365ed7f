#include "tests/display_driver_devices/acted_receiver.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <chrono>
#include <stdexcept>

namespace ocelli::test {
namespace {

constexpr int kPauseMilliseconds = 5;

std::vector<uint8_t> gunzipped(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes;
  z_stream stream{};
  stream.next_in = const_cast<Bytef*>(data);
  stream.avail_in = static_cast<uInt>(size);
  inflateInit2(&stream, 16 + MAX_WBITS);
  int state = Z_OK;
  while (state == Z_OK) {
    const size_t before = bytes.size();
    bytes.resize(before + 65536);
    stream.next_out = bytes.data() + before;
    stream.avail_out = 65536;
    state = inflate(&stream, Z_NO_FLUSH);
    bytes.resize(bytes.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || stream.avail_in != 0) {
    bytes.assign(1, 0);  // no whole number of cells
  }
  return bytes;
}

}  // namespace

ActedReceiver::ActedReceiver(const VoxelGrid& grid) : grid_(grid) {
  start();
}

ActedReceiver::~ActedReceiver() {
  end();
}

void ActedReceiver::start() {
  listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const int buffer = 1 << 15;  // what a sender can push while nobody reads
  setsockopt(listener_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<uint16_t>(port_));
  socklen_t bytes = sizeof address;
  if (bind(listener_, reinterpret_cast<sockaddr*>(&address), bytes) != 0 || listen(listener_, 4) != 0 ||
      getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &bytes) != 0) {
    throw std::runtime_error("the test cannot listen");
  }
  port_ = ntohs(address.sin_port);
  stop_ = false;
  {
    const std::lock_guard lock(mutex_);
    shown_.clear();
  }
  thread_ = std::thread([this] { run(); });
}

void ActedReceiver::end() {
  stop_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  if (listener_ >= 0) {
    close(listener_);
    listener_ = -1;
  }
}

void ActedReceiver::say(const std::string& text) {
  const std::lock_guard lock(mutex_);
  toSay_ = text;
}

std::vector<uint8_t> ActedReceiver::shown() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

std::string ActedReceiver::complaint() const {
  const std::lock_guard lock(mutex_);
  return complaint_;
}

void ActedReceiver::complain(const std::string& what) {
  const std::lock_guard lock(mutex_);
  complaint_ = what;
}

void ActedReceiver::run() {
  while (!stop_) {
    pollfd watched{listener_, POLLIN, 0};
    if (poll(&watched, 1, kPauseMilliseconds) <= 0) {
      continue;
    }
    const int connection = accept(listener_, nullptr, nullptr);
    if (connection >= 0) {
      ++connections_;
      while (!stop_ && serve(connection)) {
      }
      close(connection);
    }
  }
}

/// Reads until the connection ends. False where it has.
bool ActedReceiver::serve(int connection) {
  std::vector<uint8_t> bytes;
  while (!stop_) {
    std::string text;
    {
      const std::lock_guard lock(mutex_);
      text.swap(toSay_);
    }
    if (!text.empty()) {
      send(connection, text.data(), text.size(), MSG_NOSIGNAL);
    }
    pollfd watched{connection, POLLIN, 0};
    if (deaf_ || poll(&watched, 1, kPauseMilliseconds) <= 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(deaf_ ? kPauseMilliseconds : 0));
      continue;
    }
    std::array<uint8_t, 4096> part;
    const ssize_t count = recv(connection, part.data(), part.size(), 0);
    if (count <= 0) {
      return false;
    }
    bytes.insert(bytes.end(), part.begin(), part.begin() + count);
    if (const int64_t left = dropAfter_; left >= 0) {
      dropAfter_ = left - count;
      if (left <= count) {
        dropAfter_ = -1;
        return false;
      }
    }
    if (!takeMessages(bytes)) {
      return false;
    }
  }
  return false;
}

bool ActedReceiver::takeMessages(std::vector<uint8_t>& bytes) {
  while (bytes.size() >= 8) {
    if (bytes[0] != 0xff || bytes[1] != 0xff || bytes[2] != 0xff || bytes[3] != 0xff) {
      complain("a message does not begin with ff ff ff ff");
      return false;
    }
    const size_t length = size_t{bytes[4]} << 24 | size_t{bytes[5]} << 16 | size_t{bytes[6]} << 8 | bytes[7];
    if (bytes.size() < 8 + length) {
      return true;
    }
    show(gunzipped(bytes.data() + 8, length));
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(8 + length));
  }
  return true;
}

void ActedReceiver::show(const std::vector<uint8_t>& lit) {
  if (lit.empty() || lit.size() % 4 != 0) {
    complain("a message is no whole number of cells");
    return;
  }
  std::vector<uint8_t> cells(grid_.cells(), 0);
  for (size_t i = 0; i < lit.size(); i += 4) {
    if (lit[i] >= grid_.x || lit[i + 1] >= grid_.y || lit[i + 2] >= grid_.z) {
      complain("a cell is outside of the grid");
      return;
    }
    cells[grid_.index(lit[i], lit[i + 1], lit[i + 2])] = lit[i + 3];
  }
  const std::lock_guard lock(mutex_);
  shown_ = std::move(cells);
  ++messages_;
}

}  // namespace ocelli::test
