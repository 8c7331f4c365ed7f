// `ocelli device emulate`: an emulated display on an emulated USB, or on a pseudo-terminal as if it were a serial line,
// for a program that believes in it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
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
#include "display_driver/serial/pty_display.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct EmulateChoice {
  std::string profile = "perspecta";
  EmulatedDisplayChoice display;
  std::string serial = "EMULATED";
  std::string tty;  ///< empty: on USB
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

/// Calls what it is given with the display while nothing else does.
using UseDisplay = std::function<void(const std::function<void(EmulatedDevice&, DeviceMicroseconds)>&)>;

std::string report(const UseDisplay& useDisplay, const EmulationLog& log) {
  std::string text;
  std::string lastError;
  useDisplay([&](EmulatedDevice& device, DeviceMicroseconds now) {
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

void waitForInterrupt(const CommandContext& context, const std::string& text) {
  context.print(text + "Ctrl-C ends it.\n");
  flushStandardOutput();
  const InterruptGuard guard;
  while (!InterruptGuard::interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

int runOrWait(const CommandContext& context, const EmulateChoice& choice, const UseDisplay& useDisplay,
              const std::vector<std::pair<std::string, std::string>>& environment, const std::string& text,
              EmulationLog& log) {
  useDisplay([&](EmulatedDevice& device, DeviceMicroseconds) {
    device.firmware().setSink(&log);
    device.firmware().setArrivalSink(&log);
  });
  int code = 0;
  if (choice.command.empty()) {
    waitForInterrupt(context, text);
  } else {
    code = runClient(resolved(choice.command), environment);
  }
  context.note(report(useDisplay, log));
  return code;
}

int emulateOnUsb(const CommandContext& context, const EmulateChoice& choice, const EmulatedUsbDisplay& display,
                 EmulationLog& log) {
  UsbEmulator emulator({display});
  std::string variables;
  for (const auto& [name, value] : emulator.environment()) {
    variables += fmt::format("{}={} ", name, value);
  }
  return runOrWait(
      context, choice, [&](const auto& use) { emulator.use(0, use); }, emulator.environment(),
      fmt::format("The display is plugged in for programs that are started like this:\n  {}ocelli device list\n",
                  variables),
      log);
}

int emulateOnTerminal(const CommandContext& context, const EmulateChoice& choice, const EmulatedUsbDisplay& display,
                      EmulationLog& log) {
  PtyDisplay emulator(display.device, choice.tty);
  return runOrWait(
      context, choice, [&](const auto& use) { emulator.withDevice(use); }, {},
      fmt::format("The display is there:\n  ocelli present builtin:teapot --device serial:{}\n", choice.tty), log);
}

int emulate(const CommandContext& context, const EmulateChoice& choice) {
  const EmulatedUsbDisplay display = emulatedUsbDisplay(choice);
  if (choice.tty.empty()) {
    UsbEmulator::requirePreloaded();
  }
  ShownOutput shown(choice.shown, display.device.firmware.profile);
  EmulationLog log(shown.sink());
  const int code = choice.tty.empty() ? emulateOnUsb(context, choice, display, log)
                                      : emulateOnTerminal(context, choice, display, log);
  shown.finish(context);
  return code;
}

}  // namespace

void addDeviceEmulate(CLI::App& device, const CommandContext& context) {
  const auto choice = std::make_shared<EmulateChoice>();
  CLI::App& command = *device.add_subcommand(
      "emulate", "Run a program with an emulated display on an emulated USB, or on a serial line");
  command.add_option("COMMAND", choice->command, "The program and its arguments, after --; none: until Ctrl-C");
  command.add_option("--profile", choice->profile, "The display: a name, or a JSON file");
  addEmulatedDisplayOptions(command, choice->display, kLink);
  command.add_option("--serial", choice->serial, "Serial number of the display");
  command.add_option("--tty", choice->tty, "A serial line instead of USB: a link to the display's pseudo-terminal")
      ->type_name("PATH");
  addShownOptions(command, choice->shown);
  context.finish(
      command,
      "  ocelli device emulate -- ocelli device list\n"
      "  ocelli device emulate --profile test --tty /tmp/display -- ocelli present builtin:teapot --device "
      "serial:/tmp/display\n"
      "  ocelli device emulate --faults random:7 --shown shown -- ocelli present builtin:teapot --device usb",
      [context, choice] {
        if (const int code = emulate(context, *choice); code != 0) {
          throw ExitCode{code};
        }
      });
}

}  // namespace ocelli
