// The socket on which the server of remote visualisation listens, and the connections that come in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace ocelli {

struct AcceptedSocket {
  int descriptor = -1;  ///< not blocking; the caller closes it
  std::string address;  ///< numeric, without a port
  std::string network;  ///< who counts as one: the address, or the first 64 bits of one of IPv6
};

class ListeningSocket {
 public:
  /// `address` is numeric: "127.0.0.1", "::1", "0.0.0.0" for all of IPv4, "::" for all. Port 0 takes a free one. Throws
  /// InputError where it is no address, WorkError where it may not be used.
  ListeningSocket(const std::string& address, int port);
  ~ListeningSocket();
  ListeningSocket(const ListeningSocket&) = delete;
  ListeningSocket& operator=(const ListeningSocket&) = delete;

  /// Nothing where nobody waits. Does not block. Throws WorkError where somebody waits and this program or the computer
  /// has no descriptor or memory left for it.
  std::optional<AcceptedSocket> accept() const;
  /// The descriptor belongs to someone else from now on, who closes it. accept() goes on as before.
  int release();

  int port() const { return port_; }
  /// "127.0.0.1:8080" or "[::1]:8080", as it stands in addresses of pages; of all addresses the loopback one.
  std::string hostAndPort() const;

 private:
  int descriptor_ = -1;
  bool isOurs_ = true;
  int port_ = 0;
  std::string shown_;
};

/// Lets this program open so many files and sockets at a time, where it may not yet. Throws WorkError where the
/// computer does not allow that.
void allowDescriptors(size_t count);

/// Whether only programs of this computer reach it: 127.0.0.0/8 or ::1. False for what is no address.
bool isLoopbackAddress(const std::string& address);

}  // namespace ocelli
