#include "display_driver/devices/tcp_stream.h"

#include <fmt/format.h>
#include <linux/sockios.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// How soon stop() is seen, and how long the system may hold bytes back.
constexpr int kStopMilliseconds = 20;
constexpr auto kLastChance = std::chrono::milliseconds(500);  // of what is under way at stop()
constexpr auto kDeliveryPoll = std::chrono::milliseconds(1);
/// What the system takes at once; more would only wait there.
constexpr int kSendBuffer = 1 << 16;
/// A host that is switched off, or whose cable is pulled, is noticed after 5 + 3 * 2 seconds of silence.
constexpr int kQuietSeconds = 5;
constexpr int kProbeSeconds = 2;
constexpr int kProbes = 3;

std::string systemText(int error) {
  return std::generic_category().message(error);
}

void set(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);  // what the system does not know is left as it is
}

void prepare(int socket) {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_SNDBUF, kSendBuffer);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kQuietSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kProbeSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
}

}  // namespace

TcpStream::TcpStream(const HostPort& place, const std::string& where, std::chrono::milliseconds stall)
    : text_(fmt::format("{}, port {}", place.host, place.port)), stall_(stall) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(place.host.c_str(), std::to_string(place.port).c_str(), &hints, &found);
  if (problem != 0) {
    throw InputError(fmt::format("the host {} is not known ({})", place.host, gai_strerror(problem)), where,
                     "check the name, or give the host's address");
  }
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    const auto* const first = reinterpret_cast<const uint8_t*>(each->ai_addr);
    addresses_.push_back({each->ai_family, std::vector<uint8_t>(first, first + each->ai_addrlen)});
  }
  freeaddrinfo(found);
}

TcpStream::~TcpStream() {
  lose({});
}

bool TcpStream::lose(const std::string& problem) {
  if (socket_ >= 0) {
    close(socket_);
    socket_ = -1;
  }
  problem_ = problem;
  return false;
}

bool TcpStream::connectTo(const Address& address, Clock::time_point end) {
  socket_ = socket(address.family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) {
    return lose(fmt::format("cannot make a connection to {} ({})", text_, systemText(errno)));
  }
  prepare(socket_);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(address.bytes.data()),
                static_cast<socklen_t>(address.bytes.size())) == 0) {
    return true;
  }
  if (errno != EINPROGRESS) {
    return lose(fmt::format("there is no way to {} ({})", text_, systemText(errno)));
  }
  pollfd watched{socket_, POLLOUT, 0};
  while (poll(&watched, 1, kStopMilliseconds) <= 0) {
    if (stopped_ || Clock::now() >= end) {
      return lose(fmt::format("{} does not answer", text_));
    }
  }
  int error = 0;
  socklen_t bytes = sizeof error;
  getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &bytes);
  if (error == ECONNREFUSED) {
    return lose(fmt::format("nothing listens at {} (the connection was refused)", text_));
  }
  return error == 0 || lose(fmt::format("there is no way to {} ({})", text_, systemText(error)));
}

bool TcpStream::connect(std::chrono::milliseconds timeout) {
  lose({});
  for (const Address& address : addresses_) {
    if (connectTo(address, Clock::now() + timeout)) {
      problem_.clear();
      return true;
    }
  }
  return false;
}

bool TcpStream::look() {
  std::array<char, 4096> ignored;
  while (isOpen()) {
    const ssize_t count = recv(socket_, ignored.data(), ignored.size(), MSG_DONTWAIT);
    if (count == 0) {
      return lose(fmt::format("the display at {} has ended the connection", text_));
    }
    if (count < 0 && errno != EINTR) {
      return errno == EAGAIN || lose(fmt::format("the connection to {} broke ({})", text_, systemText(errno)));
    }
    if (stopped_) {
      return true;
    }
  }
  return false;
}

int TcpStream::bytesUnderWay() const {
  int bytes = 0;
  return ioctl(socket_, SIOCOUTQ, &bytes) == 0 ? bytes : 0;
}

bool TcpStream::send(std::span<const uint8_t> bytes) {
  Clock::time_point moved = Clock::now();
  Clock::time_point stopSeen = Clock::time_point::max();
  int underWay = 0;
  while (look()) {
    const ssize_t count = bytes.empty() ? 0 : ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && errno != EAGAIN && errno != EINTR) {
      return lose(fmt::format("the connection to {} broke ({})", text_, systemText(errno)));
    }
    if (count > 0) {
      bytes = bytes.subspan(static_cast<size_t>(count));
      bytesSent_ += static_cast<uint64_t>(count);
    }
    const int left = bytesUnderWay();
    if (bytes.empty() && left == 0) {
      return true;
    }
    if (count > 0 || left < underWay) {
      moved = Clock::now();
    } else if (Clock::now() - moved >= stall_) {
      return lose(fmt::format("the display at {} takes no bytes", text_));
    }
    if (stopped_ && Clock::now() - std::min(stopSeen, Clock::now()) >= kLastChance) {
      return lose("the device was closed while a frame was under way");
    }
    if (stopped_ && stopSeen == Clock::time_point::max()) {
      stopSeen = Clock::now();
    }
    underWay = left;
    pollfd watched{socket_, static_cast<short>(bytes.empty() ? POLLIN : POLLIN | POLLOUT), 0};
    poll(&watched, 1, bytes.empty() ? static_cast<int>(kDeliveryPoll.count()) : kStopMilliseconds);
  }
  return false;
}

}  // namespace ocelli
