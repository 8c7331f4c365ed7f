#include "display_driver/pacing/eyes_source.h"

#include <glm/geometric.hpp>
#include <utility>

#include "display_sim/slicing/slice_mesh.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

enum Step { kBuilding, kMeshing, kSlicing };

}  // namespace

EyesSource::EyesSource(const Mesh& mesh, const DisplayProfile& profile, EyesOptions options, EyeFeed& feed)
    : mesh_(mesh),
      options_(std::move(options)),
      feed_(feed),
      slicer_(profile, options_.slicing),
      stages_{{"reference image", {}}, {"mesh", {}}, {"slices", {}}} {
  if (!options_.camera.hasImages()) {
    throw InputError("this camera has no image to build for an eye", options_.camera.name, "--camera ddoc");
  }
}

EyesSource::~EyesSource() = default;

SourcedVolume EyesSource::leaveOut(const std::string& why) {
  if (leftOut_++ == 0) {
    firstLeftOut_ = why;
  }
  return {.kind = SourcedVolume::Kind::kSame};
}

SourcedVolume EyesSource::volumeFor(HostTime seen) {
  const bool ended = feed_.ended(seen);
  const std::optional<glm::vec3> eye = feed_.eyeAt(seen);
  if (!eye || eye == eye_) {
    return {.kind = ended ? SourcedVolume::Kind::kEnd : SourcedVolume::Kind::kSame};
  }
  eye_ = eye;
  auto begin = std::chrono::steady_clock::now();
  const auto finish = [&](Step step) {
    const auto end = std::chrono::steady_clock::now();
    stages_[step].times.add(end - begin);
    begin = end;
  };
  try {
    View view;
    view.eye = *eye;
    // Straight above, any direction is up.
    if (std::abs(glm::dot(glm::normalize(view.eye), view.up)) > 0.9999f) {
      view.up = {0, 0, -1};
    }
    validate(view, "the eye");
    const PinholeCamera reference(view, options_.width, options_.height);
    const ReferenceImages images = buildReferenceImages(options_.camera, reference, mesh_);
    finish(kBuilding);
    const Mesh seenMesh = unionMesh(images);
    finish(kMeshing);
    slicer_.slice(SliceMesh(seenMesh));
    finish(kSlicing);
    return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
  } catch (const InputError& error) {
    return leaveOut(error.what());
  }
}

}  // namespace ocelli
