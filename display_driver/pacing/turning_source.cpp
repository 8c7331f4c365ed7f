#include "display_driver/pacing/turning_source.h"

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kVerticesAtOnce = 1 << 14;

}  // namespace

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
  const auto cosine = static_cast<float>(std::cos(angle));
  const auto sine = static_cast<float>(std::sin(angle));
  parallelFor(positions_.size(), kVerticesAtOnce, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3& p = positions_[i];
      turned_[i] = {cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x};
    }
  });
  mesh_.setPositions(turned_);
  slicer_.slice(mesh_);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
