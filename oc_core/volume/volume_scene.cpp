#include "oc_core/volume/volume_scene.h"

#include <cmath>

#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/volume_reader.h"
#include "oc_core/volume/volume_series.h"

namespace ocelli {

double VolumeScene::sceneLengthOfUnit() const {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromIndex)))) / volume->grid().meanSpacing();
}

bool isVolumeSource(const std::string& source) {
  return isBuiltinVolume(source) || isVolumeFile(source);
}

VolumeScene loadVolumeScene(const std::string& source, const VolumeSceneOptions& options, const Progress& progress) {
  const VolumeSeries series = loadVolumeSeries(source, options.series, progress);
  return volumeSceneAt(series, options.seconds ? series.indexAt(*options.seconds) : 0, options, progress);
}

}  // namespace ocelli
