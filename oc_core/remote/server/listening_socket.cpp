#include "oc_core/remote/server/listening_socket.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kBacklog = 64;
// What the kernel keeps of a client's data besides what is on its way: an image that was cut short leaves no more
// behind.
constexpr int kUnsentBytes = 128 << 10;

struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
  sockaddr_in& v4() { return reinterpret_cast<sockaddr_in&>(storage); }
  sockaddr_in6& v6() { return reinterpret_cast<sockaddr_in6&>(storage); }
};

std::optional<SocketAddress> socketAddress(const std::string& text, int port) {
  SocketAddress address;
  if (inet_pton(AF_INET, text.c_str(), &address.v4().sin_addr) == 1) {
    address.v4().sin_family = AF_INET;
    address.v4().sin_port = htons(static_cast<uint16_t>(port));
    address.size = sizeof(sockaddr_in);
    return address;
  }
  if (inet_pton(AF_INET6, text.c_str(), &address.v6().sin6_addr) == 1) {
    address.v6().sin6_family = AF_INET6;
    address.v6().sin6_port = htons(static_cast<uint16_t>(port));
    address.size = sizeof(sockaddr_in6);
    return address;
  }
  return std::nullopt;
}

int listenAt(const SocketAddress& address) {
  const int listener = socket(address.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int yes = 1;
  const int no = 0;
  if (listener >= 0 && setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes)) == 0 &&
      (address.storage.ss_family != AF_INET6 ||
       setsockopt(listener, IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof(no)) == 0) &&
      bind(listener, address.get(), address.size) == 0 && listen(listener, kBacklog) == 0) {
    return listener;
  }
  const int problem = errno;
  if (listener >= 0) {
    close(listener);
  }
  errno = problem;
  return -1;
}

std::string textOfAddress(int family, const void* address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(family, address, text.data(), text.size()) != nullptr ? text.data() : "";
}

}  // namespace

ListeningSocket::ListeningSocket(const std::string& address, int port) {
  const std::optional<SocketAddress> wanted = socketAddress(address, port);
  if (!wanted) {
    throw InputError("\"" + address + "\" is no address of IPv4 or IPv6", "--bind",
                     "give one in digits: 127.0.0.1, or 0.0.0.0 for all of this computer's");
  }
  descriptor_ = listenAt(*wanted);
  if (descriptor_ < 0) {
    const int problem = errno;
    throw WorkError(problem == EADDRINUSE      ? "another program uses this port already"
                    : problem == EADDRNOTAVAIL ? "this computer does not have this address"
                                               : fmt::format("it cannot be used ({})", std::strerror(problem)),
                    fmt::format("{}, port {}", address, port),
                    "give another one with --bind and --port; port 0 takes any that is free");
  }
  SocketAddress bound;
  bound.size = sizeof(bound.storage);
  if (getsockname(descriptor_, reinterpret_cast<sockaddr*>(&bound.storage), &bound.size) == 0) {
    port_ = ntohs(bound.storage.ss_family == AF_INET6 ? bound.v6().sin6_port : bound.v4().sin_port);
  }
  const bool isV6 = wanted->storage.ss_family == AF_INET6;
  shown_ = address == "0.0.0.0" ? "127.0.0.1" : address == "::" ? "[::1]" : isV6 ? "[" + address + "]" : address;
}

ListeningSocket::~ListeningSocket() {
  if (isOurs_) {
    close(descriptor_);
  }
}

int ListeningSocket::release() {
  isOurs_ = false;
  return descriptor_;
}

std::string ListeningSocket::hostAndPort() const {
  return fmt::format("{}:{}", shown_, port_);
}

std::optional<AcceptedSocket> ListeningSocket::accept() const {
  SocketAddress peer;
  peer.size = sizeof(peer.storage);
  const int descriptor =
      accept4(descriptor_, reinterpret_cast<sockaddr*>(&peer.storage), &peer.size, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (descriptor < 0) {
    const int problem = errno;
    if (problem == EMFILE || problem == ENFILE || problem == ENOBUFS || problem == ENOMEM) {
      throw WorkError(fmt::format("no other connection can be taken ({})", std::strerror(problem)), hostAndPort(),
                      "let this program open more files (ulimit -n)");
    }
    return std::nullopt;
  }
  const int yes = 1;
  setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
  setsockopt(descriptor, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsentBytes, sizeof(kUnsentBytes));
  AcceptedSocket accepted;
  accepted.descriptor = descriptor;
  if (peer.storage.ss_family == AF_INET) {
    accepted.address = textOfAddress(AF_INET, &peer.v4().sin_addr);
    accepted.network = accepted.address;
  } else {
    in6_addr network = peer.v6().sin6_addr;
    accepted.address = textOfAddress(AF_INET6, &network);
    if (IN6_IS_ADDR_V4MAPPED(&network) == 0) {
      constexpr size_t kNetworkBytes = 8;
      std::memset(network.s6_addr + kNetworkBytes, 0, sizeof(network.s6_addr) - kNetworkBytes);
    }
    accepted.network = textOfAddress(AF_INET6, &network);
  }
  return accepted;
}

void allowDescriptors(size_t count) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= count) {
    return;
  }
  limit.rlim_cur = std::min<rlim_t>(count, limit.rlim_max);
  if (limit.rlim_cur < count || setrlimit(RLIMIT_NOFILE, &limit) != 0) {
    throw WorkError(fmt::format("it may open {} files and sockets, and needs {}", limit.rlim_max, count),
                    "the server of remote visualisation", "serve fewer clients, or raise the limit (ulimit -n)");
  }
}

bool isLoopbackAddress(const std::string& address) {
  std::optional<SocketAddress> read = socketAddress(address, 0);
  constexpr uint32_t kLoopbackNet = 127;
  return read && (read->storage.ss_family == AF_INET ? ntohl(read->v4().sin_addr.s_addr) >> 24U == kLoopbackNet
                                                     : IN6_IS_ADDR_LOOPBACK(&read->v6().sin6_addr) != 0);
}

}  // namespace ocelli
