#include "display_driver/devices/device_kinds.h"

#include <algorithm>

#include "display_driver/device/file_device.h"
#include "display_driver/device/null_device.h"
#include "display_driver/devices/multivox_device.h"
#include "display_driver/serial/serial_link.h"
#ifdef OCELLI_WITH_USB
#include "display_driver/usb/usb_port.h"
#include "display_driver/wire/stream_device.h"
#endif
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Rest = DeviceKind::Rest;

DisplayProfile profileOf(const DeviceOptions& options, const char* otherwise = "perspecta") {
  return options.profile ? *options.profile : loadProfile(otherwise);
}

std::unique_ptr<Device> openSim(const DeviceOptions& options) {
  SimOptions sim;
  if (options.sim) {
    sim = *options.sim;
  }
  sim.display.firmware.profile = profileOf(options);
  return openSimDevice(sim);
}

#ifdef OCELLI_WITH_USB
std::unique_ptr<Device> openUsb(const std::string& serial) {
  try {
    UsbPortOptions port;
    port.serial = serial;
    StreamOptions stream;
    stream.kind = "usb";
    return openStreamDevice(std::make_unique<UsbPort>(port), stream);
  } catch (const wire::LinkError& error) {
    throw WorkError(error.what(), serial.empty() ? "usb" : "usb:" + serial, "ocelli device list");
  }
}
#endif

std::string allUsages() {
  std::string all;
  for (const DeviceKind& kind : deviceKinds()) {
    all += (all.empty() ? "" : ", ") + kind.usage();
  }
  return all;
}

std::vector<DeviceKind> builtinDevices() {
  return {
      {"file", Rest::kRequired, "PATH.svol", "a recording of what is shown",
       [](const std::string& rest, const DeviceOptions& options) { return openFileDevice(rest, profileOf(options)); }},
      {"multivox", Rest::kOptional, "NAME|HOST[:PORT]",
       "a display or simulator of the multivox project, in shared memory or on the network",
       [](const std::string& rest, const DeviceOptions& options) {
         return openMultivox(rest, profileOf(options, "vortex"));
       }},
      {"null", Rest::kNone, "", "takes everything and shows it nowhere, at the display's rate",
       [](const std::string&, const DeviceOptions& options) { return openNullDevice(profileOf(options)); }},
      {"serial", Rest::kRequired, "DEVICE[,baud=RATE]",
       "a display on a serial line; it says itself which profile it has",
       [](const std::string& rest, const DeviceOptions&) { return openSerialDevice(rest); }},
      {"sim", Rest::kNone, "", "a simulated display, which gets the bytes that hardware would get",
       [](const std::string&, const DeviceOptions& options) { return openSim(options); }},
#ifdef OCELLI_WITH_USB
      {"usb", Rest::kOptional, "SERIAL", "a display on USB; it says itself which profile it has",
       [](const std::string& rest, const DeviceOptions&) { return openUsb(rest); }},
#endif
  };
}

Registry<DeviceKind>& deviceRegistry() {
  static Registry<DeviceKind> registry("device", builtinDevices());
  return registry;
}

}  // namespace

std::string DeviceKind::usage() const {
  switch (rest) {
    case Rest::kNone:
      return name;
    case Rest::kOptional:
      return name + "[:" + restName + "]";
    case Rest::kRequired:
      return name + ":" + restName;
  }
  return name;
}

Rows<DeviceKind> deviceKinds() {
  return deviceRegistry().rows();
}

void registerDevice(DeviceKind kind) {
  if (kind.name.empty() || kind.name.find(':') != std::string::npos) {
    throw InputError("a device cannot have this name", "\"" + kind.name + "\"", "give it a name without a colon");
  }
  if (!kind.open) {
    throw InputError("this device has no function that opens it", kind.name, "set `open` of its row");
  }
  deviceRegistry().add(std::move(kind));
}

std::unique_ptr<Device> openDevice(const std::string& text, const DeviceOptions& options) {
  const size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  const Rows<DeviceKind> kinds = deviceKinds();
  const auto found = std::ranges::find(kinds, name, &DeviceKind::name);
  if (found == kinds.end()) {
    throw InputError("there is no such device", text, "one of " + allUsages());
  }
  const DeviceKind& kind = *found;
  if (kind.rest == Rest::kNone && colon != std::string::npos) {
    throw InputError("nothing follows the name of this device", text, kind.usage());
  }
  if (kind.rest == Rest::kRequired && rest.empty()) {
    throw InputError("this device needs " + kind.restName, text, kind.usage());
  }
  return kind.open(rest, options);
}

}  // namespace ocelli
