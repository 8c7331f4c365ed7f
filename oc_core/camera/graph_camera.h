// The graph camera (section 4.1): a tree of frusta, each with a viewpoint of its own, made from a planar pinhole camera
// by bending, splitting and merging. Its rays are polylines that change direction where they cross from one frustum
// into the next: so one image sees around corners, without a jump but for the lines between the parts of a split.
//
// A frustum begins at a plane, where its parent ends. Beyond it rays go on from where they cross it, away from the
// frustum's viewpoint, which lies before the plane. Its part of the image is a convex polygon: the rays that pass
// through it. Rays of a frustum that belong to no child go straight on, to zFar or to the first of the frustum's
// limits: planes, such as walls, that keep it out of what others see.
//
// Projection (Appendix A): a point P of a frustum with viewpoint C and plane p is seen where the line CP crosses p, by
// the parent. In homogeneous coordinates that is the matrix
//     X = (p . P) C - (p . C) P,
// whose weight is positive for all P beyond p, as C lies before it. M_0i, the product of these matrices along the way
// to the root and of the root's projection, gives pixels in one step. Where a pixel lies within the part of a frustum,
// its ray and the point are the same, so one test tells whether the frustum holds P.
//
// t is the length of the ray, bend after bend, times the cosine between its first segment and the view direction: for
// rays that do not turn it is the pinhole's z.
//
// DEVIATION: the text's graph, whose frusta have two parents after a merge, is kept as the tree that it projects with:
// each parent of a merge has a sub-frustum of its own, of one viewpoint and one plane.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/exact_image_point.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/plane.h"

namespace ocelli {

class GraphCamera {
 public:
  static constexpr int kRoot = 0;
  static constexpr size_t kMaxFrusta = 4096;
  static constexpr size_t kMaxBends = 64;  ///< from the root to a leaf

  /// Corners of the part of the image that a frustum takes, pixels, clockwise as seen (u to the right, v down).
  using Part = std::vector<glm::dvec2>;

  struct Frustum {
    std::string name;
    int parent = -1;  ///< of the root; that of others comes before them
    glm::dvec3 viewpoint{0};
    Plane plane;  ///< where it begins; its normal points into it. Of the root: zNear
    Part part;
    std::vector<int> children{};
    std::vector<Plane> limits{};   ///< normals point out of it
    glm::dmat4 pixelFromWorld{1};  ///< M_0i: rows 0, 1 and 3 give u, v and their weight
  };
  /// Where rays go on: beyond a plane, away from a viewpoint before it.
  struct Bend {
    Plane plane;
    glm::dvec3 viewpoint{0};
  };

  /// A pinhole: the root frustum alone.
  explicit GraphCamera(const PinholeCamera& root);

  /// The rays of frustum `i` that are in `part` bend; in all of it where `part` is empty. Returns the new frustum. All
  /// of these throw InputError, naming the frustum, where the plane cannot be crossed by each of those rays, after the
  /// plane of the parent and before zFar; where the viewpoint does not lie before it; where the part is not convex, not
  /// within that of the parent, or has rays that another child took; and where there are too many frusta.
  int bend(int i, const Bend& bend, const std::string& name, const Part& part = {});
  /// Two bends, parted by the line where their planes meet, as the frustum sees it. Throws InputError as well where the
  /// planes do not meet within the part of the frustum. Each side goes to the plane that its rays cross first.
  std::pair<int, int> split(int i, const Bend& one, const Bend& other, const std::string& oneName,
                            const std::string& otherName);
  /// One viewpoint for the rays of two frusta, beyond one plane.
  std::pair<int, int> merge(int i, int j, const Bend& bend, const std::string& name);
  /// Those rays of frustum `i` that belong to no child end where they cross the plane, whose normal points out of the
  /// frustum. Throws InputError, naming the frustum, where the plane is not finite, or all of the frustum is beyond it.
  void limit(int i, const Plane& plane);

  int width() const { return root_.width(); }
  int height() const { return root_.height(); }
  const PinholeCamera& root() const { return root_; }
  const std::vector<Frustum>& frusta() const { return frusta_; }
  /// What the two halves of the part are that a line of the image cuts; the first holds the points to the right of
  /// `from` -> `to`.
  static std::pair<Part, Part> cut(const Part& part, const glm::dvec2& from, const glm::dvec2& to);
  /// The mean of its corners, a pixel within it.
  static glm::dvec2 middleOf(const Part& part);

  /// Nothing for points that no frustum holds, but those that the pinhole sees beyond the borders. Where frusta
  /// overlap, the image of the first that holds it.
  std::optional<ExactImagePoint> projectExactly(const glm::dvec3& worldPoint) const;
  std::optional<glm::dvec3> unprojectExactly(const ExactImagePoint& imagePoint) const;
  /// The frustum that holds a point; -1 for none.
  int frustumOf(const glm::dvec3& worldPoint) const;
  /// t of a point that frustum `i` holds.
  double depth(int i, const glm::dvec3& point) const;
  /// The child of frustum `i` that rays of a pixel go on to; -1 where they go straight on.
  int childAt(int i, const glm::dvec2& pixel) const;
  /// Whether a point lies beyond a limit of frustum `i`.
  bool isBeyondLimits(int i, const glm::dvec3& point) const;

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  [[noreturn]] void fail(const std::string& name, const std::string& what, const std::string& next) const;
  bool holds(int i, const glm::dvec3& point, double pixelRounding) const;
  /// The ray of a pixel in a frustum: from where it begins, along a direction whose length advances t by 1.
  struct Segment {
    glm::dvec3 from;
    glm::dvec3 direction;
    double t;
  };
  Segment rootSegment(const glm::dvec2& pixel) const;
  Segment next(const Segment& segment, int child) const;
  Segment segmentIn(int i, const glm::dvec2& pixel) const;
  double endOf(int i, const Segment& segment) const;
  template <class Visit>
  void walk(const glm::dvec2& pixel, const Visit& visit) const;

  PinholeCamera root_;
  std::vector<Frustum> frusta_;
};

static_assert(Camera<GraphCamera>);

/// As for cameras that displace the image of a pinhole (distorted_pinhole.h): the one whose image it is.
inline const PinholeCamera& referenceOf(const GraphCamera& camera) {
  return camera.root();
}

}  // namespace ocelli
