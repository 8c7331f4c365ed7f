#include "oc_core/shade/shade_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/csv.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

nlohmann::ordered_json numberOrNull(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) {
    return {};
  }
  return *value;
}

}  // namespace

std::vector<size_t> shownColumns(const ShadeReport& report) {
  std::vector<size_t> shown;
  for (size_t i = 0; i < report.effect.columns.size(); ++i) {
    const bool hasFigure = std::any_of(report.ways.begin(), report.ways.end(),
                                       [&](const ShadedWay& way) { return way.figures[i].has_value(); });
    if (report.effect.columns[i].heading != nullptr && hasFigure) {
      shown.push_back(i);
    }
  }
  return shown;
}

std::string textOf(const FigureColumn& column, const std::optional<double>& figure) {
  if (!figure) {
    return "-";
  }
  return std::isinf(*figure) ? "inf" : fmt::format("{:.{}f}", *figure * column.scale, column.digits);
}

std::string shadeTable(const ShadeReport& report) {
  size_t widest = 3;
  for (const ShadedWay& way : report.ways) {
    widest = std::max(widest, way.name.size());
  }
  const std::vector<size_t> shown = shownColumns(report);
  std::string text = fmt::format("{:<{}}", "by", widest);
  for (const size_t column : shown) {
    text += fmt::format("  {:>10}", report.effect.columns[column].heading);
  }
  text += "\n";
  for (const ShadedWay& way : report.ways) {
    text += fmt::format("{:<{}}", way.name, widest);
    for (const size_t column : shown) {
      text += fmt::format("  {:>10}", textOf(report.effect.columns[column], way.figures[column]));
    }
    text += "\n";
  }
  return text;
}

std::string shadeJson(const ShadeReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["scene"] = report.scene;
  json["effect"] = report.effect.name;
  json["view"] = Json::parse(jsonText(report.view));
  json["size"] = {report.size.x, report.size.y};
  json["runs"] = report.runs;
  for (const ShadeFact& fact : report.facts) {
    json[fact.field] = Json::parse(fact.json);
  }
  json["by"] = Json::array();
  for (const ShadedWay& way : report.ways) {
    Json entry{{"name", way.name}};
    for (size_t i = 0; i < way.figures.size(); ++i) {
      entry[report.effect.columns[i].field] = numberOrNull(way.figures[i]);
    }
    json["by"].push_back(entry);
  }
  return textOfJson(json, 2) + "\n";
}

std::string shadeCsv(const ShadeReport& report) {
  std::string text = "name";
  for (const FigureColumn& column : report.effect.columns) {
    text += fmt::format(",{}", column.field);
  }
  text += "\n";
  for (const ShadedWay& way : report.ways) {
    text += csvText(way.name);
    for (const std::optional<double>& figure : way.figures) {
      text += figure ? fmt::format(",{}", *figure) : ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace ocelli
