// The main() of tests that see emulated USB devices.
#include <gtest/gtest.h>

#include "display_driver/emulator/usb_emulator.h"

int main(int argumentCount, char** arguments) {
  ocelli::UsbEmulator::restartPreloaded();
  testing::InitGoogleTest(&argumentCount, arguments);
  return RUN_ALL_TESTS();
}
