// What a regression is to explain something by.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ocelli {

struct Covariate {
  std::string name;
  std::vector<double> values;  ///< of each row
};

/// Throws InputError where there is not one finite value a row.
void checkCovariates(const std::vector<Covariate>& covariates, size_t rows, const char* function);

}  // namespace ocelli
