// `ocelli camera osl`: cameras for renderers that take them in the Open Shading Language.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

void addCameraOsl(CLI::App& camera, const CommandContext& context);

}  // namespace ocelli
