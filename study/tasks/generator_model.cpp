#include "study/tasks/generator_model.h"

#include <algorithm>

namespace ocelli {

std::optional<size_t> GeneratorModel::indexOf(std::string_view name) const {
  const auto found =
      std::find_if(effects.begin(), effects.end(), [&](const GeneratorEffect& each) { return each.name == name; });
  return found == effects.end() ? std::nullopt : std::optional(static_cast<size_t>(found - effects.begin()));
}

double levelCovariate(const GeneratedTrial&) {
  return 1;
}

double graphCovariate(const GeneratedTrial& trial) {
  return trial.view == TrialView::kReference ? 0 : 1;
}

double sessionCovariate(const GeneratedTrial& trial) {
  return trial.session - 1;
}

}  // namespace ocelli
