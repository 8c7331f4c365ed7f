// What commands that draw effects (oc_core/shade/effects.h) say alike.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace ocelli {

/// "reflection: what ...; refraction: what ...".
std::string effectHelp();

/// Adds --roles FILE.json.
void addRolesOption(CLI::App& command, std::string& file);

}  // namespace ocelli
