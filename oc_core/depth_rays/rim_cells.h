// The surface of a reference image up to where the scene's surfaces end: rims between samples, as if pixels there were
// finer.
//
// sample_cells.h ends a surface half a pixel behind its last sample, wherever the outline is; that is most of what rays
// lose at images that lack nothing else. Here, between a sample and a neighbour that it is not joined with, the last
// point of its surface on the rays between the two is found by halving, at the scene itself, and is one more sample: a
// rim. Cells that a surface only partly crosses are closed between samples and rims, in the manner of marching squares.
// All vertices are points of the scene, so nothing stands out beside a surface by more than chords of it do.
#pragma once

#include <functional>

#include "oc_core/camera/ray_path.h"
#include "oc_core/depth_rays/sample_cells.h"
#include "oc_core/render/ray_target.h"

namespace ocelli {

struct RimCells {
  SampleCells cells;
  size_t rims = 0;                      ///< samples beside those of pixels
  std::vector<uint32_t> pixelOfVertex;  ///< of the mesh: the pixel that a vertex belongs to
};

/// Whether rimCells() takes the images: one, of one layer, that displaces a pinhole's, with rows as they lie.
bool canHaveRims(const ReferenceImages& images);

/// `ray` is the ray of any position in the image, and `geometry` what the image was made of.
RimCells rimCells(const ReferenceImage& image, const std::function<RayPath(const glm::vec2& pixel)>& ray,
                  const RayTarget& geometry);

}  // namespace ocelli
