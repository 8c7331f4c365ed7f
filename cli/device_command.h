// The commands of `ocelli device`, one function a file.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

// Each adds a command below `device`, as the recipe in cli/command.h says of the program's own.
void addDeviceEmulate(CLI::App& device, const CommandContext& context);
void addDeviceInfo(CLI::App& device, const CommandContext& context);
void addDeviceList(CLI::App& device, const CommandContext& context);
void addDevicePlan(CLI::App& device, const CommandContext& context);
void addDeviceSelftest(CLI::App& device, const CommandContext& context);

}  // namespace ocelli
