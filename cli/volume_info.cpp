#include "cli/volume_info.h"

#include <fmt/format.h>

#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

/// " mm", or nothing.
std::string withSpace(const std::string& unit) {
  return unit.empty() ? "" : " " + printableText(unit);
}

std::string valueLines(const VolumeSummary& summary) {
  const std::string unit = withSpace(summary.facts.valueUnit);
  std::string text =
      fmt::format("  values     {:.6g} to {:.6g}{}", summary.survey.range.least, summary.survey.range.greatest, unit);
  if (summary.scale != 1 || summary.offset != 0) {
    text += fmt::format(", {:.6g} times what the file holds, plus {:.6g}", summary.scale, summary.offset);
  }
  text += "\n  percents  ";
  for (size_t i = 0; i < summary.percentiles.size(); ++i) {
    text += fmt::format(" {:g} %: {:.6g}{}", VolumeSummary::kPercents[i], summary.percentiles[i],
                        i + 1 < summary.percentiles.size() ? "," : "\n");
  }
  if (summary.survey.notFinite > 0) {
    const glm::ivec3& at = summary.survey.firstNotFinite;
    text += fmt::format("  no numbers {} voxels (NaN or infinite), the first at ({}, {}, {})\n",
                        summary.survey.notFinite, at.x, at.y, at.z);
  }
  return text;
}

std::string memoryLine(const VolumeSummary& summary) {
  std::string text = fmt::format("  bytes      {}", summary.bytes);
  if (summary.isMapped) {
    text += ", mapped from its file";
  }
  if (summary.bytesToRead < summary.bytes) {
    text += fmt::format(", {} of them not in holes", summary.bytesToRead);
  }
  return text + "\n";
}

}  // namespace

std::string volumeInfoAsText(const std::string& source, const VolumeSummary& summary) {
  const glm::ivec3& size = summary.grid.size;
  const glm::dvec3 spacing = summary.grid.spacing();
  std::string text = printableText(source) + "\n";
  const auto named = [&](const char* name, const std::string& value) {
    if (!value.empty()) {
      text += fmt::format("  {:<10} {}\n", name, printableText(value));
    }
  };
  named("format", summary.facts.format);
  named("modality", summary.facts.modality);
  text += fmt::format("  voxels     {} x {} x {}, {}\n", size.x, size.y, size.z, nameOf(summary.type));
  text += fmt::format("  spacing    {:.6g} x {:.6g} x {:.6g}{}\n", spacing.x, spacing.y, spacing.z,
                      withSpace(summary.grid.unit));
  text += fmt::format("  axes       i to {}, j to {}, k to {}{}\n", directionOfAxis(summary.grid, 0),
                      directionOfAxis(summary.grid, 1), directionOfAxis(summary.grid, 2),
                      summary.grid.isAnatomical ? ", of a patient" : "");
  for (int axis = 0; axis < 3; ++axis) {
    text += fmt::format("  {:<10} {:.6g} to {:.6g}{}\n", std::string(1, "xyz"[axis]), summary.bounds.lower[axis],
                        summary.bounds.upper[axis], withSpace(summary.grid.unit));
  }
  text += valueLines(summary);
  text += memoryLine(summary);
  if (!summary.times.empty()) {
    text += fmt::format("  times      {}, from {:.6g} to {:.6g} s\n", summary.times.size(), summary.times.front(),
                        summary.times.back());
  }
  named("transfer", summary.preset.empty() ? "one of its own" : summary.preset);
  named("level", summary.level);
  return text;
}

}  // namespace ocelli
