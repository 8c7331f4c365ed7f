// A serial device, opened raw: every byte as it is, 8 data bits, no parity.
#pragma once

#include <string>

namespace ocelli {

inline constexpr int kUsualBaudRate = 115200;

/// "9600, 19200, ... or 3000000".
std::string baudRatesText();

struct SerialPlace {
  std::string device;  ///< "/dev/ttyUSB0"
  int bitsPerSecond = kUsualBaudRate;
};
/// "DEVICE[,BAUD]". `where` is for messages: what the user wrote. Throws InputError.
SerialPlace serialPlaceFromText(const std::string& text, const std::string& where);

/// An open device; reading and writing never wait.
class SerialPort {
 public:
  /// Throws InputError for what is no serial device, WorkError where it cannot be opened or does not take the rate.
  SerialPort(const SerialPlace& place, const std::string& where);
  ~SerialPort();
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  int descriptor() const { return descriptor_; }
  /// Whether the driver was asked to hand bytes over at once, and took it. USB converters collect them otherwise, for
  /// 16 milliseconds in the case of FTDI's.
  bool hasLowLatency() const { return lowLatency_; }
  /// False where it could not be handed over at once.
  bool send(unsigned char byte) const;

 private:
  int descriptor_ = -1;
  bool lowLatency_ = false;
};

}  // namespace ocelli
