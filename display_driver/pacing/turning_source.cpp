#include "display_driver/pacing/turning_source.h"

#include <cmath>

#include "display_sim/slicing/turn_about_axis.h"
#include "oc_core/base/conventions.h"

namespace ocelli {

TurningSource::TurningSource(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
                             double degreesPerSecond)
    : positions_(mesh.positions),
      turned_(mesh.positions.size()),
      mesh_(mesh),
      slicer_(profile, options),
      radiansPerSecond_(degreesPerSecond * kPi / 180) {}

SourcedVolume TurningSource::volumeFor(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const double angle =
      std::remainder(radiansPerSecond_ * std::chrono::duration<double>(seen - *start_).count(), 2 * kPi);
  turnAboutAxis(positions_, angle, turned_);
  mesh_.setPositions(turned_);
  slicer_.slice(mesh_);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
