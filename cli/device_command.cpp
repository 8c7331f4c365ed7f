// `ocelli device`: displays, and those who build them.
#include "cli/device_command.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace ocelli {

void addDeviceCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& device = *program.add_subcommand("device", "Build, calibrate and plan for volumetric displays");
  device.require_subcommand(1);
  addDeviceList(device, context);
  addDeviceInfo(device, context);
#ifdef OCELLI_WITH_EMULATOR
  addDeviceEmulate(device, context);
#endif
  addDevicePlan(device, context);
  addDeviceSelftest(device, context);
}

}  // namespace ocelli
