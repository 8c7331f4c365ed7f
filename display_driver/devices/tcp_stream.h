// A TCP connection that bytes are sent over. It is the sender who waits: send() returns when the other machine has all
// bytes, so nothing piles up here. For one thread at a time, except stop().
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/host_port.h"

namespace ocelli {

class TcpStream {
 public:
  using Clock = std::chrono::steady_clock;

  /// Looks the host up, once; connects to nothing yet. Throws InputError for an unknown host; `where` is for messages.
  /// A connection that takes no byte for `stall` counts as broken.
  TcpStream(const HostPort& place, const std::string& where, std::chrono::milliseconds stall);
  ~TcpStream();
  TcpStream(const TcpStream&) = delete;
  TcpStream& operator=(const TcpStream&) = delete;

  /// Tries the addresses of the host, one after the other, each for so long. False: problem() says why.
  bool connect(std::chrono::milliseconds timeout);
  bool isOpen() const { return socket_ >= 0; }
  /// Passes over what the other side sends. False where it has ended the connection, or that is broken.
  bool look();
  /// Until the other machine has all of it. False where the connection broke: a part may have arrived.
  bool send(std::span<const uint8_t> bytes);

  uint64_t bytesSent() const { return bytesSent_; }
  const std::string& problem() const { return problem_; }  ///< why there is no connection; empty where there is one
  /// Any thread may call it: what waits returns soon, and waits no more.
  void stop() { stopped_ = true; }

 private:
  struct Address {
    int family = 0;
    std::vector<uint8_t> bytes;  ///< a sockaddr
  };
  bool connectTo(const Address& address, Clock::time_point end);
  bool lose(const std::string& problem);
  /// Bytes that the other machine does not have yet.
  int bytesUnderWay() const;

  std::string text_;  ///< "vortex.local, port 22104"
  std::chrono::milliseconds stall_;
  std::vector<Address> addresses_;
  int socket_ = -1;
  uint64_t bytesSent_ = 0;
  std::string problem_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace ocelli
