// A device of each kind, for the tests that run over all of them.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "display_driver/devices/device_kinds.h"
#include "display_driver/serial/pty_display.h"
#include "tests/display_driver_devices/acted_display.h"
#include "tests/display_driver_devices/acted_receiver.h"

namespace ocelli::test {

/// A small display that turns fast: a refresh takes 5 ms.
inline DisplayProfile fastProfile() {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = 10;
  profile.width = 24;
  profile.height = 16;
  profile.rotationsPerMinute = 6000;
  return profile;
}

struct TestDevice {
  /// What follows the name; nullptr: displays on USB, which tests/display_driver_usb tests on an emulated bus.
  std::function<std::string(const std::string& folder)> rest;
  bool tellsRotation = false;
  std::function<std::shared_ptr<void>()> surroundings{};  ///< what must be there while it is open
  const char* kind = nullptr;                             ///< where that is not what the row is called
};

inline std::string serialLine() {
  return (std::filesystem::temp_directory_path() / ("ocelli_serial_" + std::to_string(getpid()))).string();
}

/// By kind, and further ways of one. A new kind needs a line here.
inline const std::map<std::string, TestDevice>& testDevices() {
  static const std::string memory = uniqueObject();
  static std::string receiver;
  static const std::map<std::string, TestDevice> devices = {
      {"file", {[](const std::string& folder) { return ":" + folder + "/shown.svol"; }, true}},
      {"multivox",
       {[](const std::string&) { return ":" + memory; }, false, [] { return std::make_shared<ActedDisplay>(memory); }}},
      {"multivox_network",
       {[](const std::string&) { return ":" + receiver; }, false,
        [] {
          auto acted = std::make_shared<ActedReceiver>();
          receiver = acted->place();
          return acted;
        },
        "multivox"}},
      {"null", {[](const std::string&) { return std::string(); }, true}},
      {"serial",
       {[](const std::string&) { return ":" + serialLine() + ",baud=921600"; }, true,
        [] {
          EmulatedDeviceOptions options;
          options.firmware.profile = fastProfile();
          return std::make_shared<PtyDisplay>(options, serialLine());
        }}},
      {"sim", {[](const std::string&) { return std::string(); }, true}},
      {"usb", {nullptr}},
  };
  return devices;
}

}  // namespace ocelli::test
