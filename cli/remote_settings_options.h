// The settings of remote visualisation (oc_core/remote/remote_settings.h) as options of a command.
#pragma once

#include "oc_core/remote/remote_settings.h"

namespace CLI {
class App;
}

namespace ocelli {

/// Adds an option for each row of remoteOptions(). `settings` must outlive the parsing.
void addRemoteSettingsOptions(CLI::App& command, RemoteSettings& settings);

}  // namespace ocelli
