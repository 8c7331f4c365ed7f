// Hybrid ray casting by epipolar spans for the epipolar occlusion camera (section 3.4.2): each triangle is cut along
// the epipolar lines, and each piece, a span, is intersected with the rays of its row that can meet it.
//
// Three kinds of rays, three ways. Rays that no edge added see what the base pinhole sees: its image is taken as it is.
// The far ends of added rays, rays of L, are sampled at the centres of base pixels. Their near ends, rays of R, are
// sampled where the span, seen from R, passes their place.
//
// DEVIATION: the text processes every triangle with the whole camera. What L sees lies in no disocclusion, so here only
// triangles that reach into a disocclusion are cut into spans.
//
// A sample on the common edge of two triangles belongs to one of them; the closest fragment wins, the lower triangle
// index on a tie. Rows are drawn in bands, each by one thread: the same bytes for any number of threads.
#pragma once

#include <memory>

#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// What `base` sees along its epipolar lines: a row for each line, a column for each base pixel of the longest.
FragmentImage rasterizeLines(const PinholeCamera& base, const EpipolarLines& lines, const Mesh& mesh);

/// What the base pinhole sees, where it is in no disocclusion, at the columns of its rays; nothing at all others.
FragmentImage baseFragments(const EpipolarCamera& camera, const FragmentImage& baseImage);

/// Draws a mesh by cameras that share their base pinhole and their lines, and projects it once. All must outlive it.
class LineDrawing {
 public:
  LineDrawing(const PinholeCamera& base, const EpipolarLines& lines, const Mesh& mesh);
  ~LineDrawing();
  LineDrawing(const LineDrawing&) = delete;
  LineDrawing& operator=(const LineDrawing&) = delete;

  /// rasterizeLines() of the base.
  FragmentImage baseImage() const;
  /// The closest fragment along each ray of a camera with this base and these lines; `baseImage` is that of above.
  FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage);
  /// The same, where the disocclusions of the camera lie within those of the last one that was drawn.
  FragmentImage drawAgain(const EpipolarCamera& camera, const FragmentImage& baseImage);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The closest fragment along each ray of `camera`. `baseImage` is rasterizeLines() of its base and lines.
FragmentImage rasterize(const EpipolarCamera& camera, const Mesh& mesh, const FragmentImage& baseImage);
FragmentImage rasterize(const EpipolarCamera& camera, const Mesh& mesh);

}  // namespace ocelli
