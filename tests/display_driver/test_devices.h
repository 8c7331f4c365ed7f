// A device of each kind, for the tests that run over all of them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "display_driver/device_kinds.h"

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
  std::string reason;  ///< why, where it cannot be opened here
};

/// By name. A new kind needs a line here.
inline const std::map<std::string, TestDevice>& testDevices() {
  static const std::map<std::string, TestDevice> devices = {
      {"file", {[](const std::string& folder) { return ":" + folder + "/shown.svol"; }, ""}},
      {"null", {[](const std::string&) { return std::string(); }, ""}},
  };
  return devices;
}

}  // namespace ocelli::test
