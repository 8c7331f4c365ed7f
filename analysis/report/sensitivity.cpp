#include "analysis/report/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/base/failure.h"
#include "analysis/plot/forest_plot.h"
#include "analysis/report/part_guard.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

using CaseName = std::pair<std::string, std::pair<int, std::string>>;

/// Sorted by block and place in it.
CaseName caseOf(const Trial* trial) {
  return {trial->block, {trial->caseIndex, trial->caseLabel}};
}

std::string nameOfCase(const CaseName& name) {
  return fmt::format("{}, {}", name.first,
                     name.second.second.empty() ? fmt::format("case {}", name.second.first + 1) : name.second.second);
}

TrialList keptIf(const TrialList& trials, const std::function<bool(const Trial*)>& keep) {
  TrialList kept;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(kept), keep);
  return kept;
}

void addWithoutCases(Variants& variants, const TrialList& trials, size_t maxRows) {
  std::set<CaseName> names;
  for (const Trial* trial : trials) {
    names.insert(caseOf(trial));
  }
  const std::vector<CaseName> cases(names.begin(), names.end());
  if (cases.size() < 2) {
    variants.notes.push_back("There is only one case: none is left out.");
    return;
  }
  const size_t fits = std::clamp<size_t>(maxRows / trials.size(), 2, cases.size());
  if (fits < cases.size()) {
    variants.notes.push_back(
        fmt::format("With {} trials, {} fits without one case each would take long: cases are left out in {} groups, "
                    "every {}th case together.",
                    trials.size(), cases.size(), fits, fits));
  }
  for (size_t group = 0; group < fits; ++group) {
    std::set<CaseName> left;
    for (size_t i = group; i < cases.size(); i += fits) {
      left.insert(cases[i]);
    }
    variants.list.push_back({left.size() == 1
                                 ? fmt::format("Without {}", nameOfCase(*left.begin()))
                                 : fmt::format("Without {} and {} more", nameOfCase(*left.begin()), left.size() - 1),
                             keptIf(trials, [&](const Trial* trial) { return !left.contains(caseOf(trial)); }),
                             TimeoutTreatment::kCensored, false, true});
  }
}

/// Whether all subjects see each case in the same one of two views.
bool splitsCasesByView(const TrialList& trials) {
  std::map<CaseName, std::set<TrialView>> views;
  std::set<TrialView> all;
  for (const Trial* trial : trials) {
    views[caseOf(trial)].insert(trial->view);
    all.insert(trial->view);
  }
  return all.size() > 1 &&
         std::all_of(views.begin(), views.end(), [](const auto& each) { return each.second.size() == 1; });
}

using VariantEffects = std::vector<std::pair<const Variant*, Estimable<Estimate>>>;

void addVariants(ReportWork& work, const SensitivityTable& about, const VariantEffects& effects) {
  ForestPlot forest;
  forest.title = about.title;
  forest.valueLabel = withLabels(work, about.value);
  forest.lowerSide = withLabels(work, about.lower);
  forest.upperSide = withLabels(work, about.upper);
  forest.ratio = about.ratio;
  std::vector<EstimateRow> rows;
  for (const auto& [variant, effect] : effects) {
    ForestPlot::Row row;
    row.label = variant->label;
    row.main = variant->main;
    if (effect) {
      row.interval = intervalOf(*effect);
    } else {
      row.reason = "cannot be estimated";
    }
    forest.rows.push_back(row);
    rows.push_back({variant->label, effect, about.unit, sizeText(variant->trials), variant->trials});
  }
  const bool any =
      std::any_of(effects.begin(), effects.end(), [](const auto& each) { return each.second.isPossible(); });
  if (any) {
    addFigure(work, about.title, fmt::format("figure-{}", about.id), [&] { return forestFigure(forest); });
  }
  addEstimates(work.document, fmt::format("{}: in numbers ({})", about.title, about.value), about.id, rows);
}

/// Between what the effects lie where cases are left out.
void addSpread(ReportWork& work, const SensitivityTable& about, const VariantEffects& effects) {
  double least = INFINITY;
  double most = -INFINITY;
  int estimated = 0;
  int significant = 0;
  for (const auto& [variant, effect] : effects) {
    if (variant->leavesCasesOut && effect) {
      least = std::min(least, effect->value);
      most = std::max(most, effect->value);
      significant += effect->pValue < work.analysis.plan.alpha ? 1 : 0;
      ++estimated;
    }
  }
  if (estimated > 0) {
    work.document.add(ReportParagraph{fmt::format(
        "Without one case after the other the effect ({}) lies between {} and {}; {} of {} such fits have p < {:g}. "
        "The "
        "supplement has them all.",
        about.value, numberText(least), numberText(most), significant, estimated, work.analysis.plan.alpha)});
  }
}

}  // namespace

TrialList firstExposures(const TrialList& trials) {
  const auto place = [](const Trial* trial) { return std::pair(trial->session, trial->planIndex); };
  std::map<std::pair<std::string, CaseName>, std::pair<int, int>> first;
  for (const Trial* trial : trials) {
    const auto [entry, isNew] = first.try_emplace({trial->subject, caseOf(trial)}, place(trial));
    entry->second = std::min(entry->second, place(trial));
  }
  return keptIf(trials, [&](const Trial* trial) { return first.at({trial->subject, caseOf(trial)}) == place(trial); });
}

Variants variantsOf(const TrialList& trials, std::vector<Variant> first, size_t maxRows) {
  Variants variants;
  first.front().main = true;
  std::vector<Variant> more{
      {"First session only", keptIf(trials, [](const Trial* trial) { return trial->session == 1; })},
      {"First exposure to each case only", firstExposures(trials)},
      {"Without trials with dropped frames",
       keptIf(trials, [](const Trial* trial) { return trial->droppedFrames == 0; })}};
  // Broken off and done again, by the experimenter or after a pause: its case had been seen before.
  const TrialList once = keptIf(trials, [](const Trial* trial) { return trial->attempt == 1; });
  if (once.size() < trials.size()) {
    more.push_back({fmt::format("Without trials that were done again ({})", trials.size() - once.size()), once});
  }
  // Alternatives before these may treat the same trials in other ways: they stay.
  variants.list = first;
  for (const Variant& variant : more) {
    const auto same = std::find_if(variants.list.begin(), variants.list.end(),
                                   [&](const Variant& other) { return other.trials == variant.trials; });
    if (same != variants.list.end()) {
      variants.notes.push_back(fmt::format("{}: these are the same trials as \"{}\".", variant.label, same->label));
    } else if (variant.trials.empty()) {
      variants.notes.push_back(fmt::format("{}: no trial is left.", variant.label));
    } else {
      variants.list.push_back(variant);
      if (splitsCasesByView(variant.trials) && !splitsCasesByView(trials)) {
        variants.notes.push_back(
            fmt::format("{}: every case is left with one view, the same for all subjects, so that views are compared "
                        "between cases. A model without effects of cases takes what cases differ in for the view's.",
                        variant.label));
      }
    }
  }
  addWithoutCases(variants, trials, maxRows);
  for (size_t i = first.size(); i < variants.list.size(); ++i) {
    variants.list[i].timeouts = first.front().timeouts;
  }
  return variants;
}

void addSensitivity(ReportWork& work, const SensitivityTable& about, const Variants& variants,
                    const std::function<Estimable<Estimate>(const Variant&)>& effect) {
  std::vector<Estimable<Estimate>> effects(variants.list.size(), Estimable<Estimate>::impossible(""));
  std::vector<std::optional<std::string>> failures(variants.list.size());
  parallelFor(effects.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      failures[i] = failureOf([&] { effects[i] = effect(variants.list[i]); });
    }
  });
  for (size_t i = 0; i < failures.size(); ++i) {
    if (failures[i]) {
      effects[i] = Estimable<Estimate>::impossible(addFailure(work, variants.list[i].label, *failures[i]));
    }
  }
  VariantEffects shown;
  VariantEffects withoutCases;
  for (size_t i = 0; i < effects.size(); ++i) {
    const Variant& variant = variants.list[i];
    if (!variant.leavesCasesOut) {
      shown.emplace_back(&variant, effects[i]);
    }
    // With the main one to compare with.
    if (variant.leavesCasesOut || variant.main) {
      withoutCases.emplace_back(&variant, effects[i]);
    }
  }
  addVariants(work, about, shown);
  if (withoutCases.size() > 1) {
    addSpread(work, about, withoutCases);
    const InSupplement supplement(work.document);
    SensitivityTable cases = about;
    cases.id += "-cases";
    cases.title += ", without one case after the other";
    addVariants(work, cases, withoutCases);
  }
  for (const std::string& note : variants.notes) {
    work.document.add(ReportNote{NoteKind::kNote, note});
  }
}

}  // namespace ocelli
