// `ocelli study latency`: how long a response device takes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/study_command.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/steady_time.h"
#include "study/responses/latency_test.h"
#ifdef OCELLI_WITH_OPENGL
#include "study/screen/latency_flash.h"
#endif

namespace ocelli {
namespace {

struct LatencyChoice {
  std::string responses;
  std::string byte;
  bool flash = false;
  int monitor = 0;
  LatencyOptions options;
  std::string output;
};

unsigned char byteOf(const std::string& text) {
  int value = -1;
  if (text.size() == 1) {
    return static_cast<unsigned char>(text.front());
  }
  const auto read = text.starts_with("0x") ? std::from_chars(text.data() + 2, text.data() + text.size(), value, 16)
                                           : std::from_chars_result{text.data(), std::errc::invalid_argument};
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || value < 0 || value > 255) {
    throw InputError("\"" + text + "\" is no byte", "--byte", "a character of ASCII, or its number such as 0x55");
  }
  return static_cast<unsigned char>(value);
}

LatencyReport byBytes(const LatencyChoice& choice, LatencyText& text) {
  const unsigned char byte = byteOf(choice.byte);
  if (choice.responses.empty()) {
    throw InputError("no device is named that could answer a byte", "--responses", "such as serial:/dev/ttyUSB0");
  }
  const auto device = openResponseDevice(choice.responses, {});
  text = {
      device->description(),
      fmt::format("byte 0x{:02x}, which the device sends back", byte),
      {"the way of the byte to the device over the serial line and its driver"},
      {"what the contact of a button adds: its travel, and its bounce", "the interval in which USB asks a converter"}};
  return measureLatency(
      *device,
      [&]() -> std::optional<int64_t> {
        const int64_t sent = steadyNanoseconds();
        if (!device->send(byte)) {
          throw InputError("this device takes no bytes", "--responses " + choice.responses,
                           "give a serial device, or measure with --flash");
        }
        return sent;
      },
      [] {}, choice.options);
}

#ifdef OCELLI_WITH_OPENGL
LatencyReport byFlashes(const LatencyChoice& choice, LatencyText& text) {
  return measureFlashLatency(choice.responses, choice.monitor, choice.options, text);
}
#else
LatencyReport byFlashes(const LatencyChoice&, LatencyText&) {
  throw InputError("this program was built without OpenGL, and shows no flash", "--flash",
                   "measure with --byte, or build it with OpenGL (docs/install.md)");
}
#endif

void measure(const LatencyChoice& choice, const CommandContext& context) {
  if (choice.flash != choice.byte.empty()) {
    throw InputError("nothing, or two things, would be the stimulus", "--byte, --flash",
                     "give one: a byte that the device sends back, or flashes that a photodiode at its button sees");
  }
  if (!choice.output.empty()) {
    checkWritable(choice.output);
  }
  const InterruptGuard guard;
  LatencyText text;
  const LatencyReport report = choice.flash ? byFlashes(choice, text) : byBytes(choice, text);
  context.print(describe(report, text));
  if (!choice.output.empty()) {
    OutputFile file(choice.output);
    file.write(jsonText(report, text));
    file.commit();
    context.note("wrote " + choice.output);
  }
  if (report.milliseconds.empty()) {
    throw WorkError("the device answered no stimulus", choice.responses,
                    "check what is wired (docs/responses.md), and which bytes or buttons are keys");
  }
}

}  // namespace

void addStudyLatencyCommand(CLI::App& study, const CommandContext& context) {
  CLI::App& command = *study.add_subcommand(
      "latency", "Measure how long a response device takes, with a stimulus that it answers by itself");
  const auto choice = std::make_shared<LatencyChoice>();
  command.add_option("--responses", choice->responses, "The device: " + responseDeviceForms())->type_name("DEVICE");
  command.add_option("--byte", choice->byte, "Send it this byte, which it sends back: a character, or such as 0x55")
      ->type_name("BYTE");
  command.add_flag("--flash", choice->flash,
                   "Show flashes, which a photodiode wired to the button of the device, or of a keyboard, answers");
  command.add_option("--monitor", choice->monitor, "With --flash: the monitor to fill")->type_name("N");
  command.add_option("--trials", choice->options.trials, "How many stimuli")
      ->check(CLI::Range(1, 10000))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--timeout", choice->options.timeoutSeconds, "Seconds after which an answer is missed")
      ->check(CLI::Range(0.05, 10.0))
      ->type_name("S")
      ->capture_default_str();
  command.add_option("-o,--output", choice->output, "Write all latencies as JSON")->type_name("FILE.json");
  choice->options.interrupted = [] { return InterruptGuard::interrupted(); };
  context.finish(command,
                 "  ocelli study latency --responses serial:/dev/ttyUSB0 --byte 0x55 --trials 100\n"
                 "  ocelli study latency --responses gamepad --flash -o latency.json\n"
                 "  ocelli study latency --flash",
                 [choice, context] { measure(*choice, context); });
}

}  // namespace ocelli
