// Layouts of lenses at random, all valid: made by hand, as a person would.
#pragma once

#include <random>

#include "oc_core/camera/gpc_lens_edit.h"

namespace ocelli::test {

inline constexpr glm::dvec2 kLensImage{1280, 720};

class RandomLenses {
 public:
  explicit RandomLenses(unsigned seed) : random_(seed) {}

  double number(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
  size_t index(size_t count) { return std::uniform_int_distribution<size_t>(0, count - 1)(random_); }
  /// Also beside the image.
  glm::dvec2 place() { return {number(-0.2, 1.2), number(-0.2, 1.2)}; }
  LensCorner corner() { return static_cast<LensCorner>(index(4)); }
  const GpcSampling& sampling() { return gpcSamplings()[index(gpcSamplings().size())]; }

  GpcLayout layout(size_t wantedLenses) {
    GpcLayout layout;
    layout.regions.clear();
    layout.sampling = &sampling();
    for (size_t i = 0; i < wantedLenses; ++i) {
      GpcRegion lens;
      lens.center = {number(0, 1), number(0, 1)};
      lens.extent = {number(0.02, 0.3), number(0.02, 0.3)};
      lens.zoom = static_cast<float>(number(0.7, 8));
      lens.transitionWidth = static_cast<float>(number(0.05, 1.5));
      addLens(layout, lens, kLensImage);  // where there is room
    }
    return layout;
  }

 private:
  std::mt19937 random_;
};

}  // namespace ocelli::test
