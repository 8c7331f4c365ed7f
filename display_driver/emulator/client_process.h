// Runs a program that shall see the emulated devices.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ocelli {

/// Starts the command, found on the PATH, with these variables in its environment, and waits for its end; returns its
/// exit code, or 128 + the signal that ended it. The signals that end a program are passed on to it meanwhile, but for
/// those from the terminal: it gets them itself. Where this process is killed, the command gets SIGTERM. Throws
/// WorkError where it cannot be started.
int runClient(const std::vector<std::string>& command,
              const std::vector<std::pair<std::string, std::string>>& environment);

}  // namespace ocelli
