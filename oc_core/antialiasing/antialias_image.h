// Images of pinholes and general pinholes with antialiasing: extreme antialiasing (section 5.2.3) and what it is
// compared with.
//
// Each pixel is drawn on its own: the triangles that meet its square, less those behind one that fills it, are resolved
// as its rule says (pixel_rule.h). A pixel that one triangle fills, or none meets, takes one look whatever the rule.
// The "off-screen tile" of a region is drawn pixel by pixel too: it never stands in memory as a whole, no triangle is
// clipped at its border, and a pixel in two regions is drawn once, by the finer rule: nothing counts twice.
#pragma once

#include <vector>

#include "oc_core/antialiasing/antialias_bins.h"
#include "oc_core/antialiasing/pixel_rule.h"
#include "oc_core/image/image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct AntialiasPlan {
  std::vector<PixelRule> rules;
  Image<uint8_t> ruleOfPixel;  ///< empty: the first everywhere
};

/// How the pixels of an image were drawn.
struct AntialiasWork {
  size_t plain = 0;    ///< that nothing meets, or one triangle fills
  size_t exact = 0;    ///< by area
  size_t sampled = 0;  ///< by samples
  size_t samples = 0;  ///< of these
};

/// A mesh as one view sees it, ready to be drawn with any plan.
class AntialiasScene {
 public:
  /// The mesh must outlive it.
  AntialiasScene(const AntialiasView& view, const Mesh& mesh);
  AntialiasScene(const AntialiasScene&) = delete;
  AntialiasScene& operator=(const AntialiasScene&) = delete;

  const AntialiasView& view() const { return view_; }
  const ProjectedMesh& projected() const { return projected_; }
  const AntialiasBins& bins() const { return bins_; }
  /// Linear colours. The same with any number of threads. `work` is told what was done where it is given.
  Image<glm::vec3> draw(const AntialiasPlan& plan, const glm::vec3& background, AntialiasWork* work = nullptr) const;

 private:
  AntialiasView view_;
  ProjectedMesh projected_;
  AntialiasBins bins_;
};

}  // namespace ocelli
