// One pixel by area: the mean of what its square shows, computed and not sampled.
//
// Lines through the corners and crossings of all edges in the pixel cut it into horizontal strips. In each strip the
// edges do not cross, so that the lengths that surfaces cover along its middle, times its height, are their areas. It
// takes about the square of the number of triangles: it is for pixels that few triangles meet.
#pragma once

#include <span>
#include <vector>

#include "oc_core/antialiasing/antialias_triangle.h"

namespace ocelli {

/// Keeps its memory from pixel to pixel.
class PixelArea {
 public:
  /// The most triangles of a pixel.
  static constexpr size_t kMaxTriangles = 16;

  /// The mean linear colour over `square`. Each triangle meets it, or may be left out. The first wins a tie.
  glm::vec3 mean(std::span<const AntialiasTriangle* const> triangles, const ImageBox& square, const Mesh& mesh,
                 const glm::vec3& background);

 private:
  /// a x + b y + c, at least 0 inside, y from the top of the square.
  struct Line {
    double a;
    double b;
    double c;
  };
  struct Surface {
    const AntialiasTriangle* triangle;
    size_t firstLine;  ///< of those of its edges that cross the square
    size_t lastLine;   ///< beyond
  };
  struct Covered {
    const AntialiasTriangle* triangle;
    double left;
    double right;
    double inverseZAtLeft;  ///< where x is 0
    double inverseZSlope;
  };

  void findStrips(double width, double height);
  void splitAlong(double y, const ImageBox& square);

  std::vector<Line> lines_;
  std::vector<Surface> surfaces_;
  std::vector<double> strips_;
  std::vector<Covered> covered_;
  std::vector<double> ends_;
  bool surfacesCross_ = false;
};

}  // namespace ocelli
