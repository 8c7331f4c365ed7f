#include "oc_core/shade/shade_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using Row = ShadeFigures;
using Value = std::optional<double>;

Value withDepth(const Row& row, double value) {
  return row.hasDepth ? Value(value) : std::nullopt;
}
Value inPyramids(const Row& row, double value) {
  return row.cost.nodes > 0 ? Value(value) : std::nullopt;
}
Value counted(size_t number) {
  return number > 0 ? Value(static_cast<double>(number)) : std::nullopt;
}

std::string inCsv(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + "\"";
}

nlohmann::ordered_json numberOrNull(const Value& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

const std::vector<ShadeColumn>& shadeColumns() {
  static const std::vector<ShadeColumn> columns{
      {"psnr_db", "PSNR dB", "of the pixels that send rays on, against the traced picture", 2, 1,
       [](const Row& r) -> Value { return r.psnrDecibels; }},
      {"lost", "lost %",
       "first hits that are missing or further than 1.5 footprints off, of the rays whose traced first "
       "hit is on an object that depth images stand for",
       2, 100, [](const Row& r) { return withDepth(r, r.lostRatio()); }},
      {"missing", "missing %", "those of them that meet no sample", 2, 100,
       [](const Row& r) { return withDepth(r, r.missingRatio()); }},
      {"false_hits", "false %",
       "rays that meet a sample more than 1.5 footprints before the traced first hit, of all rays", 2, 100,
       [](const Row& r) { return withDepth(r, r.falseRatio()); }},
      {"steps_per_ray", "steps", "nodes of the pyramid that are opened and cells that are tested, a ray", 1, 1,
       [](const Row& r) { return inPyramids(r, r.stepsPerRay()); }},
      {"max_steps", "most", "the most steps of a ray", 0, 1, [](const Row& r) { return inPyramids(r, r.maxSteps); }},
      {"boxes_per_ray", "boxes", "bounds that are compared, a ray", 1, 1,
       [](const Row& r) { return inPyramids(r, r.boxesPerRay()); }},
      {"samples", "samples", "of the images", 0, 1, [](const Row& r) { return counted(r.samples); }},
      {"triangles", "triangles", "that rays can hit", 0, 1, [](const Row& r) { return counted(r.triangles); }},
      {"build_ms", "build ms", "of the images; of the acceleration structure where the geometry is traced", 1, 1,
       [](const Row& r) -> Value { return r.buildMilliseconds; }},
      {"structure_ms", "pyramid ms", "of the cells and the pyramid", 1, 1,
       [](const Row& r) { return inPyramids(r, r.structureMilliseconds); }},
      {"shade_ms", "rays ms", "of all rays, on all threads", 1, 1,
       [](const Row& r) -> Value { return r.shadeMilliseconds; }},
  };
  return columns;
}

std::string textOf(const ShadeColumn& column, const ShadeFigures& row) {
  const Value value = column.value(row);
  if (!value) {
    return "-";
  }
  return std::isinf(*value) ? "inf" : fmt::format("{:.{}f}", *value * column.scale, column.digits);
}

std::string shadeTable(const ShadeReport& report) {
  size_t widest = 3;
  for (const ShadeFigures& row : report.rows) {
    widest = std::max(widest, row.name.size());
  }
  std::string text = fmt::format("{:<{}}", "by", widest);
  for (const ShadeColumn& column : shadeColumns()) {
    text += fmt::format("  {:>10}", column.heading);
  }
  text += "\n";
  for (const ShadeFigures& row : report.rows) {
    text += fmt::format("{:<{}}", row.name, widest);
    for (const ShadeColumn& column : shadeColumns()) {
      text += fmt::format("  {:>10}", textOf(column, row));
    }
    text += "\n";
  }
  return text;
}

std::string shadeJson(const ShadeReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["scene"] = report.scene;
  json["effect"] = report.effect;
  json["view"] = Json::parse(jsonText(report.view));
  json["size"] = {report.size.x, report.size.y};
  json["reference_view"] = Json::parse(jsonText(report.referenceView));
  json["reference_size"] = {report.referenceSize.x, report.referenceSize.y};
  json["cell_side"] = report.cellSide;
  json["environment_height"] = report.environmentHeight;
  json["runs"] = report.runs;
  json["rays"] = report.rows.empty() ? 0 : report.rows.front().rays;
  json["cast_rays"] = report.rows.empty() ? 0 : report.rows.front().castRays;
  json["by"] = Json::array();
  for (const ShadeFigures& row : report.rows) {
    Json entry{{"name", row.name}};
    for (const ShadeColumn& column : shadeColumns()) {
      entry[column.field] = numberOrNull(column.value(row));
    }
    json["by"].push_back(entry);
  }
  return textOfJson(json, 2) + "\n";
}

std::string shadeCsv(const ShadeReport& report) {
  std::string text = "name,rays,cast_rays";
  for (const ShadeColumn& column : shadeColumns()) {
    text += fmt::format(",{}", column.field);
  }
  text += "\n";
  for (const ShadeFigures& row : report.rows) {
    text += fmt::format("{},{},{}", inCsv(row.name), row.rays, row.castRays);
    for (const ShadeColumn& column : shadeColumns()) {
      const Value value = column.value(row);
      text += value ? fmt::format(",{}", *value) : ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace ocelli
