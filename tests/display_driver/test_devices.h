// A device of each kind, for the tests that run over all of them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "display_driver/device_kinds.h"
#include "tests/display_driver_multivox/acted_display.h"

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
  /// What follows the name; nullptr: this kind needs what these tests do not have.
  std::function<std::string(const std::string& folder)> rest;
  std::string reason{};                                   ///< why, where it cannot be opened here
  std::function<std::shared_ptr<void>()> surroundings{};  ///< what must be there while it is open
};

/// By name. A new kind needs a line here.
inline const std::map<std::string, TestDevice>& testDevices() {
  static const std::string memory = uniqueObject();
  static const std::map<std::string, TestDevice> devices = {
      {"file", {[](const std::string& folder) { return ":" + folder + "/shown.svol"; }}},
      {"multivox",
       {[](const std::string&) { return ":" + memory; }, "", [] { return std::make_shared<ActedDisplay>(memory); }}},
      {"null", {[](const std::string&) { return std::string(); }}},
      {"sim", {[](const std::string&) { return std::string(); }}},
      {"usb", {nullptr, "displays on USB are tested in tests/display_driver_usb, on an emulated bus"}},
  };
  return devices;
}

}  // namespace ocelli::test
