// The designs of the models of golden.R.
#pragma once

#include "analysis/models/design.h"
#include "tests/analysis_models/golden.h"

namespace ocelli {

/// An intercept, which differs by each of the groups.
Design interceptsDesign(const GoldenData& data, const std::vector<std::string>& groups);
/// "sleepstudy": Days, whose slope differs by subject.
Design sleepDesign(const GoldenData& data, bool correlated);
/// "find": slopes of the view by subject, crossed with items.
Design findDesign(const GoldenData& data, bool interaction = true);

}  // namespace ocelli
