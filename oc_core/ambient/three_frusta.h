// The graph camera of Figure 4.30 (section 4.3.4.4): the frustum of a view up to a vertical plane through a splitting
// point, and a left and a right frustum beyond, which see around what stands before the plane. It holds the samples of
// the view before the plane, and behind it those visible from two viewpoints nearby.
//
// The two viewpoints are the eye, turned about the vertical through the splitting point: the rays to the left of that
// line go on as from farther left, those to the right as from farther right. Both end at the vertical plane through eye
// and splitting point, so that each place is seen once.
//
// The splitting point follows a curve as the view revolves. The text's was designed by hand for a dragon; here it is
// made from the scene: where the scene is seen lengthwise it lies in its middle, and the more it is seen sideways the
// farther back, until it is behind all of it. Then the camera is the view's own.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class SplitCurve {
 public:
  static constexpr int kHeadings = 64;

  /// Throws InputError for a mesh without vertices.
  explicit SplitCurve(const Mesh& mesh);

  const glm::dvec3& center() const { return center_; }
  /// Where the splitting point lies for a view of that direction, from the centre along the direction without its
  /// height, world units; negative: before the centre. Smooth in the heading. Of a vertical direction the point
  /// is the centre.
  double offset(const glm::dvec3& viewDirection) const;
  /// The same as a share of half of the scene's extent along that direction: 1 and more is behind all of it.
  double share(const glm::dvec3& viewDirection) const;
  glm::dvec3 pointFor(const glm::dvec3& viewDirection) const;
  /// The point of another share, for the same direction.
  glm::dvec3 pointAt(const glm::dvec3& viewDirection, double share) const;

 private:
  glm::dvec3 center_{0};
  std::vector<double> halfExtent_;  ///< along each heading
  std::vector<double> share_;
};

struct ThreeFrustaOptions {
  double turnDegrees = 30;  ///< of the viewpoints beyond the plane
};

/// The root of the view alone where the splitting point lies behind all of the scene (`world`, not empty). One bent
/// frustum where it is beyond the left or right border of the image. Throws InputError where the view looks straight up
/// or down, where the splitting point does not lie before the eye, and where GraphCamera does: rays of the view that do
/// not cross the plane.
GraphCamera threeFrusta(const PinholeCamera& view, const glm::dvec3& splittingPoint, const Box& world,
                        const ThreeFrustaOptions& options = {});

/// The same view with a border of so many pixels around its image: what lies just outside of it hides light, too.
PinholeCamera withBorder(const PinholeCamera& view, int pixels);

}  // namespace ocelli
