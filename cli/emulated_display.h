// What an emulated or simulated display is like, as commands take it.
#pragma once

#include <string>

#include "display_driver/firmware/emulated_device.h"

namespace CLI {
class App;
}

namespace ocelli {

struct EmulatedDisplayChoice {
  std::string link;
  std::string faults;
  double jitterPercent = 0;

  bool given() const { return !link.empty() || !faults.empty() || jitterPercent != 0; }
};

/// Adds --link, --faults and --jitter. `link` is what the first one is where it is not given.
void addEmulatedDisplayOptions(CLI::App& command, EmulatedDisplayChoice& choice, const std::string& link);

/// Without a profile. Throws InputError for values that cannot be read.
EmulatedDeviceOptions emulatedDisplay(const EmulatedDisplayChoice& choice, const std::string& otherwiseLink);

}  // namespace ocelli
