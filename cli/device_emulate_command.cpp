// `ocelli device emulate`: an emulated display on an emulated USB, for a program that believes in it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <thread>

#include "cli/command.h"
#include "cli/device_command.h"
#include "cli/interrupt.h"
#include "display_driver/emulator/client_process.h"
#include "display_driver/emulator/emulation_log.h"
#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/sim/shown_recorder.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct EmulateChoice {
  std::string profile = "perspecta";
  std::string link = "usb2";
  std::string faults;
  std::string serial = "EMULATED";
  double jitter = 0;
  std::string output;
  std::vector<std::string> command;
};

// Of scripts that are drawn at random.
constexpr size_t kRandomFaults = 20;
constexpr DeviceMicroseconds kRandomFaultsOver = 10'000'000;

FaultScript faultScript(const std::string& text) {
  constexpr std::string_view kRandom = "random:";
  if (text.empty()) {
    return {};
  }
  if (!text.starts_with(kRandom)) {
    return readFaultScript(text);
  }
  const std::string seed = text.substr(kRandom.size());
  if (seed.empty() || seed.size() > 18 || seed.find_first_not_of("0123456789") != std::string::npos) {
    throw InputError("the seed of random faults is a whole number", text, "--faults random:1");
  }
  return randomFaults(std::stoull(seed), kRandomFaults, kRandomFaultsOver);
}

EmulatedUsbDisplay emulatedDisplay(const EmulateChoice& choice) {
  EmulatedUsbDisplay display;
  display.device.firmware.profile = loadProfile(choice.profile);
  display.device.firmware.serial = choice.serial;
  display.device.firmware.rotor.jitter = choice.jitter / 100;
  display.device.faults = faultScript(choice.faults);
  if (choice.link == "unlimited") {
    display.speed = EmulatedSpeed::kUsb3;
  } else {
    display.device.bytesPerSecond = wire::plannedLink(choice.link).bytesPerSecond;
    display.speed =
        display.device.bytesPerSecond > wire::kUsb2BytesPerSecond ? EmulatedSpeed::kUsb3 : EmulatedSpeed::kUsb2;
  }
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

void waitForInterrupt(const Frame& frame, const UsbEmulator& emulator) {
  std::string variables;
  for (const auto& [name, value] : emulator.environment()) {
    variables += fmt::format("{}={} ", name, value);
  }
  frame.print(
      fmt::format("The display is plugged in for programs that are started like this:\n  {}ocelli device list\n"
                  "Ctrl-C ends it.\n",
                  variables));
  flushStandardOutput();
  const InterruptGuard guard;
  while (!InterruptGuard::interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

int emulate(const Frame& frame, const EmulateChoice& choice) {
  const EmulatedUsbDisplay display = emulatedDisplay(choice);
  UsbEmulator::restartPreloaded();
  if (!UsbEmulator::preloaded()) {
    throw WorkError("umockdev's preload library cannot be loaded", "libumockdev-preload.so.0", "install libumockdev0");
  }
  std::optional<ShownRecorder> recorder;
  if (!choice.output.empty()) {
    std::filesystem::create_directories(choice.output);
    recorder.emplace(std::filesystem::path(choice.output) / "shown.svol", display.device.firmware.profile);
  }
  EmulationLog log(recorder ? &*recorder : nullptr);
  int code = 0;
  {
    UsbEmulator emulator({display});
    emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds) {
      device.firmware().setSink(&log);
      device.firmware().setArrivalSink(&log);
    });
    if (choice.command.empty()) {
      waitForInterrupt(frame, emulator);
    } else {
      code = runClient(resolved(choice.command), emulator.environment());
    }
    frame.note(report(emulator, log));
  }
  if (recorder) {
    recorder->finish();
    writeRefreshTable(std::filesystem::path(choice.output) / "refreshes.csv", recorder->refreshes());
    frame.note(fmt::format("wrote {0}/shown.svol and {0}/refreshes.csv\n", choice.output));
  }
  return code;
}

}  // namespace

void addDeviceEmulate(CLI::App& device, const Frame& frame) {
  const auto choice = std::make_shared<EmulateChoice>();
  CLI::App& command = *device.add_subcommand("emulate", "Run a program with an emulated display on an emulated USB");
  command.add_option("COMMAND", choice->command, "The program and its arguments, after --; none: until Ctrl-C");
  command.add_option("--profile", choice->profile, "The display: a name, or a JSON file");
  command.add_option("--link", choice->link, "usb2, usb3, unlimited, or bytes a second")
      ->type_name("usb2|usb3|unlimited|NUMBER");
  command.add_option("--faults", choice->faults, "A script of faults, or random:SEED")
      ->type_name("FILE.json|random:SEED");
  command.add_option("--serial", choice->serial, "Serial number of the display");
  command
      .add_option("--jitter", choice->jitter, "Of the rotation: standard deviation of a refresh's length in percent")
      ->check(CLI::Range(0.0, 9.9));
  command.add_option("-o,--output", choice->output, "A folder for what the display shows: shown.svol, refreshes.csv")
      ->type_name("FOLDER");
  frame.finish(command,
               "  ocelli device emulate -- ocelli device list\n"
               "  ocelli device emulate --faults random:7 -o shown -- ocelli present builtin:teapot --device usb",
               [frame, choice] {
                 if (const int code = emulate(frame, *choice); code != 0) {
                   throw ExitCode{code};
                 }
               });
}

}  // namespace ocelli
