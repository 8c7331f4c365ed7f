// A byte a marker, its code, to a serial device: what boxes for TTL triggers take.
#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "oc_core/base/error.h"
#include "study/markers/marker_output.h"

namespace ocelli {
namespace {

struct BaudRate {
  int bitsPerSecond;
  speed_t speed;
};
constexpr std::array kRates{BaudRate{9600, B9600},     BaudRate{19200, B19200},   BaudRate{38400, B38400},
                            BaudRate{57600, B57600},   BaudRate{115200, B115200}, BaudRate{230400, B230400},
                            BaudRate{460800, B460800}, BaudRate{921600, B921600}};
constexpr int kUsualRate = 115200;

class SerialMarkers : public MarkerOutput {
 public:
  explicit SerialMarkers(int descriptor) : device_(descriptor) {}
  ~SerialMarkers() override { close(device_); }
  SerialMarkers(const SerialMarkers&) = delete;
  SerialMarkers& operator=(const SerialMarkers&) = delete;

  void send(const Marker& marker) override {
    const bool done = write(device_, &marker.code.code, 1) == 1;
    ++(done ? counts_.sent : counts_.lost);
  }
  MarkerCounts counts() const override { return counts_; }

 private:
  int device_;
  MarkerCounts counts_{};
};

std::unique_ptr<MarkerOutput> openSerial(const std::string& text) {
  const std::string where = "--markers serial:" + text;
  const size_t comma = text.rfind(',');
  const std::string path = text.substr(0, comma);
  int rate = kUsualRate;
  if (comma != std::string::npos) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + comma + 1, end, rate);
    rate = read.ec == std::errc() && read.ptr == end ? rate : 0;
  }
  const auto* const known = std::ranges::find(kRates, rate, &BaudRate::bitsPerSecond);
  if (path.empty() || known == kRates.end()) {
    throw InputError(
        "must be a device, and may have a rate of 9600, 19200, 38400, 57600, 115200, 230400, 460800 or 921600", where,
        "such as serial:/dev/ttyUSB0,115200");
  }
  const int device = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (device < 0) {
    throw WorkError(fmt::format("the device cannot be opened ({})", std::strerror(errno)), where,
                    "check that it is plugged in, and that you are in the group of the device (often dialout)");
  }
  termios settings{};
  if (tcgetattr(device, &settings) != 0) {
    close(device);
    throw InputError("this is no serial device", where, "such as serial:/dev/ttyUSB0");
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL;
  cfsetspeed(&settings, known->speed);
  if (tcsetattr(device, TCSANOW, &settings) != 0) {
    close(device);
    throw WorkError(fmt::format("the device does not take this rate ({})", std::strerror(errno)), where,
                    "another rate, as its manual says");
  }
  return std::make_unique<SerialMarkers>(device);
}

}  // namespace

MarkerOutputKind serialOutput() {
  return {"serial", "serial:DEVICE[,BAUD]",
          "a byte for each marker, its code; 115200 bits a second where no rate is given", openSerial};
}

}  // namespace ocelli
