#include "oc_core/volume/volume_summary.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "oc_core/base/check.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_percentiles.h"

namespace ocelli {
namespace {

/// Of axes of the world, in the frame of patients (LPS) and in any other: towards more and towards less.
using WaysOfAxes = std::array<std::pair<std::string_view, std::string_view>, 3>;
constexpr WaysOfAxes kWaysOfPatients{{{"left", "right"}, {"back", "front"}, {"top", "bottom"}}};
constexpr WaysOfAxes kWaysOfWorlds{{{"+x", "-x"}, {"+y", "-y"}, {"+z", "-z"}}};

constexpr double kAligned = 0.999;

}  // namespace

std::string directionOfAxis(const VolumeGrid& grid, int axis) {
  const glm::dvec3 along = glm::normalize(glm::dvec3(grid.worldFromIndex[axis]));
  const glm::dvec3 lengths = glm::abs(along);
  const int world = lengths.x >= lengths.y && lengths.x >= lengths.z ? 0 : lengths.y >= lengths.z ? 1 : 2;
  const auto& [more, less] = (grid.isAnatomical ? kWaysOfPatients : kWaysOfWorlds)[static_cast<size_t>(world)];
  return std::string(lengths[world] < kAligned ? "about " : "") + std::string(along[world] > 0 ? more : less);
}

VolumeSummary summaryOf(const VolumeSeries& series, size_t index, const LevelOptions& options,
                        const Progress& progress) {
  OC_CHECK(index < series.volumes.size(), "a series has the volume that is asked for");
  const ScalarVolume& whole = *series.volumes[index];
  const VolumeLevel level = levelFor(series.volumes[index], options, progress);
  VolumeSummary summary{.grid = whole.grid(),
                        .bounds = boundsOf(whole.grid(), whole.grid().worldFromIndex),
                        .type = whole.type(),
                        .scale = whole.scale(),
                        .offset = whole.offset(),
                        .facts = whole.facts(),
                        .times = series.times,
                        .bytes = whole.voxels().size(),
                        .bytesToRead = whole.store() == nullptr ? whole.voxels().size() : whole.store()->bytesToRead(),
                        .isMapped = whole.store() != nullptr,
                        .survey = surveyVoxels(*level.volume),
                        .level = describeLevel(level, whole.grid()),
                        .preset = series.appearance ? "" : presetFor(*level.volume).name};
  std::ranges::copy(percentilesOf(*level.volume, VolumeSummary::kPercents), summary.percentiles.begin());
  return summary;
}

}  // namespace ocelli
