// Devices by name: "null", "file:out.svol". The recipe for a new one stands in display_driver/device/device.h. A
// program outside of the tree registers one of its own with registerDevice(): examples/add_a_device.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/devices/sim_device.h"
#include "oc_core/base/registry.h"

namespace ocelli {

struct DeviceOptions {
  /// For devices that do not have a display of their own; nullopt: what such a device takes best.
  std::optional<DisplayProfile> profile{};
  /// What the simulated display is like, and who hears of what it shows. Its profile is the one above. nullopt: an
  /// ideal one.
  std::optional<SimOptions> sim = std::nullopt;
};

struct DeviceKind {
  enum class Rest { kNone, kOptional, kRequired };

  std::string name;
  Rest rest = Rest::kNone;  ///< whether anything follows the name, after a colon
  std::string restName{};   ///< "PATH.svol", for people; empty where nothing follows
  std::string help{};       ///< one line
  /// `rest` is what follows the colon; empty where nothing does. Called from any thread.
  std::function<std::unique_ptr<Device>(const std::string& rest, const DeviceOptions& options)> open{};

  /// "file:PATH.svol", "usb[:SERIAL]"
  std::string usage() const;
};

/// The built-in ones, then those that were registered. A row stays where it is until the program ends. Any thread may
/// call it at any time.
Rows<DeviceKind> deviceKinds();

/// Adds a kind: from then on openDevice() knows its name. Any thread may call it at any time. Throws InputError where
/// the name is empty, is taken, or holds a colon, which ends names, and where there is no function that opens it.
void registerDevice(DeviceKind kind);

/// `text` is NAME or NAME:REST. Throws InputError for names of no device and what its kind says of the rest, WorkError
/// where the device cannot be opened.
std::unique_ptr<Device> openDevice(const std::string& text, const DeviceOptions& options = {});

}  // namespace ocelli
