// The main() of tests that see emulated USB devices.
#include <gtest/gtest.h>

#include "tests/display_driver_usb/preloaded.h"

int main(int argumentCount, char** arguments) {
  ocelli::runPreloaded(arguments);
  testing::InitGoogleTest(&argumentCount, arguments);
  return RUN_ALL_TESTS();
}
