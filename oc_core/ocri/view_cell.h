// The view cell: the viewpoints around the reference eye that a reference image is made for (section 3.5.5.7 has the
// edges of a cube). Its places are given along (right, up, backward) of the reference view, in display radii.
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/view.h"

namespace ocelli {

/// Viewpoints along an edge, from one corner of the cell to another.
struct EdgeSequence {
  std::vector<size_t> views;      ///< their numbers in edgeViews(), both corners included
  std::vector<glm::vec3> places;  ///< of each: right, up and backward, in half sides
};

struct ViewCell {
  enum class Shape {
    kCube,
    kSphere,
    kSegment,
  };

  float sideRadii = 1.6f;  ///< 8 in at the reference display; the diameter of a sphere, the length of a segment
  Shape shape = Shape::kCube;
  glm::vec3 segmentDirection{1, 0, 0};  ///< any length but 0; of no meaning for the other shapes

  float halfSide() const { return sideRadii / 2; }

  /// The farthest viewpoints. Cube: `between` of them on each of the 12 edges, which they and the corners divide into
  /// equal steps, edge after edge, then the 8 corners. Sphere: the 20 corners of the regular dodecahedron in it.
  /// Segment: its two ends. Those two have as many, whatever `between` is.
  std::vector<View> edgeViews(const View& reference, int between = 1) const;
  /// The ways along the edges of a cube that section 3.5.5.7 moves the viewpoint on, in the order of edgeViews(); other
  /// shapes have none.
  std::vector<EdgeSequence> edgeSequences(int between = 1) const;
  /// `count` viewpoints inside, uniform, from a seed.
  std::vector<View> interiorViews(const View& reference, int count, unsigned seed) const;
  /// Unit vectors along which the viewpoint can move half a side from the middle: uniform over the sphere, from a seed.
  /// A segment has two, whatever `count` is.
  std::vector<glm::vec3> directions(int count, unsigned seed) const;
};

/// "cube", "sphere", "segment".
std::string cellShapeName(ViewCell::Shape shape);
/// Throws InputError naming `where` for any other text.
ViewCell::Shape cellShapeFromName(const std::string& name, const std::string& where);

}  // namespace ocelli
