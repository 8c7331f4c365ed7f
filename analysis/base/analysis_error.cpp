#include "analysis/base/analysis_error.h"

#include <fmt/format.h>

namespace ocelli {

AnalysisError::AnalysisError(Kind kind, const std::string& what, const std::string& where, const std::string& next)
    : std::runtime_error(fmt::format("{}: {}\n  try: {}", where, what, next)), kind_(kind) {}

}  // namespace ocelli
