// A datagram a marker: its line (lineOf()) and a newline. Nobody need listen.
#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/base/host_port.h"
#include "study/markers/marker_output.h"

namespace ocelli {
namespace {

class UdpMarkers : public MarkerOutput {
 public:
  explicit UdpMarkers(int descriptor) : socket_(descriptor) {}
  ~UdpMarkers() override { close(socket_); }
  UdpMarkers(const UdpMarkers&) = delete;
  UdpMarkers& operator=(const UdpMarkers&) = delete;

  void send(const Marker& marker) override {
    const std::string line = lineOf(marker) + "\n";
    if (sendOnce(line)) {
      ++counts_.sent;
      return;
    }
    ++counts_.lost;
    // That nobody listens is told of the datagram before: this one has not been sent yet.
    if (errno == ECONNREFUSED && sendOnce(line)) {
      ++counts_.sent;
    }
  }
  MarkerCounts counts() const override { return counts_; }

 private:
  bool sendOnce(const std::string& line) const {
    return ::send(socket_, line.data(), line.size(), MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(line.size());
  }

  int socket_;
  MarkerCounts counts_{};
};

std::unique_ptr<MarkerOutput> openUdp(const std::string& text) {
  const std::string where = "--markers udp:" + text;
  const std::optional<HostPort> place = hostPortFromText(text);
  if (!place) {
    throw InputError("must be a host and a port from 1 to 65535", where, "such as udp:192.168.0.7:5005");
  }
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(place->host.c_str(), std::to_string(place->port).c_str(), &hints, &found);
  if (problem != 0) {
    throw InputError(fmt::format("this host is not known ({})", gai_strerror(problem)), where, "give its address");
  }
  int descriptor = -1;
  for (const addrinfo* each = found; each != nullptr && descriptor < 0; each = each->ai_next) {
    descriptor = socket(each->ai_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (descriptor >= 0 && connect(descriptor, each->ai_addr, each->ai_addrlen) != 0) {
      close(descriptor);
      descriptor = -1;
    }
  }
  freeaddrinfo(found);
  if (descriptor < 0) {
    throw WorkError(fmt::format("there is no way to this host ({})", std::strerror(errno)), where,
                    "check the network, or leave this output away");
  }
  return std::make_unique<UdpMarkers>(descriptor);
}

}  // namespace

MarkerOutputKind udpOutput() {
  return {"udp", "udp:HOST:PORT", "a datagram with a line of text for each marker", openUdp};
}

}  // namespace ocelli
