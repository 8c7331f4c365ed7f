#include "analysis/report/comparison_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli {
namespace {

/// An estimate with its interval, and its p value.
std::array<ReportCell, 2> cellsOf(const EstimateRow& row, OriginTable& origins) {
  std::array<ReportCell, 2> cells{ReportCell{"-"}, ReportCell{"-"}};
  if (!row.estimate) {
    return cells;
  }
  const Estimate& e = *row.estimate;
  const std::string origin =
      origins.addRow(row.label, row.source, originRowsOf(row), row.unit, {e.value, e.lower, e.upper, e.pValue});
  const auto cell = [&](const std::string& text, const char* column, double value) {
    return ReportCell{text, origin.empty() ? "" : fmt::format("{}/{}", origin, column), origins.sourceText(row.source),
                      value};
  };
  cells[0] = cell(estimateText(e.value, e.lower, e.upper), "estimate", e.value);
  if (std::isfinite(e.pValue)) {
    const std::string p = pText(e.pValue).substr(2);
    cells[1] = cell(p.starts_with("= ") ? p.substr(2) : p, "p", e.pValue);
  }
  return cells;
}

/// "-0.0" is 0.
std::string fixed(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

}  // namespace

std::string estimateText(double value, double lower, double upper) {
  const double half = (upper - lower) / 2;
  if (!std::isfinite(half) || half <= 0) {
    return numberText(value);
  }
  constexpr int kMostDecimals = 6;
  constexpr double kSkewed = 5;
  if (lower > 0 && upper - value > kSkewed * (value - lower)) {
    return fmt::format("{} ({} to {})", numberText(value), numberText(lower), numberText(upper));
  }
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, kMostDecimals);
  return fmt::format("{} ({} to {})", fixed(value, decimals), fixed(lower, decimals), fixed(upper, decimals));
}

void addComparison(ReportDocument& document, const ComparisonTable& table) {
  ReportTable shown{
      table.caption, table.id, {{"What", "", true}, {table.first}, {table.second}, {table.difference}}, {}};
  if (table.tested) {
    shown.columns.push_back({"p"});
  }
  shown.columns.push_back({"Subjects"});
  OriginTable origins(document.origins, table.id, table.caption, {"estimate", "lower", "upper", "p"});
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
    const ReportCell first = cellsOf(row.first, origins)[0];
    const ReportCell second = cellsOf(row.second, origins)[0];
    const std::array difference = cellsOf(row.difference, origins);
    shown.rows.push_back({ReportCell{row.label}, first, second, difference[0]});
    if (table.tested) {
      shown.rows.back().push_back(difference[1]);
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
