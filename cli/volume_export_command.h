// `ocelli volume export`: a volume or a recording in files of other programs.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addVolumeExport(CLI::App& parent, const CommandContext& context);

}  // namespace ocelli
