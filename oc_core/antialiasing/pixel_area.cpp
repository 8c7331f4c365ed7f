#include "oc_core/antialiasing/pixel_area.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Strips lower than this share of a pixel are left out.
constexpr double kLowest = 1e-7;
/// Where surfaces cross each other in the pixel, which is no edge of either, strips are at least so narrow.
constexpr int kStripsOfCrossings = 16;

}  // namespace

void PixelArea::findStrips(double width, double height) {
  strips_.assign({0, height});
  const auto add = [&](double y) {
    if (y > 0 && y < height) {
      strips_.push_back(y);
    }
  };
  for (size_t i = 0; i < lines_.size(); ++i) {
    const Line& p = lines_[i];
    if (p.a != 0 && p.b != 0) {  // where it enters and leaves the square
      add(-p.c / p.b);
      add(-(p.c + p.a * width) / p.b);
    } else if (p.a == 0) {
      add(-p.c / p.b);
    }
    for (size_t k = i + 1; k < lines_.size(); ++k) {
      const Line& q = lines_[k];
      const double determinant = p.a * q.b - q.a * p.b;
      if (determinant != 0) {
        const double x = (p.b * q.c - q.b * p.c) / determinant;
        if (x >= 0 && x <= width) {
          add((q.a * p.c - p.a * q.c) / determinant);
        }
      }
    }
  }
  std::sort(strips_.begin(), strips_.end());
}

void PixelArea::splitAlong(double y, const ImageBox& square) {
  const double width = static_cast<double>(square.upper.x - square.lower.x);
  covered_.clear();
  ends_.assign({0, width});
  for (const Surface& surface : surfaces_) {
    double left = 0;
    double right = width;
    for (size_t i = surface.firstLine; i < surface.lastLine; ++i) {
      const Line& line = lines_[i];
      const double rest = line.b * y + line.c;
      if (line.a > 0) {
        left = std::max(left, -rest / line.a);
      } else if (line.a < 0) {
        right = std::min(right, -rest / line.a);
      } else if (rest < 0) {
        right = -1;
      }
    }
    if (left < right) {
      const BlockPlane& z = surface.triangle->inverseZ;
      const double atLeft = static_cast<double>(z.a) * static_cast<double>(square.lower.x) +
                            static_cast<double>(z.b) * (static_cast<double>(square.lower.y) + y) +
                            static_cast<double>(z.c);
      covered_.push_back({surface.triangle, left, right, atLeft, static_cast<double>(z.a)});
      ends_.push_back(left);
      ends_.push_back(right);
    }
  }
  std::sort(ends_.begin(), ends_.end());
}

glm::vec3 PixelArea::mean(std::span<const AntialiasTriangle* const> triangles, const ImageBox& square, const Mesh& mesh,
                          const glm::vec3& background) {
  OC_CHECK(triangles.size() <= kMaxTriangles, "too many triangles for areas");
  const double width = static_cast<double>(square.upper.x - square.lower.x);
  const double height = static_cast<double>(square.upper.y - square.lower.y);
  lines_.clear();
  surfaces_.clear();
  surfacesCross_ = false;
  for (const AntialiasTriangle* t : triangles) {
    Surface surface{t, lines_.size(), lines_.size()};
    bool meets = true;
    for (const BlockPlane& edge : t->edges) {
      meets = meets && edge.greatest(square) > 0;
      if (edge.least(square) < 0) {
        const double a = static_cast<double>(edge.a);
        const double b = static_cast<double>(edge.b);
        lines_.push_back({a, b,
                          static_cast<double>(edge.c) + a * static_cast<double>(square.lower.x) +
                              b * static_cast<double>(square.lower.y)});
      }
    }
    surface.lastLine = lines_.size();
    if (meets) {
      surfaces_.push_back(surface);
    } else {
      lines_.resize(surface.firstLine);
    }
  }
  findStrips(width, height);

  const auto winnerAt = [&](double x) -> const Covered* {
    const Covered* best = nullptr;
    for (const Covered& each : covered_) {
      if (x >= each.left && x < each.right &&
          (best == nullptr ||
           each.inverseZAtLeft + each.inverseZSlope * x > best->inverseZAtLeft + best->inverseZSlope * x)) {
        best = &each;
      }
    }
    return best;
  };
  glm::dvec3 sum(0);
  const auto show = [&](const Covered* seen, double left, double right, double y, double stripHeight) {
    const double x = (left + right) / 2;
    const glm::vec3 color = seen != nullptr ? seen->triangle->colorAt(square.lower.x + static_cast<float>(x),
                                                                      square.lower.y + static_cast<float>(y), mesh)
                                            : background;
    sum += glm::dvec3(color) * ((right - left) * stripHeight);
  };
  const auto sumStrip = [&](double top, double bottom) {
    const double y = (top + bottom) / 2;
    splitAlong(y, square);
    for (size_t i = 1; i < ends_.size(); ++i) {
      const double left = ends_[i - 1];
      const double right = ends_[i];
      if (!(right > left)) {
        continue;
      }
      const Covered* atLeft = winnerAt(left + (right - left) * 1e-6);
      const Covered* atRight = covered_.size() > 1 ? winnerAt(right - (right - left) * 1e-6) : atLeft;
      double crossing = right;
      if (atLeft != atRight && atLeft != nullptr && atRight != nullptr) {
        surfacesCross_ = true;
        const double slopes = atRight->inverseZSlope - atLeft->inverseZSlope;
        crossing = slopes != 0 ? std::clamp((atLeft->inverseZAtLeft - atRight->inverseZAtLeft) / slopes, left, right)
                               : (left + right) / 2;
        show(atRight, crossing, right, y, bottom - top);
      }
      show(atLeft, left, crossing, y, bottom - top);
    }
  };
  const auto sumStrips = [&] {
    sum = glm::dvec3(0);
    double top = 0;
    for (size_t i = 1; i < strips_.size(); ++i) {
      const double bottom = i + 1 == strips_.size() ? height : strips_[i];
      if (bottom - top >= kLowest * height) {
        sumStrip(top, bottom);
        top = bottom;
      }
    }
  };
  sumStrips();
  if (surfacesCross_) {
    // DEVIATION: where surfaces pass through each other is no line that strips end at; narrow strips come near to it.
    for (int i = 1; i < kStripsOfCrossings; ++i) {
      strips_.push_back(height * i / kStripsOfCrossings);
    }
    std::sort(strips_.begin(), strips_.end());
    sumStrips();
  }
  return glm::vec3(sum / (width * height));
}

}  // namespace ocelli
