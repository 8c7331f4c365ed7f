#include "cli/emulated_display.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "display_driver/wire/bandwidth_plan.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

// Of scripts that are drawn at random.
constexpr size_t kRandomFaults = 20;
constexpr DeviceMicroseconds kRandomFaultsOver = 10'000'000;
constexpr double kMaxJitterPercent = 9.9;

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

}  // namespace

void addEmulatedDisplayOptions(CLI::App& command, EmulatedDisplayChoice& choice, const std::string& link) {
  command
      .add_option("--link", choice.link, fmt::format("How much the link to it carries; {} where it is not given", link))
      ->type_name("usb2|usb3|unlimited|BYTES_PER_SECOND");
  command.add_option("--faults", choice.faults, "A script of what goes wrong with it, or random:SEED")
      ->type_name("FILE.json|random:SEED");
  command
      .add_option("--jitter", choice.jitterPercent,
                  "Of its rotation: standard deviation of a refresh's length, in percent")
      ->type_name("PERCENT");
}

EmulatedDeviceOptions emulatedDisplay(const EmulatedDisplayChoice& choice, const std::string& otherwiseLink) {
  if (!(choice.jitterPercent >= 0 && choice.jitterPercent <= kMaxJitterPercent)) {
    throw InputError(fmt::format("{} is no jitter", choice.jitterPercent), "--jitter",
                     fmt::format("a percentage from 0 to {}: --jitter 0.2", kMaxJitterPercent));
  }
  EmulatedDeviceOptions options;
  options.firmware.rotor.jitter = choice.jitterPercent / 100;
  options.faults = faultScript(choice.faults);
  const std::string& link = choice.link.empty() ? otherwiseLink : choice.link;
  if (link != "unlimited") {
    try {
      options.bytesPerSecond = wire::plannedLink(link).bytesPerSecond;
    } catch (const InputError&) {
      throw InputError("this is no link", fmt::format("--link {}", link),
                       "usb2, usb3, unlimited, or a number of bytes a second: --link 30000000");
    }
  }
  return options;
}

}  // namespace ocelli
