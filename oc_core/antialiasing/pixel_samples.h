// One pixel by samples: the closest triangle at each, and the average of their colours (a flat kernel of one pixel,
// section 5.2.3.4).
#pragma once

#include <span>
#include <vector>

#include "oc_core/antialiasing/antialias_triangle.h"
#include "oc_core/antialiasing/antialias_view.h"
#include "oc_core/antialiasing/pixel_rule.h"

namespace ocelli {

/// A pixel that is being drawn. `base` is that of the triangles.
struct PixelPlace {
  int x = 0;
  int y = 0;
  glm::ivec2 base{0};
  AntialiasView::PixelArea area;
  /// The square of the pixel, in pixels of the reference from the base; only where the area is a square.
  ImageBox square() const {
    const glm::vec2 corner(area.corner - glm::dvec2(base));
    return {corner, corner + static_cast<float>(area.side)};
  }
};

/// Keeps its memory from pixel to pixel.
class PixelSamples {
 public:
  /// Where the samples of a pixel lie, for the calls below.
  void place(const AntialiasView& view, const PixelPlace& pixel, const SamplePattern& pattern);
  /// Around them; of a square pixel its square.
  const ImageBox& bounds() const { return bounds_; }
  /// The mean linear colour of the samples. The first of `triangles` wins a tie.
  glm::vec3 mean(std::span<const AntialiasTriangle* const> triangles, const PixelRule& rule, const Mesh& mesh,
                 const glm::vec3& background);

 private:
  struct Seen {
    float samples = 0;
    float x = 0;  ///< sums of their positions
    float y = 0;
  };

  void draw(const AntialiasTriangle& triangle, uint32_t index);

  const SamplePattern* pattern_ = nullptr;
  PixelPlace pixel_;
  ImageBox bounds_;
  glm::vec2 middle_{0};
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> nearest_;   ///< 1/z
  std::vector<uint32_t> which_;  ///< in the triangles, from 1 on; 0: none
  std::vector<Seen> seen_;
};

}  // namespace ocelli
