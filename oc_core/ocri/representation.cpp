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

Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                   const Progress& progress, RepresentationTimes* times) {
  using Clock = std::chrono::steady_clock;
  // As many triangles as the meshes that it is compared with; finding that out is no part of its work.
  const size_t target = choice.hasImages() ? 0 : unionMesh({buildDepthImage(reference, mesh)}).triangles.size();
  const auto start = Clock::now();
  Representation representation{choice.name, {}, {}};
  if (choice.hasImages()) {
    representation.images = buildReferenceImages(choice, reference, mesh, progress);
  } else {
    representation.mesh = choice.kind->mesh(mesh, target);
  }
  const auto built = Clock::now();
  if (choice.hasImages()) {
    representation.mesh = unionMesh(representation.images);
  }
  if (times != nullptr) {
    times->buildMilliseconds = std::chrono::duration<double, std::milli>(built - start).count();
    times->meshMilliseconds = std::chrono::duration<double, std::milli>(Clock::now() - built).count();
  }
  return representation;
}

}  // namespace ocelli
