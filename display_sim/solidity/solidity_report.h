// The figures of how solid a scene looks, as text of fixed width and as JSON: docs/metrics.md lists the fields.
#pragma once

#include <string>
#include <vector>

#include "display_sim/solidity/solidity.h"

namespace ocelli {

/// One line a row of figures, the means over the first two groups beside each other.
std::string solidityTable(const SolidityOptions& options, const std::vector<SolidityFigures>& rows);

/// {"scene", "profile", "image_side", "eyes", "representations"}.
std::string solidityJson(const std::string& scene, const SolidityOptions& options,
                         const std::vector<SolidityFigures>& rows);

}  // namespace ocelli
