#include "oc_core/base/serial_port.h"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

struct BaudRate {
  int bitsPerSecond;
  speed_t speed;
};
constexpr std::array kRates{BaudRate{9600, B9600},       BaudRate{19200, B19200},     BaudRate{38400, B38400},
                            BaudRate{57600, B57600},     BaudRate{115200, B115200},   BaudRate{230400, B230400},
                            BaudRate{460800, B460800},   BaudRate{921600, B921600},   BaudRate{1000000, B1000000},
                            BaudRate{1500000, B1500000}, BaudRate{2000000, B2000000}, BaudRate{3000000, B3000000}};

bool askForLowLatency(int descriptor) {
  serial_struct settings{};
  if (ioctl(descriptor, TIOCGSERIAL, &settings) != 0) {
    return false;
  }
  settings.flags |= ASYNC_LOW_LATENCY;
  return ioctl(descriptor, TIOCSSERIAL, &settings) == 0;
}

}  // namespace

std::string baudRatesText() {
  std::string text;
  for (size_t i = 0; i < kRates.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == kRates.size() ? " or " : ", ") + std::to_string(kRates[i].bitsPerSecond);
  }
  return text;
}

SerialPlace serialPlaceFromText(const std::string& text, const std::string& where) {
  const size_t comma = text.rfind(',');
  SerialPlace place{text.substr(0, comma)};
  if (comma != std::string::npos) {
    place.bitsPerSecond =
        numberFromText<decltype(place.bitsPerSecond)>(std::string_view(text).substr(comma + 1)).value_or(0);
  }
  const bool isKnown = std::ranges::find(kRates, place.bitsPerSecond, &BaudRate::bitsPerSecond) != kRates.end();
  if (place.device.empty() || !isKnown) {
    throw InputError("must be a device, and may have a rate of " + baudRatesText(), where,
                     "such as serial:/dev/ttyUSB0,115200");
  }
  return place;
}

SerialPort::SerialPort(const SerialPlace& place, const std::string& where) {
  const auto* const rate = std::ranges::find(kRates, place.bitsPerSecond, &BaudRate::bitsPerSecond);
  descriptor_ = open(place.device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw WorkError(std::string("the device cannot be opened (") + std::strerror(errno) + ")", where,
                    "check that it is plugged in, and that you are in the group of the device (often dialout)");
  }
  termios settings{};
  if (tcgetattr(descriptor_, &settings) != 0) {
    close(descriptor_);
    throw InputError("this is no serial device", where, "such as serial:/dev/ttyUSB0");
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL;
  cfsetspeed(&settings, rate == kRates.end() ? B115200 : rate->speed);
  if (tcsetattr(descriptor_, TCSANOW, &settings) != 0) {
    const int problem = errno;
    close(descriptor_);
    throw WorkError(std::string("the device does not take this rate (") + std::strerror(problem) + ")", where,
                    "another rate, as its manual says");
  }
  lowLatency_ = askForLowLatency(descriptor_);
}

SerialPort::~SerialPort() {
  close(descriptor_);
}

bool SerialPort::send(unsigned char byte) const {
  return write(descriptor_, &byte, 1) == 1;
}

}  // namespace ocelli
