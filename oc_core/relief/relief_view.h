// Where the image of a relief object is made from (section 3.5.2.3.2): from above, along the normal of the surface that
// the tile stands on, and as wide as the object is from there.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The object is fitted to the unit sphere around the origin of the tile's coordinates, its normal along +y.
struct ReliefViews {
  View reference;      ///< from above
  glm::ivec2 size{0};  ///< pixels: in the object's proportions, of about as many texels as wanted
  ViewCell cell;  ///< around its eye: what the tile is seen from at 10 to 60 degrees and more lies in its directions
};

/// For images of `texels` pixels. `forCell` holds the object also in the images of pinholes at the cell's corners.
ReliefViews reliefViews(const Box& bounds, size_t texels, bool forCell);

/// A single pole camera over the object: the pole goes through the middle of its box, and displacements grow from its
/// highest point down to the ground, so that vertical sides are sampled about as densely as the top.
SpocCamera reliefSpoc(const Box& bounds, size_t texels);

/// Width and height of an image of about so many pixels, in the proportions of these sides.
glm::ivec2 imageSizeFor(double width, double height, size_t texels);

}  // namespace ocelli
