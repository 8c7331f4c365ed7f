// The commands of `ocelli device`, one function a file.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class Frame;

// Each adds a command below `device`, as the recipe in cli/command.h says of the program's own.
void addDeviceEmulate(CLI::App& device, const Frame& frame);
void addDeviceInfo(CLI::App& device, const Frame& frame);
void addDeviceList(CLI::App& device, const Frame& frame);
void addDevicePlan(CLI::App& device, const Frame& frame);
void addDeviceSelftest(CLI::App& device, const Frame& frame);

}  // namespace ocelli
