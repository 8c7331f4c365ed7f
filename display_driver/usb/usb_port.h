// Displays on USB: finds them by class, subclass and protocol of an interface (docs/wire_protocol.md), and opens links
// to them. Built on libusb's asynchronous transfers; a port has a thread of its own, on which all that its links report
// is called.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "display_driver/wire/link.h"

namespace ocelli {

/// A display that is plugged in.
struct UsbDisplay {
  std::string serial;  ///< empty where it has none, or it cannot be asked
  std::string name;    ///< what the device calls itself; empty likewise
  uint16_t vendor = 0;
  uint16_t product = 0;
  std::string link;     ///< "USB 2, 480 Mbit/s, bus 1 port 2"
  std::string problem;  ///< why it cannot be opened; empty where it can
};

/// Throws wire::LinkError where USB cannot be used at all.
std::vector<UsbDisplay> listUsbDisplays();

struct UsbPortOptions {
  std::string serial = "";                      ///< of the display to look for; empty: the first one that is found
  std::chrono::milliseconds sendTimeout{2000};  ///< for any of the bytes under way to arrive
  std::chrono::milliseconds requestTimeout{1000};
};

class UsbPort final : public wire::LinkPort {
 public:
  /// Throws wire::LinkError where USB cannot be used at all.
  explicit UsbPort(UsbPortOptions options);
  ~UsbPort() override;

  std::string description() const override;
  std::unique_ptr<wire::Link> open() override;
  void waitForArrival(std::chrono::milliseconds timeout) override;
  void wake() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Transfers of all links of this process that exist now: none once all links are closed. For tests.
size_t usbTransfersAlive();

}  // namespace ocelli
