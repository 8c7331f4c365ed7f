// Made studies: subjects, each with items in two views.
#pragma once

#include <vector>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"

namespace ocelli {

struct SampleSize {
  int subjects = 8;
  int items = 6;
  int rounds = 1;  ///< how often each subject has each item
};

/// Intercept, view, moving and session; subjects with slopes of view crossed with items. Views are coded -0.5 and 0.5.
FixedEffects sampleFixedEffects(const SampleSize& size, double sessionScale = 1);
std::vector<RandomTerm> sampleRandomTerms(const SampleSize& size, const FixedEffects& fixed, bool correlated = true);
Design sampleDesign(const SampleSize& size);

/// What sampleDesign()'s responses are drawn from.
LinearMixedFit sampleLinearTruth();
BinomialMixedFit sampleBinomialTruth();

}  // namespace ocelli
