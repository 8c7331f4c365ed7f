// `ocelli device emulate`: an emulated display on an emulated USB, for a program that believes in it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <thread>

#include "cli/command.h"
#include "cli/device_command.h"
#include "cli/emulated_display.h"
#include "cli/interrupt.h"
#include "cli/shown_output.h"
#include "display_driver/emulator/client_process.h"
#include "display_driver/emulator/emulation_log.h"
#include "display_driver/emulator/usb_device_record.h"
#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct EmulateChoice {
  std::string profile = "perspecta";
  EmulatedDisplayChoice display;
  std::string serial = "EMULATED";
  ShownChoice shown;
  std::vector<std::string> command;
};

constexpr const char* kLink = "usb2";

EmulatedUsbDisplay emulatedUsbDisplay(const EmulateChoice& choice) {
  requireSerial(choice.serial);
  EmulatedUsbDisplay display;
  display.device = emulatedDisplay(choice.display, kLink);
  display.device.firmware.profile = loadProfile(choice.profile);
  display.device.firmware.serial = choice.serial;
  const double rate = display.device.bytesPerSecond;
  display.speed = rate == 0 || rate > wire::kUsb2BytesPerSecond ? EmulatedSpeed::kUsb3 : EmulatedSpeed::kUsb2;
  return display;
}

/// This program itself, where the command is called as it is.
std::vector<std::string> resolved(std::vector<std::string> command) {
  if (command.front() == "ocelli") {
    command.front() = std::filesystem::read_symlink("/proc/self/exe").string();
  }
  return command;
}

std::string report(UsbEmulator& emulator, const EmulationLog& log) {
  std::string text;
  std::string lastError;
  emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds now) {
    for (const EmulatedDevice::HappenedFault& fault : device.happened()) {
      text += fmt::format("{:>9.3f} s  {}", static_cast<double>(fault.begin) * 1e-6, nameOf(fault.fault.kind));
      text += fault.end > fault.begin
                  ? fmt::format(", for {:.0f} ms\n", static_cast<double>(fault.end - fault.begin) * 1e-3)
                  : "\n";
    }
    const auto answer =
        device.firmware().controlIn(static_cast<uint8_t>(wire::Request::kTelemetry), 0, wire::kTelemetryBytes, now);
    const auto telemetry = wire::telemetryFrom(answer.value_or(std::vector<uint8_t>()));
    if (telemetry && telemetry->lastError != wire::ErrorCode::kNone) {
      lastError = nameOf(telemetry->lastError);
    }
  });
  const EmulationCounts counts = log.counts();
  text += fmt::format("frames arrived {}, shown {}; {} of {} refreshes lit, {} torn\n", counts.framesArrived,
                      counts.framesShown, counts.litRefreshes, counts.refreshes, counts.tornRefreshes);
  return lastError.empty() ? text : fmt::format("{}last error: {}\n", text, lastError);
}

void waitForInterrupt(const CommandContext& context, const UsbEmulator& emulator) {
  std::string variables;
  for (const auto& [name, value] : emulator.environment()) {
    variables += fmt::format("{}={} ", name, value);
  }
  context.print(
      fmt::format("The display is plugged in for programs that are started like this:\n  {}ocelli device list\n"
                  "Ctrl-C ends it.\n",
                  variables));
  flushStandardOutput();
  const InterruptGuard guard;
  while (!InterruptGuard::interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

int emulate(const CommandContext& context, const EmulateChoice& choice) {
  const EmulatedUsbDisplay display = emulatedUsbDisplay(choice);
  UsbEmulator::requirePreloaded();
  ShownOutput shown(choice.shown, display.device.firmware.profile);
  EmulationLog log(shown.sink());
  int code = 0;
  {
    UsbEmulator emulator({display});
    emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds) {
      device.firmware().setSink(&log);
      device.firmware().setArrivalSink(&log);
    });
    if (choice.command.empty()) {
      waitForInterrupt(context, emulator);
    } else {
      code = runClient(resolved(choice.command), emulator.environment());
    }
    context.note(report(emulator, log));
  }
  shown.finish(context);
  return code;
}

}  // namespace

void addDeviceEmulate(CLI::App& device, const CommandContext& context) {
  const auto choice = std::make_shared<EmulateChoice>();
  CLI::App& command = *device.add_subcommand("emulate", "Run a program with an emulated display on an emulated USB");
  command.add_option("COMMAND", choice->command, "The program and its arguments, after --; none: until Ctrl-C");
  command.add_option("--profile", choice->profile, "The display: a name, or a JSON file");
  addEmulatedDisplayOptions(command, choice->display, kLink);
  command.add_option("--serial", choice->serial, "Serial number of the display");
  addShownOptions(command, choice->shown);
  context.finish(
      command,
      "  ocelli device emulate -- ocelli device list\n"
      "  ocelli device emulate --faults random:7 --shown shown -- ocelli present builtin:teapot --device usb",
      [context, choice] {
        if (const int code = emulate(context, *choice); code != 0) {
          throw ExitCode{code};
        }
      });
}

}  // namespace ocelli
