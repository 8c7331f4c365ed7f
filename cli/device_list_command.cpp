// `ocelli device list` and `ocelli device info`: which displays there are, and what one says of itself.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/device_command.h"
#include "display_driver/devices/device_kinds.h"
#include "oc_core/base/json_fields.h"
#ifdef OCELLI_WITH_OPENGL
#include "display_driver/picture_device/picture_devices.h"
#endif
#ifdef OCELLI_WITH_USB
#include "display_driver/usb/usb_port.h"
#endif

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct UsbDisplays {
  Json displays = Json::array();
  std::string problem;  ///< of USB as a whole; empty: none
};

UsbDisplays usbDisplays() {
  UsbDisplays findings;
#ifdef OCELLI_WITH_USB
  try {
    for (const UsbDisplay& display : listUsbDisplays()) {
      findings.displays.push_back({{"device", display.serial.empty() ? "usb" : "usb:" + display.serial},
                                   {"name", display.name},
                                   {"serial", display.serial},
                                   {"link", display.link},
                                   {"vendor", fmt::format("{:04x}", display.vendor)},
                                   {"product", fmt::format("{:04x}", display.product)},
                                   {"problem", display.problem}});
    }
  } catch (const wire::LinkError& error) {
    findings.problem = error.what();
  }
#else
  findings.problem = "this program was built without USB (OCELLI_WITH_USB)";
#endif
  return findings;
}

Json jsonOfKinds() {
  Json kinds = Json::array();
  for (const DeviceKind& kind : deviceKinds()) {
    kinds.push_back({{"device", kind.usage()}, {"help", kind.help}});
  }
#ifdef OCELLI_WITH_OPENGL
  for (const PictureDeviceKind& kind : pictureDeviceKinds()) {
    kinds.push_back({{"device", kind.usage()}, {"help", kind.help}});
  }
#endif
  return kinds;
}

std::string listText(const UsbDisplays& usb) {
  std::string text;
  for (const DeviceKind& kind : deviceKinds()) {
    const std::string usage = kind.usage();
    text += fmt::format("{:<18}{}{}\n", usage, usage.size() > 18 ? "\n" + std::string(19, ' ') : " ", kind.help);
  }
#ifdef OCELLI_WITH_OPENGL
  for (const PictureDeviceKind& kind : pictureDeviceKinds()) {
    text += fmt::format("{}\n{:<18} {}\n", kind.usage(), "", kind.help);
  }
#endif
  text += "\n";
  for (const Json& display : usb.displays) {
    text += fmt::format("{:<18} {}, {}\n", display["device"].get<std::string>(), display["name"].get<std::string>(),
                        display["link"].get<std::string>());
    if (const std::string problem = display["problem"]; !problem.empty()) {
      text += fmt::format("  {}\n", problem);
    }
  }
  if (usb.displays.empty()) {
    text +=
        usb.problem.empty() ? "No display on USB was found.\n" : fmt::format("No display on USB: {}\n", usb.problem);
  }
  return text;
}

Json jsonOf(const DisplayProfile& profile) {
  return {{"name", profile.name},
          {"slices", profile.slicesPerHalfTurn},
          {"width", profile.width},
          {"height", profile.height},
          {"bits_per_channel", profile.colorBitsPerChannel},
          {"rotations_per_minute", profile.rotationsPerMinute}};
}

Json infoOf(Device& device) {
  const DeviceInfo& info = device.info();
  const Telemetry telemetry = device.telemetry();
  Json json = {{"kind", info.kind},
               {"name", info.name},
               {"serial", info.serial},
               {"link", info.link},
               {"profile", jsonOf(device.profile())},
               {"connected", telemetry.connected},
               {"rotations_per_minute", telemetry.rotationsPerMinute},
               {"phase_error_degrees", telemetry.phaseErrorDegrees}};
  json["fault"] = telemetry.fault.empty() ? Json(nullptr) : Json(telemetry.fault);
  json["temperature_celsius"] = telemetry.temperatureCelsius ? Json(*telemetry.temperatureCelsius) : Json(nullptr);
  return json;
}

std::string infoText(const Json& info) {
  std::string text;
  for (const auto& [key, value] : info.items()) {
    if (value.is_object()) {
      for (const auto& [part, inner] : value.items()) {
        text += fmt::format("{:<30} {}\n", fmt::format("{}.{}", key, part),
                            inner.is_string() ? inner.get<std::string>() : textOfJson(inner));
      }
    } else if (!value.is_null()) {
      text += fmt::format("{:<30} {}\n", key, value.is_string() ? value.get<std::string>() : textOfJson(value));
    }
  }
  return text;
}

}  // namespace

void addDeviceList(CLI::App& device, const CommandContext& context) {
  const auto json = std::make_shared<bool>(false);
  CLI::App& command = *device.add_subcommand("list", "What --device takes, and the displays on USB");
  command.add_flag("--json", *json, "Print JSON");
  context.finish(command, "  ocelli device list", [context, json] {
    const UsbDisplays usb = usbDisplays();
    context.print(
        *json ? textOfJson({{"devices", jsonOfKinds()}, {"usb", usb.displays}, {"usb_problem", usb.problem}}, 2) + "\n"
              : listText(usb));
  });
}

void addDeviceInfo(CLI::App& device, const CommandContext& context) {
  struct Choice {
    std::string device = "usb";
    bool json = false;
  };
  const auto choice = std::make_shared<Choice>();
  CLI::App& command = *device.add_subcommand("info", "What a display says of itself");
  command.add_option("DEVICE", choice->device, "As of ocelli device list");
  command.add_flag("--json", choice->json, "Print JSON");
  context.finish(command, "  ocelli device info\n  ocelli device info usb:42 --json", [context, choice] {
    const std::unique_ptr<Device> opened = openDevice(choice->device);
    const Json info = infoOf(*opened);
    opened->close();
    context.print(choice->json ? textOfJson(info, 2) + "\n" : infoText(info));
  });
}

}  // namespace ocelli
