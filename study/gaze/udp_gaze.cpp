// Datagrams of lines; each is read as it came, so that a line does not reach over two.
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/base/host_port.h"
#include "study/gaze/gaze_input.h"

namespace ocelli {
namespace {

constexpr size_t kMaxDatagram = 65536;

class UdpGaze : public GazeBytes {
 public:
  explicit UdpGaze(int descriptor) : socket_(descriptor), datagram_(kMaxDatagram, '\0') {}
  ~UdpGaze() override { close(socket_); }
  UdpGaze(const UdpGaze&) = delete;
  UdpGaze& operator=(const UdpGaze&) = delete;

  std::string read(int waitMilliseconds) override {
    pollfd watched{socket_, POLLIN, 0};
    if (poll(&watched, 1, waitMilliseconds) <= 0) {
      return {};
    }
    const ssize_t count = recv(socket_, datagram_.data(), datagram_.size(), MSG_DONTWAIT);
    return count > 0 ? datagram_.substr(0, static_cast<size_t>(count)) : std::string();
  }

 private:
  int socket_;
  std::string datagram_;
};

std::unique_ptr<GazeBytes> openUdp(const std::string& text) {
  const std::string where = "--gaze udp:" + text;
  const std::optional<HostPort> place = hostPortFromText(text);
  if (!place) {
    throw InputError("must be an address of this computer and a port from 1 to 65535", where,
                     "such as udp:127.0.0.1:5010, or udp:0.0.0.0:5010 for a tracker on another computer");
  }
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(place->host.c_str(), std::to_string(place->port).c_str(), &hints, &found);
  if (problem != 0) {
    throw InputError(std::string("this address is not known (") + gai_strerror(problem) + ")", where,
                     "give an address of this computer");
  }
  int descriptor = -1;
  int failure = 0;
  for (const addrinfo* each = found; each != nullptr && descriptor < 0; each = each->ai_next) {
    descriptor = socket(each->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (descriptor >= 0 && bind(descriptor, each->ai_addr, each->ai_addrlen) != 0) {
      failure = errno;
      close(descriptor);
      descriptor = -1;
    }
  }
  freeaddrinfo(found);
  if (descriptor < 0) {
    throw WorkError(std::string("datagrams cannot be received there (") + std::strerror(failure) + ")", where,
                    "another port, or an address that this computer has");
  }
  return std::make_unique<UdpGaze>(descriptor);
}

}  // namespace

GazeInputKind udpGaze() {
  return {"udp", "udp:HOST:PORT[,norm]", "datagrams to that address of this computer, of one line or several", openUdp};
}

}  // namespace ocelli
