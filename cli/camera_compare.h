// `ocelli camera compare`.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

/// Adds the command below `camera`.
void addCameraCompare(CLI::App& camera, const CommandContext& context);

}  // namespace ocelli
