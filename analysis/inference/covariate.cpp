#include "analysis/inference/covariate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/wald.h"

namespace ocelli {

void checkCovariates(const std::vector<Covariate>& covariates, size_t rows, const char* function) {
  for (const Covariate& covariate : covariates) {
    const std::vector<double>& values = covariate.values;
    requireArgument(values.size() == rows,
                    fmt::format("'{}' has {} values for {} rows", covariate.name, values.size(), rows), function);
    requireArgument(std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }),
                    fmt::format("a value of '{}' is not finite", covariate.name), function);
  }
}

}  // namespace ocelli
