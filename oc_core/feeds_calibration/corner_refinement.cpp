#include "oc_core/feeds_calibration/corner_refinement.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace ocelli {
namespace {

constexpr int kMaxRefineSteps = 20;
constexpr double kRefinedEnough = 1e-3;  ///< pixels
constexpr double kEdgeStep = 0.5;        ///< pixels between places that are looked at

/// Bilinear; the caller has checked that it lies within.
double levelAt(const Image<float>& gray, const glm::dvec2& p) {
  const auto x = static_cast<int>(std::floor(p.x));
  const auto y = static_cast<int>(std::floor(p.y));
  const double fx = p.x - x;
  const double fy = p.y - y;
  const double above = static_cast<double>(gray(x, y)) * (1 - fx) + static_cast<double>(gray(x + 1, y)) * fx;
  const double below = static_cast<double>(gray(x, y + 1)) * (1 - fx) + static_cast<double>(gray(x + 1, y + 1)) * fx;
  return above * (1 - fy) + below * fy;
}

bool isUsable(const Image<float>& gray, const CornerCross& cross) {
  // Corners in one line tell no directions.
  if (!std::isfinite(cross.alongRows.x + cross.alongRows.y + cross.alongColumns.x + cross.alongColumns.y)) {
    return false;
  }
  const double margin = cross.reach + 2 * cross.halfWidth + 3;
  return cross.corner.x > margin && cross.corner.y > margin && cross.corner.x < gray.width() - 1 - margin &&
         cross.corner.y < gray.height() - 1 - margin;
}

/// One step from `q`; nothing where the edges do not say where it is.
bool stepCorner(const Image<float>& gray, const CornerCross& cross, glm::dvec2& q) {
  glm::dmat2 sum(0);
  glm::dvec2 right(0);
  for (const glm::dvec2& edge : {cross.alongRows, cross.alongColumns}) {
    const glm::dvec2 across(-edge.y, edge.x);
    // As many places on either side, so that nothing pulls to one.
    const int alongs = static_cast<int>(cross.reach / kEdgeStep);
    const int besides = static_cast<int>(cross.halfWidth / kEdgeStep);
    for (int i = -alongs; i <= alongs; ++i) {
      const double along = i * kEdgeStep;
      // Lenses bend long edges: what is near counts for more.
      const double weight = std::exp(-2 * along * along / (cross.reach * cross.reach));
      for (int j = -besides; j <= besides; ++j) {
        const double beside = j * kEdgeStep;
        const glm::dvec2 p = q + edge * along + across * beside;
        const glm::dvec2 gradient(levelAt(gray, p + glm::dvec2(1, 0)) - levelAt(gray, p - glm::dvec2(1, 0)),
                                  levelAt(gray, p + glm::dvec2(0, 1)) - levelAt(gray, p - glm::dvec2(0, 1)));
        const glm::dmat2 outer = glm::outerProduct(gradient, gradient) * weight;
        sum += outer;
        right += outer * p;
      }
    }
  }
  if (!(std::abs(glm::determinant(sum)) > 1e-9)) {
    return false;
  }
  q = glm::inverse(sum) * right;
  return true;
}

}  // namespace

glm::dvec2 refinedCorner(const Image<float>& gray, const CornerCross& cross) {
  if (!isUsable(gray, cross)) {
    return cross.corner;
  }
  glm::dvec2 q = cross.corner;
  for (int step = 0; step < kMaxRefineSteps; ++step) {
    const glm::dvec2 before = q;
    if (!stepCorner(gray, cross, q) || !(glm::distance(q, cross.corner) <= cross.halfWidth)) {
      return cross.corner;
    }
    if (glm::distance(q, before) < kRefinedEnough) {
      break;
    }
  }
  return q;
}

}  // namespace ocelli
