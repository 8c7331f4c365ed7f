#include "oc_core/ocri/representation.h"

#include <chrono>

#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {

size_t Representation::sampleCount() const {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return images.empty() ? mesh.positions.size() : samples;
}

size_t Representation::pixelCount() const {
  size_t pixels = 0;
  for (const ReferenceImage& image : images) {
    pixels += image.t.size();
  }
  return pixels;
}

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// `make` makes the images, and may make the mesh.
template <class Make>
Representation made(const std::string& name, RepresentationTimes* times, const Make& make) {
  RepresentationTimes taken;
  Representation representation{name, {}, {}};
  const auto start = Clock::now();
  make(representation);
  taken.buildMilliseconds = millisecondsSince(start);
  const auto built = Clock::now();
  if (!representation.images.empty()) {
    representation.mesh = unionMesh(representation.images);
  }
  taken.meshMilliseconds = millisecondsSince(built);
  if (times != nullptr) {
    *times = taken;
  }
  return representation;
}

}  // namespace

Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                   const Progress& progress, RepresentationTimes* times) {
  // As many triangles as the meshes that it is compared with; finding that out is no part of its work.
  const size_t target = choice.hasImages() ? 0 : unionMesh({buildDepthImage(reference, mesh)}).triangles.size();
  return made(choice.name, times, [&](Representation& representation) {
    if (choice.hasImages()) {
      representation.images = buildReferenceImages(choice, reference, mesh, progress);
    } else {
      representation.mesh = choice.kind->mesh(mesh, target);
    }
  });
}

Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference,
                                   const TargetRenderer& target, const Progress& progress, RepresentationTimes* times) {
  return made(choice.name, times, [&](Representation& representation) {
    representation.images = buildReferenceImages(choice, reference, target, progress);
  });
}

}  // namespace ocelli
