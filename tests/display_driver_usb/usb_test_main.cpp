// The main() of tests that see emulated USB devices: starts the program anew with umockdev's preload library.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "display_driver/emulator/usb_emulator.h"

int main(int argumentCount, char** arguments) {
  constexpr const char* kTried = "OCELLI_TEST_PRELOADED";
  if (!ocelli::UsbEmulator::seenByThisProcess() && std::getenv(kTried) == nullptr) {
    setenv(kTried, "1", 1);
    setenv("LD_PRELOAD", ocelli::UsbEmulator::preloadLibrary().c_str(), 1);
    execv("/proc/self/exe", arguments);
  }
  testing::InitGoogleTest(&argumentCount, arguments);
  return RUN_ALL_TESTS();
}
