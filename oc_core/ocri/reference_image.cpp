#include "oc_core/ocri/reference_image.h"

#include <algorithm>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/construction.h"

namespace ocelli {

size_t ReferenceImage::sampleCount() const {
  return static_cast<size_t>(std::count(held.begin(), held.end(), uint8_t{1}));
}

ReferenceImage blankReferenceImage(const std::string& camera, const View& view, int width, int height, bool placed) {
  ReferenceImage image{.camera = camera,
                       .view = view,
                       .color = Image<glm::vec3>(width, height),
                       .t = Image<float>(width, height),
                       .held = Image<uint8_t>(width, height),
                       .displacement = Image<glm::vec2>(width, height)};
  if (placed) {
    image.position = Image<glm::vec3>(width, height);
    image.direction = Image<glm::vec3>(width, height);
  }
  return image;
}

namespace {

void setSample(ReferenceImage& image, int x, int y, const Fragment& fragment, const Mesh& mesh,
               const PinholeCamera& reference) {
  const ImagePoint q = reference.imageFromCamera(reference.cameraFromWorld(positionOf(fragment, mesh)));
  image.set(x, y, q.t, colorOf(fragment, mesh));
  image.displacement(x, y) = {static_cast<float>(x) + 0.5f - q.u, static_cast<float>(y) + 0.5f - q.v};
}

/// Calls `body(x, y, fragment)` for each pixel, on all threads.
template <class Body>
void forFragments(const FragmentImage& fragments, const Body& body) {
  parallelFor(static_cast<size_t>(fragments.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < fragments.width(); ++x) {
        body(x, y, fragments(x, y));
      }
    }
  });
}

}  // namespace

ReferenceImage referenceImage(const FragmentImage& fragments, const Mesh& mesh, const PinholeCamera& reference,
                              const std::string& camera) {
  ReferenceImage image = blankReferenceImage(camera, reference.view(), fragments.width(), fragments.height());
  forFragments(fragments, [&](int x, int y, const Fragment& fragment) {
    if (fragment.covered()) {
      setSample(image, x, y, fragment, mesh, reference);
    }
  });
  return image;
}

void updateReferenceImage(ReferenceImage& image, const FragmentImage& before, const FragmentImage& fragments,
                          const Mesh& mesh, const PinholeCamera& reference) {
  forFragments(fragments, [&](int x, int y, const Fragment& fragment) {
    if (fragment == before(x, y)) {
      return;
    }
    if (fragment.covered()) {
      setSample(image, x, y, fragment, mesh, reference);
    } else {
      image.clear(image.t.index(x, y));
      image.color(x, y) = glm::vec3(0);
      image.displacement(x, y) = glm::vec2(0);
    }
  });
}

ReferenceImage depthImage(const FragmentImage& seen, const PinholeCamera& camera, const Mesh& mesh) {
  ReferenceImage image = referenceImage(seen, mesh, camera, "di");
  // A pinhole displaces nothing: what is left is rounding.
  std::fill(image.displacement.begin(), image.displacement.end(), glm::vec2(0));
  return image;
}

ReferenceImage buildDepthImage(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  return depthImage(seenFrom(camera, mesh, renderer), camera, mesh);
}

}  // namespace ocelli
