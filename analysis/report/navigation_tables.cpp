#include "analysis/report/navigation_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "analysis/inference/sample.h"

namespace ocelli {
namespace {

using Number = Estimable<double>;

Number searched(const SearchNavigation&, const Trial& trial) {
  return trial.responseSeconds ? Number(*trial.responseSeconds) : Number::impossible("no time is stored");
}

/// Until the object was in straight sight, or else all of the search.
Number travelled(const SearchNavigation& search, const Trial& trial) {
  const Number total = searched(search, trial);
  if (!search.objectIsKnown || !total) {
    return search.objectIsKnown ? total : search.travelSeconds;
  }
  return search.travelSeconds ? std::min(*search.travelSeconds, *total) : *total;
}

Number detected(const SearchNavigation& search, const Trial& trial) {
  const Number travel = travelled(search, trial);
  return travel ? Number(*trial.responseSeconds - *travel) : travel;
}

std::string kindOf(const NavigationGroup& group) {
  return group.moving ? "moving" : "stationary";
}

/// Of sorted values; linear between neighbours.
double quantileOfSorted(const std::vector<double>& sorted, double probability) {
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

TrialList trialsOf(const TrialValues& values) {
  TrialList trials;
  for (const TrialValue& value : values) {
    trials.push_back(value.trial);
  }
  return trials;
}

/// How many searches, and their median with quartiles.
std::array<ReportCell, 2> medianCells(const std::string& label, const TrialValues& values, OriginTable& origins) {
  if (values.empty()) {
    return {ReportCell{"0"}, ReportCell{"-"}};
  }
  std::vector<double> sorted;
  for (const TrialValue& value : values) {
    sorted.push_back(value.value);
  }
  std::sort(sorted.begin(), sorted.end());
  const double median = medianOfSorted(sorted);
  const double lower = quantileOfSorted(sorted, 0.25);
  const double upper = quantileOfSorted(sorted, 0.75);
  const auto count = static_cast<double>(sorted.size());
  const std::string meaning = "median and quartiles of searches";
  const std::string origin =
      origins.addRow(label, meaning, originRowsOf(trialsOf(values)), "", {count, median, lower, upper});
  const std::string source = origins.sourceText(meaning);
  return {ReportCell{std::to_string(sorted.size()), fmt::format("{}/searches", origin), source, count},
          ReportCell{estimateText(median, lower, upper), fmt::format("{}/median", origin), source, median}};
}

/// "3 (12.5 %)" of `total`; without it the number alone.
ReportCell countCell(const std::string& label, const TrialList& trials, size_t total, OriginTable& origins) {
  const auto count = static_cast<double>(trials.size());
  const std::string meaning = "number of searches";
  const std::string origin = origins.addRow(label, meaning, originRowsOf(trials), "", {count});
  ReportCell cell{std::to_string(trials.size()), origin.empty() ? "" : fmt::format("{}/count", origin),
                  origins.sourceText(meaning), count};
  if (total > 0) {
    cell.text += fmt::format(" ({:.1f} %)", 100 * count / static_cast<double>(total));
  }
  return cell;
}

void addMeans(ReportWork& work, const NavigationGroup& group) {
  ComparisonTable table;
  table.caption = fmt::format(
      "Searches for {} objects: means over subjects' means and differences, with 95 % intervals; subjects of "
      "@reference@, of "
      "@other@, "
      "and of both",
      kindOf(group));
  table.id = fmt::format("navigation-{}", kindOf(group));
  for (const NavigationMeasure& measure : navigationMeasures()) {
    const TrialValues values = valuesOf(work.analysis.data, group, measure);
    if (!values.empty()) {
      table.rows.push_back(compareViews(measure.name, values, ValueScale::kPlain));
    }
  }
  addComparison(work.document, table);
}

void addMedians(ReportWork& work, const NavigationGroup& group) {
  ReportTable table{fmt::format("Searches for {} objects: medians and quartiles over searches", kindOf(group)),
                    fmt::format("navigation-{}-medians", kindOf(group)),
                    {{"What", "", true},
                     {"searches", "@reference@"},
                     {"median", "@reference@"},
                     {"searches", "@other@"},
                     {"median", "@other@"}},
                    {}};
  OriginTable origins(work.document.origins, table.id, table.caption, {"searches", "median", "lower", "upper"});
  for (const NavigationMeasure& measure : navigationMeasures()) {
    const TrialValues values = valuesOf(work.analysis.data, group, measure);
    if (values.empty()) {
      continue;
    }
    table.rows.push_back({ReportCell{measure.name}});
    for (const TrialView view : kViews) {
      for (const ReportCell& cell :
           medianCells(fmt::format("{}, {}", measure.name, markOf(view)), valuesOfView(values, view), origins)) {
        table.rows.back().push_back(cell);
      }
    }
  }
  work.document.add(table);
  origins.finish();
}

std::string outcomeOf(const SearchNavigation& search, const Trial& trial) {
  if (!trial.censored) {
    return "Not known how it ended";
  }
  if (*trial.censored) {
    return search.travelSeconds ? "In straight sight, but time ran out" : "Never in straight sight, and time ran out";
  }
  return search.detectionSeconds ? "In straight sight, then found" : "Found before it was in straight sight";
}

void addOutcomes(ReportWork& work, const NavigationGroup& group) {
  std::map<std::string, TrialList> byOutcome;
  TrialList all;
  for (const SearchNavigation* search : group.searches) {
    const Trial& trial = work.analysis.data.trials[search->trial];
    if (search->objectIsKnown) {
      byOutcome[outcomeOf(*search, trial)].push_back(&trial);
      all.push_back(&trial);
    }
  }
  if (all.empty()) {
    return;
  }
  ReportTable table{"What became of searches for stationary objects, by straight sight",
                    "navigation-outcomes",
                    {{"What", "", true}, {"@reference@"}, {"@other@"}},
                    {}};
  OriginTable origins(work.document.origins, table.id, table.caption, {"count"});
  for (const auto& [outcome, trials] : byOutcome) {
    table.rows.push_back({ReportCell{outcome}});
    for (const TrialView view : kViews) {
      table.rows.back().push_back(countCell(fmt::format("{}, {}", outcome, markOf(view)), trialsOfView(trials, view),
                                            trialsOfView(all, view).size(), origins));
    }
  }
  work.document.add(table);
  origins.finish();
}

void addUnknown(ReportWork& work, const NavigationGroup& group) {
  ReasonNotes unknownOfAll;
  ReportTable table{fmt::format("Searches for {} objects: what is not known of some", kindOf(group)),
                    fmt::format("navigation-{}-unknown", kindOf(group)),
                    {{"What", "", true}, {"Because", "", true}, {"@reference@"}, {"@other@"}},
                    {}};
  OriginTable origins(work.document.origins, table.id, table.caption, {"count"});
  for (const NavigationMeasure& measure : navigationMeasures()) {
    std::map<std::string, TrialList> byReason;
    for (const SearchNavigation* search : group.searches) {
      const Trial& trial = work.analysis.data.trials[search->trial];
      if (const Number value = measure.of(*search, trial); !value) {
        byReason[value.reason()].push_back(&trial);
      }
    }
    if (byReason.size() == 1 && byReason.begin()->second.size() == group.searches.size()) {
      unknownOfAll.add(fmt::format("{} of {} objects", measure.name, kindOf(group)), byReason.begin()->first);
      continue;
    }
    for (const auto& [reason, trials] : byReason) {
      table.rows.push_back({ReportCell{measure.name}, ReportCell{reason}});
      for (const TrialView view : kViews) {
        table.rows.back().push_back(countCell(fmt::format("{}, {}, {}", measure.name, reason, markOf(view)),
                                              trialsOfView(trials, view), 0, origins));
      }
    }
  }
  unknownOfAll.write(work.document);
  if (!table.rows.empty()) {
    work.document.add(table);
    origins.finish();
  }
}

}  // namespace

std::vector<NavigationMeasure> navigationMeasures() {
  using Search = SearchNavigation;
  return {
      {"Time searched (s)", "", "", searched},
      {"Travel: before straight sight (s)", "Travel, before straight sight", "Time (s)", travelled},
      {"Detection: the rest (s)", "Detection, the rest", "Time (s)", detected},
      {"First straight sight, where there was one (s)", "", "",
       [](const Search& search, const Trial&) { return search.travelSeconds; }},
      {"From straight sight to the click, where both were (s)", "", "",
       [](const Search& search, const Trial&) { return search.detectionSeconds; }},
      {"Way walked (m)", "Way walked", "Way (m)",
       [](const Search& search, const Trial&) { return Number(search.walk.pathMeters); }},
      {"Detour: way over the shortest to the end", "Detour", "Way over the shortest",
       [](const Search& search, const Trial&) { return search.detour; }},
      {"Way over the shortest to the object", "", "",
       [](const Search& search, const Trial&) { return search.walkedOverWayToObject; }},
      {"Turned, either way (full turns)", "Turned", "Full turns",
       [](const Search& search, const Trial&) { return Number(search.walk.turnedRadians / (2 * std::numbers::pi)); }},
      {"Standing, turning or not (% of the time)", "Standing", "Of the time (%)",
       [](const Search& search, const Trial&) { return Number(100 * search.walk.standing); }},
      {"Neither going nor turning (% of the time)", "", "",
       [](const Search& search, const Trial&) { return Number(100 * search.walk.still); }},
  };
}

TrialValues valuesOf(const Dataset& data, const NavigationGroup& group, const NavigationMeasure& measure) {
  TrialValues values;
  for (const SearchNavigation* search : group.searches) {
    const Trial& trial = data.trials[search->trial];
    if (const Number value = measure.of(*search, trial)) {
      values.push_back({&trial, *value});
    }
  }
  return values;
}

void addNavigationTables(ReportWork& work, const NavigationGroup& group) {
  addMeans(work, group);
  addMedians(work, group);
  addOutcomes(work, group);
  addUnknown(work, group);
}

}  // namespace ocelli
