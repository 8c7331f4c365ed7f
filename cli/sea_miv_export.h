// What `ocelli sea export --miv` does: views with depth for the test model of MPEG immersive video.
#pragma once

#include <string>

#include "cli/command.h"

namespace ocelli {

/// `folder` holds views with depth (oc_core/depth_views).
void exportMiv(const std::string& folder, const std::string& output, double unitsPerMetre,
               const CommandContext& context);

}  // namespace ocelli
