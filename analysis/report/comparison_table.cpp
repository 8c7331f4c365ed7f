#include "analysis/report/comparison_table.h"

#include <fmt/format.h>

#include <cmath>

namespace ocelli {
namespace {

/// What a row says of one estimate.
struct EstimateCells {
  ReportCell estimate{"-"};  ///< with its interval
  ReportCell standardError{"-"};
  ReportCell statistic{"-"};  ///< with its degrees of freedom
  ReportCell pValue{"-"};
};

EstimateCells cellsOf(const EstimateRow& row, OriginTable& origins) {
  EstimateCells cells;
  if (!row.estimate) {
    return cells;
  }
  const Estimate& e = *row.estimate;
  const std::string origin =
      origins.addRow(row.label, row.source, originRowsOf(row), row.unit,
                     {e.value, e.lower, e.upper, e.pValue, e.standardError, e.statistic, e.degreesOfFreedom});
  const auto set = [&](ReportCell& cell, const std::string& text, const char* column, double value) {
    if (!text.empty() && std::isfinite(value)) {
      cell = {text, origin.empty() ? "" : fmt::format("{}/{}", origin, column), origins.sourceText(row.source), value};
    }
  };
  set(cells.estimate, estimateText(e.value, e.lower, e.upper), "estimate", e.value);
  if (std::isfinite(e.lower) && std::isfinite(e.upper)) {
    cells.estimate.interval = {e.lower, e.upper};
  }
  set(cells.standardError, textsOf(e).standardError, "se", e.standardError);
  const std::string degrees = degreesText(e.degreesOfFreedom);
  set(cells.statistic, degrees.empty() ? statisticText(e) : fmt::format("{} ({})", statisticText(e), degrees),
      "statistic", e.statistic);
  set(cells.pValue, pValueText(e.pValue), "p", e.pValue);
  return cells;
}

}  // namespace

void addComparison(ReportDocument& document, const ComparisonTable& table) {
  ReportTable shown{
      table.caption, table.id, {{"What", "", true}, {table.first}, {table.second}, {table.difference}}, {}};
  if (table.tested) {
    shown.columns.insert(shown.columns.end(), {{"SE"}, {"Statistic (df)"}, {"p"}});
  }
  shown.columns.push_back({"Subjects"});
  OriginTable origins(document.origins, table.id, table.caption,
                      {"estimate", "lower", "upper", "p", "se", "statistic", "df"});
  ReasonNotes reasons;
  for (const ComparisonRow& row : table.rows) {
    bool any = false;
    for (const EstimateRow* each : {&row.first, &row.second, &row.difference}) {
      any = any || each->estimate;
      if (!each->estimate) {
        reasons.add(each->label, each->estimate.reason());
      }
    }
    if (!any) {
      continue;
    }
    const ReportCell first = cellsOf(row.first, origins).estimate;
    const ReportCell second = cellsOf(row.second, origins).estimate;
    const EstimateCells difference = cellsOf(row.difference, origins);
    shown.rows.push_back({ReportCell{row.label}, first, second, difference.estimate});
    if (table.tested) {
      shown.rows.back().insert(shown.rows.back().end(),
                               {difference.standardError, difference.statistic, difference.pValue});
    }
    shown.rows.back().push_back(ReportCell{row.subjects});
  }
  if (!shown.rows.empty()) {
    document.add(shown);
    origins.finish();
  }
  reasons.write(document);
}

}  // namespace ocelli
