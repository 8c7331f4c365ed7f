// What subjects answer with besides the keyboard and mouse of the window, a row each: `ocelli study run --responses
// gamepad`, `--responses serial:/dev/ttyUSB0,115200,1=1,2=2`. What a device sends becomes keys, so that every task can
// be answered with every device. A box that is a keyboard needs nothing here.
//
// Recipe for a new kind of device, two places and a line:
//   1. study/responses/NAME_responses.cpp: a ResponseDevice and a function that makes its row.
//   2. study/responses/response_devices.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its row in docs/responses.md.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/gamepad_state.h"
#include "study/responses/key_change.h"

namespace ocelli {

struct ResponseCounts {
  int64_t presses = 0;
  int64_t unknown = 0;  ///< bytes or buttons that no key stands for
};

class ResponseDevice {
 public:
  virtual ~ResponseDevice() = default;

  /// What changed since the last call, in order. Never waits. By one thread.
  virtual std::vector<KeyChange> take() = 0;
  /// Looks at a device that tells nothing by itself: on the main thread, every few milliseconds.
  virtual void poll() {}
  virtual bool mustBePolled() const { return false; }

  /// For a test of latency: sends a byte that the device may answer. False where it cannot.
  virtual bool send(uint8_t /*byte*/) { return false; }

  virtual bool isConnected() const = 0;
  virtual ResponseCounts counts() const = 0;
  /// For records: "serial:/dev/ttyUSB0, 115200 bits a second, low latency".
  virtual std::string description() const = 0;
};

/// What devices need of the system beside files.
struct ResponseTools {
  /// The first gamepad that is connected; nothing where there is none. On the main thread. Empty: there are no
  /// gamepads.
  std::function<std::optional<GamepadState>()> readGamepad{};
};

struct ResponseDeviceKind {
  std::string name;         ///< before the first colon: "serial"
  std::string form;         ///< "serial:DEVICE[,BAUD][,BYTE=KEY...]"
  std::string description;  ///< for people
  /// Of what stands after the colon, empty where there is none. Throws InputError for a text that is wrong, WorkError
  /// where the device is not there.
  std::unique_ptr<ResponseDevice> (*open)(const std::string& text, const ResponseTools& tools) = nullptr;
};

const std::vector<ResponseDeviceKind>& responseDeviceKinds();
/// "gamepad[:BUTTON=KEY,...], serial:DEVICE[,BAUD][,BYTE=KEY...]".
std::string responseDeviceForms();
/// Throws as open() does, and InputError for a kind that there is not.
std::unique_ptr<ResponseDevice> openResponseDevice(const std::string& text, const ResponseTools& tools);

}  // namespace ocelli
