// A model fitted again to other choices of trials: whether its answer hangs on any of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Which trials a sensitivity analysis keeps.
struct Variant {
  std::string label;
  TrialList trials;
  TimeoutTreatment timeouts = TimeoutTreatment::kCensored;  ///< for models that know censored times
  bool main = false;                                        ///< what the report says first
  bool leavesCasesOut = false;                              ///< all trials of the main one but those of some cases
};

struct Variants {
  std::vector<Variant> list;
  std::vector<std::string> notes;  ///< whole sentences about those that are not done, and why
};

/// The trial in which each subject met each case (block and label) for the first time, with either view.
TrialList firstExposures(const TrialList& trials);

/// The first session, first exposures, trials without dropped frames, and all cases but one. `first` comes before them;
/// its first one is the main one, whose treatment of time-outs the others have. Those that keep the same trials as one
/// before are not listed but noted. Where more than `maxRows` rows would be fitted to leave out each case, cases are
/// left out several at a time, which is noted.
Variants variantsOf(const TrialList& trials, std::vector<Variant> first, size_t maxRows);

struct SensitivityTable {
  std::string id;     ///< "find-time-sensitivity"
  std::string title;  ///< of the figure
  std::string value;  ///< "Odds ratio, other / reference"
  std::string lower;  ///< what values below 1, or 0, mean: "other faster"
  std::string upper;
  bool ratio = true;  ///< or the effect is a difference
  std::string unit{};
};
/// A forest of `effect` of each variant, and a table; those that leave cases out stand in the supplement, and
/// the report says between what they lie. It is called by several threads at once.
void addSensitivity(ReportWork& work, const SensitivityTable& about, const Variants& variants,
                    const std::function<Estimable<Estimate>(const Variant&)>& effect);

}  // namespace ocelli
