#include "oc_core/volume/volume_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_reader.h"
#include "oc_core/volume/voxel_survey.h"

namespace ocelli {
namespace {

constexpr const char* kLoadingStage = "loading the volume";

VolumeSeries seriesOf(VolumeFile file, const std::string& source) {
  VolumeSeries series{.source = source, .times = std::move(file.times), .warnings = std::move(file.warnings)};
  for (ScalarVolume& volume : file.volumes) {
    series.volumes.push_back(std::make_shared<const ScalarVolume>(std::move(volume)));
  }
  const size_t count = series.volumes.size();
  if (count == 1) {
    series.times.clear();
  } else if (series.times.empty()) {
    series.warnings.push_back(
        fmt::format("nothing says the times of its {} volumes: they are taken as 0, 1, 2, ... s", count));
    for (size_t index = 0; index < count; ++index) {
      series.times.push_back(static_cast<double>(index));
    }
  }
  return series;
}

/// Beyond this, what is drawn with floats (gradients, steps between values) may overflow.
constexpr double kMaxShownValue = 1e37;

bool isWithinShown(double value) {
  return std::abs(value) <= kMaxShownValue;
}

/// Whether every voxel of whole numbers of this type means a value that can be shown, whatever it holds.
bool areAllShowable(const ScalarVolume& volume) {
  return visitVoxels(volume, [&](const auto* first) {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    using Limits = std::numeric_limits<Voxel>;
    return std::is_integral_v<Voxel> &&
           isWithinShown(volume.scale() * static_cast<double>(Limits::max()) + volume.offset()) &&
           isWithinShown(volume.scale() * static_cast<double>(Limits::lowest()) + volume.offset());
  });
}

/// Throws InputError where a voxel is no number, or means a value that cannot be shown.
void requireShowable(const VolumeLevel& level, const std::string& source) {
  if (areAllShowable(*level.volume)) {
    return;
  }
  const VoxelSurvey survey = surveyVoxels(*level.volume);
  requireFinite(survey, source, level.factor);
  if (!isWithinShown(survey.range.least) || !isWithinShown(survey.range.greatest)) {
    throw InputError(fmt::format("voxels mean values from {:g} to {:g}: they can be shown from {:g} to {:g}",
                                 survey.range.least, survey.range.greatest, -kMaxShownValue, kMaxShownValue),
                     source,
                     "correct the scale in its header, or give voxels that have no value that of the background");
  }
}

VolumeLevel checkedLevel(const VolumeSeries& series, size_t index, const VolumeSceneOptions& options,
                         const Progress& progress) {
  VolumeLevel level = levelFor(series.volumes[index], options.level, progress);
  requireShowable(level, series.source);
  return level;
}

/// `transfer` is nullptr where the options, the series or the volume say it.
VolumeAppearance appearanceIn(const VolumeSeries& series, const VolumeLevel& level, size_t index,
                              const TransferDescription* transfer, const VolumeSceneOptions& options) {
  if (transfer == nullptr && options.transfer.empty() && series.appearance) {
    return *series.appearance;
  }
  const double meanSpacing = series.volumes[index]->grid().meanSpacing();
  const auto described = [&](const ScalarVolume& volume) {
    const TransferDescription description = transfer != nullptr        ? *transfer
                                            : options.transfer.empty() ? presetFor(volume).description
                                                                       : transferByName(options.transfer);
    if (options.warn && !hasScaleFor(description, volume)) {
      options.warn(
          fmt::format("all voxels have the value {:g}: nothing is shown by a transfer function whose values "
                      "are relative to those of the volume (one with \"values\": \"absolute\" shows them)",
                      volume.valueAt({0, 0, 0})));
    }
    return appearanceOf(description, volume, meanSpacing);
  };
  return index == 0 ? described(*level.volume) : described(*checkedLevel(series, 0, options, {}).volume);
}

/// What puts a volume on the grid into the scene, from the world of the grid.
glm::dmat4 sceneFromGridWorld(const VolumeGrid& grid, bool fit, const std::string& source) {
  const glm::dmat4 upright = grid.isAnatomical ? sceneFromPatient() : glm::dmat4(1);
  if (!fit) {
    return upright;
  }
  // In double precision, and the centre apart: a small volume may stand far from its world's origin.
  const glm::dmat4 sceneFromIndex = upright * grid.worldFromIndex;
  const glm::dvec3 center(sceneFromIndex * glm::dvec4(glm::dvec3(grid.size - 1) * 0.5, 1));
  glm::dvec3 halfSize(0);
  for (int axis = 0; axis < 3; ++axis) {
    halfSize += glm::abs(glm::dvec3(sceneFromIndex[axis])) * (0.5 * grid.size[axis]);
  }
  glm::dmat4 toOrigin(1);
  toOrigin[3] = glm::dvec4(-center, 1);
  return glm::dmat4(unitFromSphere(glm::dvec3(0), glm::length(halfSize), source)) * toOrigin * upright;
}

VolumeScene volumeSceneWith(const VolumeSeries& series, size_t index, const TransferDescription* transfer,
                            const VolumeSceneOptions& options, const Progress& progress) {
  OC_CHECK(index < series.volumes.size(), "a series has the volume that is asked for");
  const VolumeLevel level = checkedLevel(series, index, options, progress);
  const VolumeGrid& whole = series.volumes[index]->grid();
  if (options.warn) {
    for (const std::string& warning : series.warnings) {
      options.warn(warning);
    }
    if (level.factor > 1) {
      options.warn(describeLevel(level, whole));
    }
  }
  VolumeScene scene{
      .volume = level.volume,
      .worldFromIndex = sceneFromGridWorld(whole, options.fit, series.source) * level.volume->grid().worldFromIndex,
      .appearance = appearanceIn(series, level, index, transfer, options),
      .clips = options.clips,
      .whole = series.volumes[index],
      .levelFactor = level.factor,
      .times = series.times};
  report(progress, kLoadingStage, 1);
  return scene;
}

}  // namespace

size_t VolumeSeries::indexAt(double seconds) const {
  if (times.empty()) {
    throw InputError("this volume stands still: it has no time", source, "leave out --time, or give a time series");
  }
  if (!(seconds >= times.front() && seconds <= times.back())) {
    throw InputError(fmt::format("this time series has no time {:g} s", seconds), source,
                     fmt::format("give a time from {:g} to {:g}", times.front(), times.back()));
  }
  return static_cast<size_t>(std::ranges::upper_bound(times, seconds) - times.begin()) - 1;
}

VolumeSeries loadVolumeSeries(const std::string& source, const std::string& series, const Progress& progress) {
  report(progress, kLoadingStage, 0);
  if (!isBuiltinVolume(source)) {
    return seriesOf(readVolumeFile(source, {.series = series}, progress), source);
  }
  if (!series.empty()) {
    throw InputError("only a folder of DICOM files has series", source, "leave the series out");
  }
  BuiltinVolume made = makeBuiltinVolume(source);
  VolumeSeries one{.source = source, .appearance = std::move(made.appearance)};
  one.volumes.push_back(std::make_shared<const ScalarVolume>(std::move(made.volume)));
  return one;
}

VolumeScene volumeSceneAt(const VolumeSeries& series, size_t index, const VolumeSceneOptions& options,
                          const Progress& progress) {
  return volumeSceneWith(series, index, nullptr, options, progress);
}

VolumeScene volumeSceneAt(const VolumeSeries& series, size_t index, const TransferDescription& transfer,
                          const VolumeSceneOptions& options, const Progress& progress) {
  return volumeSceneWith(series, index, &transfer, options, progress);
}

}  // namespace ocelli
