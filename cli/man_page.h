// Manual pages in the language of man(7), one a command.
#pragma once

#include <string>

#include "cli/command_text.h"

namespace ocelli {

/// `above` is the command that this one belongs to; null for the program. `version` stands at the foot.
std::string manPage(const CommandText& command, const CommandText* above, const std::string& version);

}  // namespace ocelli
