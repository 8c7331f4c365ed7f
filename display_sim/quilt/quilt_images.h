// A quilt from reference images: an epipolar occlusion camera (section 3.3) samples what is seen from anywhere on a
// line, and the views of a quilt stand on a line. The rows of its image are rows of the tiles, so every view follows
// row by row (line_painter.h), and the scene itself is drawn for the image alone.
//
// The image has a base pinhole at one end of its line, and samples there as densely as a tile does. What the base sees
// at a grazing angle and the other end straight on has too few samples. So there is either one image, whose base is the
// leftmost view, or two, whose base is the middle: one to each side.
#pragma once

#include <optional>
#include <vector>

#include "display_sim/quilt/quilt_picture.h"
#include "display_sim/quilt/sample_lines.h"
#include "oc_core/base/progress.h"
#include "oc_core/ocri/eoc_builder.h"

namespace ocelli {

struct QuiltImageOptions {
  int images = 2;       ///< 1 or 2
  double sampling = 1;  ///< samples for each pixel of a tile, along its rows
  EocOptions eoc{};
};

/// A reference image as lines, and for which views.
struct QuiltLines {
  SampleLines lines;
  double stretch = 1;  ///< of the world that its image was made in (quilt_views.h)
  int firstView = 0;
  int endView = 0;  ///< the view after the last one
  size_t samples = 0;
  int width = 0;  ///< of the image, pixels

  bool serves(int view) const { return view >= firstView && view < endView; }
};

/// `scene` is in the world that is stretched by views.stretch() times options.sampling; `renderer` draws it, or else it
/// is rasterised. Throws InputError as buildEocImage() does.
std::vector<QuiltLines> quiltLines(const QuiltViews& views, const Mesh& scene, const QuiltImageOptions& options = {},
                                   const SceneRenderer* renderer = nullptr);

/// Of an image that was made in the world as it is. Nothing where its rows are not those of the tiles.
std::optional<QuiltLines> quiltLinesOf(const QuiltViews& views, const ReferenceImage& image);

/// Every view must be served by one of them.
QuiltPicture quiltFromLines(const QuiltViews& views, const std::vector<QuiltLines>& images,
                            QuiltDepths depths = QuiltDepths::kNone);

/// The same views of any reference images, by their mesh: slower, and what the above is compared with. The images were
/// made in a world that is stretched by `stretch`. Nothing is filled in: `filled` counts what the mesh does not cover.
QuiltPicture quiltFromMesh(const QuiltViews& views, const ReferenceImages& images, double stretch,
                           QuiltDepths depths = QuiltDepths::kNone, const Progress& progress = {});

}  // namespace ocelli
