// Starts a program anew so that it sees the devices of an emulator.
#pragma once

#include <unistd.h>

#include <cstdlib>

#include "display_driver/emulator/usb_emulator.h"

namespace ocelli {

/// False where that is not possible.
inline bool runPreloaded(char** arguments) {
  constexpr const char* kTried = "OCELLI_TEST_PRELOADED";
  if (!UsbEmulator::seenByThisProcess() && std::getenv(kTried) == nullptr) {
    setenv(kTried, "1", 1);
    setenv("LD_PRELOAD", UsbEmulator::preloadLibrary().c_str(), 1);
    execv("/proc/self/exe", arguments);
  }
  return UsbEmulator::seenByThisProcess();
}

}  // namespace ocelli
