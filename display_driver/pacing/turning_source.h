// A scene that turns about the display's axis, sliced anew for each refresh.
#pragma once

#include <optional>
#include <vector>

#include "display_driver/pacing/volume_source.h"
#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slicer.h"

namespace ocelli {

class TurningSource final : public VolumeSource {
 public:
  /// `mesh` is validated, its positions in display radii. Positive degrees turn it counter-clockwise seen from above.
  TurningSource(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, double degreesPerSecond);

  SourcedVolume volumeFor(HostTime seen) override;

 private:
  std::vector<glm::vec3> positions_;  ///< as they were given
  std::vector<glm::vec3> turned_;
  SliceMesh mesh_;
  Slicer slicer_;
  double radiansPerSecond_;
  std::optional<HostTime> start_;
};

}  // namespace ocelli
