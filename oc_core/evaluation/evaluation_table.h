// The figures of an evaluation for people, as text of fixed width.
#pragma once

#include <string>
#include <vector>

#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

/// One line a representation; a second table where images were compared.
std::string evaluationTable(const std::vector<RepresentationFigures>& figures);

}  // namespace ocelli
