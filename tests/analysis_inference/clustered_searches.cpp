#include "tests/analysis_inference/clustered_searches.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli::test {

Estimable<Estimate> coxTerm(const SurvivalData& data) {
  const auto fit = fitCox(data);
  return fit ? Estimable<Estimate>(fit->terms[0].logHazardRatio) : Estimable<Estimate>::impossible(fit.reason());
}
Estimable<Estimate> logNormalTerm(const SurvivalData& data) {
  const auto fit = fitLogNormal(data);
  return fit ? Estimable<Estimate>(fit->terms[0].logTimeRatio) : Estimable<Estimate>::impossible(fit.reason());
}

SurvivalData searches(int subjects, int cases, const Spread& spread, RandomNumbers& random) {
  SurvivalData data;
  data.covariates = {{"view", {}}};
  data.fewClusters = true;
  std::vector<std::array<double, 2>> ofCases(static_cast<size_t>(cases));
  for (std::array<double, 2>& each : ofCases) {
    each = {spread.ofCases * random.normal(), spread.ofCaseViews * random.normal()};
  }
  for (int subject = 0; subject < subjects; ++subject) {
    const double ofSubject = spread.ofSubjects * random.normal();
    const double ofSubjectView = spread.ofSubjectViews * random.normal();
    for (int each = 0; each < cases; ++each) {
      for (const double view : {-0.5, 0.5}) {
        const auto [ofCase, ofCaseView] = ofCases[static_cast<size_t>(each)];
        const double seconds =
            std::exp(3 + ofSubject + ofCase + (ofSubjectView + ofCaseView) * view + spread.ofTrials * random.normal());
        data.times.push_back({std::min(seconds, 60.0), seconds < 60});
        data.covariates[0].values.push_back(view);
        data.clusters.push_back(subject);
        data.items.push_back(each);
      }
    }
  }
  return data;
}

}  // namespace ocelli::test
