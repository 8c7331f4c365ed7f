// The depth image of a graph camera, and where a ray meets it (sections 4.3.4.1, 4.3.4.2): an approximation of all that
// the camera sees, for effects such as reflections.
//
// The ray is cut by the pieces of the frusta (frustum_pieces.h), as each is a pinhole: the image of the ray in a piece
// is a straight line, walked pixel by pixel to where the ray passes through the surface (section 3.5.2.2).
//
// Depths are compared by the weights w of the homogeneous image points of a frustum (graph_camera.h). They are linear
// in the world, 0 at the viewpoint and grow along the ray of each pixel, in proportion to the distance from the
// viewpoint. So 1/w is linear in the image, for the ray and for planar surfaces, and two steps say exactly where a ray
// meets a plane. z is linear in neither behind a bend. Samples of other frusta are nearer than the ray's frustum where
// they are of those before it, and farther where they are of those behind it.
//
// Between pixels of two surfaces, where a depth image says nothing, a ray may pass. A surface is torn where its depth
// jumps by more than the thickness that all are taken to have, and by more than it does next to there. A ray that gets
// behind such an edge by no more than the thickness has hit the nearer surface.
#pragma once

#include <optional>
#include <vector>

#include "oc_core/camera/frustum_pieces.h"
#include "oc_core/depth_rays/graph_depth_samples.h"

namespace ocelli {

class GraphDepthImage {
 public:
  struct Hit {
    double distance = 0;  ///< along the ray, world units
    glm::dvec2 place{0};  ///< image coordinates, pixels
    int frustum = 0;
  };
  struct Options {
    double thickness = 0.01;  ///< of what the image shows, world units
    bool coarse = true;       ///< skips whole tiles of pixels that the ray does not meet: faster, with the same hits
  };

  /// `fragments` is the camera's image, whose frusta are disjoint (graph_overlap.h); its z is all that is used.
  GraphDepthImage(const GraphCamera& camera, const FragmentImage& fragments);

  const GraphCamera& camera() const { return camera_; }

  /// The first surface of the image that a ray meets within zFar of its origin. Nothing for a direction of length 0 and
  /// coordinates that are not finite. `steps`, where given, grows by the number of pixels and tiles looked at.
  std::optional<Hit> intersect(const glm::dvec3& origin, const glm::dvec3& direction, const Options& options,
                               size_t* steps = nullptr) const;
  std::optional<Hit> intersect(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return intersect(origin, direction, {});
  }

 private:
  class Walk;

  GraphCamera camera_;
  std::vector<FrustumPiece> pieces_;
  GraphDepthSamples samples_;
};

}  // namespace ocelli
