#include "analysis/inference/mcnemar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "analysis/base/distributions.h"
#include "analysis/inference/binomial_test.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

Estimable<Estimate> exactOddsRatio(const PairedCounts& counts, double level, double exactP) {
  if (counts.onlyFirst == 0 || counts.onlySecond == 0) {
    return Estimable<Estimate>::impossible(
        fmt::format("no pair succeeded in the {} condition alone", counts.onlyFirst == 0 ? "first" : "second"));
  }
  const Estimate share = clopperPearsonShare({counts.onlySecond, counts.onlyFirst + counts.onlySecond}, level);
  const auto odds = [](double p) { return p / (1 - p); };
  Estimate ratio;
  ratio.value = odds(share.value);
  ratio.lower = odds(share.lower);
  ratio.upper = odds(share.upper);
  ratio.pValue = exactP;
  return ratio;
}

Estimate differenceOf(const PairedCounts& counts, double level) {
  const double pairs = counts.pairs();
  const double first = (counts.onlyFirst + 1) / (pairs + 2);
  const double second = (counts.onlySecond + 1) / (pairs + 2);
  const double error = std::sqrt((first + second - (second - first) * (second - first)) / (pairs + 2));
  Estimate difference = waldEstimate(second - first, error, level);
  difference.value = (counts.onlySecond - counts.onlyFirst) / pairs;
  difference.lower = std::max(difference.lower, -1.0);
  difference.upper = std::min(difference.upper, 1.0);
  difference.statistic = difference.degreesOfFreedom = difference.pValue = kNotKnown;
  return difference;
}

}  // namespace

PairedCounts pairOutcomes(const std::vector<PairedOutcome>& outcomes) {
  std::map<std::string, std::array<std::optional<bool>, 2>> pairs;
  for (const PairedOutcome& outcome : outcomes) {
    std::optional<bool>& place = pairs[outcome.pair][outcome.isSecond ? 1 : 0];
    requireArgument(!place.has_value(), fmt::format("pair '{}' has two trials of one condition", outcome.pair),
                    "pairOutcomes");
    place = outcome.success;
  }
  PairedCounts counts;
  for (const auto& [name, pair] : pairs) {
    if (!pair[0].has_value() || !pair[1].has_value()) {
      ++counts.unpaired;
    } else if (*pair[0]) {
      ++(*pair[1] ? counts.both : counts.onlyFirst);
    } else {
      ++(*pair[1] ? counts.onlySecond : counts.neither);
    }
  }
  return counts;
}

Estimable<McNemarTest> mcNemarTest(const PairedCounts& counts, double level) {
  const int unlike = counts.onlyFirst + counts.onlySecond;
  if (unlike == 0) {
    return Estimable<McNemarTest>::impossible(
        fmt::format("none of {} pairs has a success in one condition and none in the other", counts.pairs()));
  }
  const int fewer = std::min(counts.onlyFirst, counts.onlySecond);
  const double oneSided = binomialProbability(fewer, unlike, 0.5);
  const double exactP = std::min(1.0, 2 * oneSided);
  const double difference = counts.onlyFirst - counts.onlySecond;
  const double corrected = std::max(std::abs(difference) - 1, 0.0);
  return McNemarTest{counts,
                     differenceOf(counts, level),
                     exactOddsRatio(counts, level, exactP),
                     exactP,
                     std::min(1.0, 2 * oneSided - binomialDensity(fewer, unlike, 0.5)),
                     chiSquaredEstimate(difference * difference / unlike, 1),
                     chiSquaredEstimate(corrected * corrected / unlike, 1)};
}

}  // namespace ocelli
