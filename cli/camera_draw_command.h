// `ocelli camera draw`.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

/// Adds the command below `camera`.
void addCameraDraw(CLI::App& camera, const CommandContext& context);

}  // namespace ocelli
