// A link of the wire protocol over a serial line (docs/serial_protocol.md), to a display that is a microcontroller with
// a UART, or one that USB shows as a serial device.
#pragma once

#include <memory>
#include <string>

#include "display_driver/device/device.h"
#include "display_driver/wire/link.h"

namespace ocelli {

/// Finds the display at `place`, "DEVICE[,baud=RATE]", again and again. Throws InputError for a rate that is none.
std::unique_ptr<wire::LinkPort> serialPort(const std::string& place);

/// Connects now, to whatever profile the display has. Throws InputError, and WorkError where nothing answers.
std::unique_ptr<Device> openSerialDevice(const std::string& place);

}  // namespace ocelli
