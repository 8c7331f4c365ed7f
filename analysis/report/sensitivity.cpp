#include "analysis/report/sensitivity.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "analysis/plot/forest_plot.h"

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

void addWithoutCases(Variants& variants, const TrialList& trials, size_t mostRows) {
  std::set<CaseName> names;
  for (const Trial* trial : trials) {
    names.insert(caseOf(trial));
  }
  const std::vector<CaseName> cases(names.begin(), names.end());
  if (cases.size() < 2) {
    variants.notes.push_back("There is only one case: none is left out.");
    return;
  }
  const size_t fits = std::clamp<size_t>(mostRows / trials.size(), 2, cases.size());
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
                             keptIf(trials, [&](const Trial* trial) { return !left.contains(caseOf(trial)); })});
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

Variants variantsOf(const TrialList& trials, std::vector<Variant> first, size_t mostRows) {
  Variants variants;
  first.front().main = true;
  const std::vector<Variant> more{
      {"First session only", keptIf(trials, [](const Trial* trial) { return trial->session == 1; })},
      {"First exposure to each case only", firstExposures(trials)},
      {"Without trials with dropped frames",
       keptIf(trials, [](const Trial* trial) { return trial->droppedFrames == 0; })}};
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
  addWithoutCases(variants, trials, mostRows);
  for (size_t i = first.size(); i < variants.list.size(); ++i) {
    variants.list[i].timeouts = first.front().timeouts;
  }
  return variants;
}

void addSensitivity(ReportWork& work, const SensitivityTable& about, const Variants& variants,
                    const std::function<Estimable<Estimate>(const Variant&)>& effect) {
  std::vector<Estimable<Estimate>> effects(variants.list.size(), Estimable<Estimate>::impossible(""));
  tbb::parallel_for(size_t{0}, variants.list.size(), [&](size_t i) { effects[i] = effect(variants.list[i]); });
  ForestPlot forest;
  forest.title = about.title;
  forest.valueLabel = about.value;
  forest.lowerSide = about.lower;
  forest.upperSide = about.upper;
  forest.ratio = true;
  std::vector<EstimateRow> rows;
  for (size_t i = 0; i < effects.size(); ++i) {
    const Variant& variant = variants.list[i];
    ForestPlot::Row row;
    row.label = variant.label;
    row.main = variant.main;
    if (effects[i]) {
      row.interval = intervalOf(*effects[i]);
    } else {
      row.reason = "cannot be estimated";
    }
    forest.rows.push_back(row);
    rows.push_back({variant.label, effects[i], "", sizeText(variant.trials), variant.trials});
  }
  const bool any = std::any_of(effects.begin(), effects.end(), [](const auto& each) { return each.isPossible(); });
  if (any) {
    work.document.add(ReportFigure{about.title, fmt::format("figure-{}", about.id), forestFigure(forest)});
  }
  addEstimates(work.document, fmt::format("{}: in numbers ({})", about.title, about.value), about.id, rows);
  for (const std::string& note : variants.notes) {
    work.document.add(ReportNote{NoteKind::kNote, note});
  }
}

}  // namespace ocelli
