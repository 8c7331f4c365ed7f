// The figures of an evaluation as JSON: docs/metrics.md lists the fields.
#pragma once

#include <string>
#include <vector>

#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

/// {"scene", "view", "size", "cell", "seed", "representations": [...], "offsets", "complete"}. `complete` is false
/// where rows of representations that were asked for are still missing.
std::string evaluationJson(const std::string& scene, const EvaluationOptions& options,
                           const std::vector<RepresentationFigures>& figures, bool complete = true);

}  // namespace ocelli
