#include "oc_core/volume/volume_summary_json.h"

#include <nlohmann/json.hpp>

#include "oc_core/base/json_document.h"

namespace ocelli {

std::string volumeSummaryJson(const std::string& source, const VolumeSummary& summary) {
  using SummaryJson = nlohmann::ordered_json;
  const auto list = [](const auto& p) { return SummaryJson::array({p.x, p.y, p.z}); };
  SummaryJson columns = SummaryJson::array();
  for (int column = 0; column < 4; ++column) {
    columns.push_back(list(glm::dvec3(summary.grid.worldFromIndex[column])));
  }
  SummaryJson percentiles = SummaryJson::array();
  for (size_t i = 0; i < summary.percentiles.size(); ++i) {
    percentiles.push_back({{"percent", VolumeSummary::kPercents[i]}, {"value", summary.percentiles[i]}});
  }
  SummaryJson info{{"volume", source},
                   {"format", summary.facts.format},
                   {"modality", summary.facts.modality},
                   {"size", list(summary.grid.size)},
                   {"type", nameOf(summary.type)},
                   {"spacing", list(summary.grid.spacing())},
                   {"unit", summary.grid.unit},
                   {"anatomical", summary.grid.isAnatomical},
                   {"axes", SummaryJson::array({directionOfAxis(summary.grid, 0), directionOfAxis(summary.grid, 1),
                                                directionOfAxis(summary.grid, 2)})},
                   {"world_from_index_columns", columns},
                   {"lower", list(summary.bounds.lower)},
                   {"upper", list(summary.bounds.upper)},
                   {"value_unit", summary.facts.valueUnit},
                   {"scale", summary.scale},
                   {"offset", summary.offset},
                   {"least", summary.survey.range.least},
                   {"greatest", summary.survey.range.greatest},
                   {"percentiles", percentiles},
                   {"not_finite", summary.survey.notFinite},
                   {"bytes", summary.bytes},
                   {"bytes_to_read", summary.bytesToRead},
                   {"mapped", summary.isMapped},
                   {"times", summary.times},
                   {"transfer", summary.preset},
                   {"level", summary.level}};
  if (summary.survey.notFinite > 0) {
    info["first_not_finite"] = list(summary.survey.firstNotFinite);
  }
  return textOfJson(info, 2) + "\n";
}

}  // namespace ocelli
