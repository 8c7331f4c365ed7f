#include "oc_core/ocri/representation.h"

#include <chrono>

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
    pixels += image.z.size();
  }
  return pixels;
}

Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                   const Progress& progress, RepresentationTimes* times) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Representation representation{choice.name, buildReferenceImages(choice, reference, mesh, progress), {}};
  const auto built = Clock::now();
  representation.mesh = unionMesh(representation.images);
  if (times != nullptr) {
    times->buildMilliseconds = std::chrono::duration<double, std::milli>(built - start).count();
    times->meshMilliseconds = std::chrono::duration<double, std::milli>(Clock::now() - built).count();
  }
  return representation;
}

}  // namespace ocelli
