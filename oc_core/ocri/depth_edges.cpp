#include "oc_core/ocri/depth_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The 1/z, or z, of four samples in a row; is there a discontinuity between the second and the third?
bool isDiscontinuity(float before, float first, float second, float after, float minStep) {
  const float step = first - second;
  const float slopeBefore = before - first;
  const float slopeAfter = second - after;
  return std::abs(step - slopeBefore) > minStep && std::abs(step - slopeAfter) > minStep && std::abs(step) > minStep;
}

/// Fits a line to the edges around `edge` whose occluder has about its depth; returns the line's normal, turned to
/// the side of `edge.normal`. Weights fall off linearly to the rim.
glm::vec2 fittedNormal(const DepthEdge& edge, const std::vector<DepthEdge>& edges, const Image<int>& firstOfPixel,
                       float radius) {
  const float depthTolerance = 0.5f * (edge.inverseNear - edge.inverseFar);
  const int reach = static_cast<int>(std::ceil(radius));
  const int cx = static_cast<int>(edge.position.x);
  const int cy = static_cast<int>(edge.position.y);
  float weightSum = 0;
  glm::vec2 mean(0);
  glm::vec2 side(0);
  float xx = 0;
  float xy = 0;
  float yy = 0;
  for (int y = cy - reach; y <= cy + reach; ++y) {
    for (int x = cx - reach; x <= cx + reach; ++x) {
      if (!firstOfPixel.contains(x, y) || firstOfPixel(x, y) < 0) {
        continue;
      }
      for (auto i = static_cast<size_t>(firstOfPixel(x, y)); i < edges.size(); ++i) {
        const DepthEdge& other = edges[i];
        if (static_cast<int>(other.position.x) != x || static_cast<int>(other.position.y) != y) {
          break;
        }
        const glm::vec2 offset = other.position - edge.position;
        const float weight = 1 - glm::length(offset) / radius;
        if (weight <= 0 || std::abs(other.inverseNear - edge.inverseNear) > depthTolerance) {
          continue;
        }
        weightSum += weight;
        mean += offset * weight;
        side += other.normal * weight;
        xx += weight * offset.x * offset.x;
        xy += weight * offset.x * offset.y;
        yy += weight * offset.y * offset.y;
      }
    }
  }
  if (weightSum <= 0) {
    return edge.normal;
  }
  mean /= weightSum;
  xx = xx / weightSum - mean.x * mean.x;
  xy = xy / weightSum - mean.x * mean.y;
  yy = yy / weightSum - mean.y * mean.y;
  if (xx + yy < 1e-3f) {
    return edge.normal;
  }
  // The normal is the direction of least variance of the 2x2 covariance.
  const float angle = 0.5f * std::atan2(2 * xy, xx - yy);
  const glm::vec2 normal(-std::sin(angle), std::cos(angle));
  return glm::dot(normal, side) < 0 ? -normal : normal;
}

}  // namespace

std::vector<DepthEdge> findDepthEdges(const Image<float>& inverseZ, const DepthEdgeOptions& options) {
  const int width = inverseZ.width();
  const int height = inverseZ.height();
  const auto at = [&](int x, int y) {
    const float w = inverseZ(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    return w > 0 ? w : options.backgroundInverseZ;
  };
  const bool onZ = options.minZStep > 0;
  const float minStep = onZ ? options.minZStep : options.minInverseZStep;
  const auto measured = [&](int x, int y) {
    const float w = at(x, y);
    return !onZ ? w : w > 0 ? 1 / w : std::numeric_limits<float>::max();
  };
  const auto addIfEdge = [&](int x, int y, int dx, int dy, std::vector<DepthEdge>& edges) {
    const float first = at(x, y);
    const float second = at(x + dx, y + dy);
    if (first == second || (!onZ && !(std::abs(first - second) > minStep))) {
      return;  // nearly all
    }
    if (isDiscontinuity(measured(x - dx, y - dy), measured(x, y), measured(x + dx, y + dy),
                        measured(x + 2 * dx, y + 2 * dy), minStep)) {
      const glm::vec2 along(static_cast<float>(dx), static_cast<float>(dy));
      const glm::vec2 position = glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) + along * 0.5f;
      edges.push_back(first > second ? DepthEdge{position, along, first, second}
                                     : DepthEdge{position, -along, second, first});
    }
  };
  std::vector<std::vector<DepthEdge>> edgesOfRow(static_cast<size_t>(height));
  parallelFor(edgesOfRow.size(), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        if (x + 1 < width) {
          addIfEdge(x, y, 1, 0, edgesOfRow[row]);
        }
        if (y + 1 < height) {
          addIfEdge(x, y, 0, 1, edgesOfRow[row]);
        }
      }
    }
  });
  std::vector<DepthEdge> edges;
  for (const std::vector<DepthEdge>& row : edgesOfRow) {
    edges.insert(edges.end(), row.begin(), row.end());
  }

  // Edges of one pixel must stand together for the neighbourhood search.
  const auto pixelOf = [](const DepthEdge& e) {
    return std::pair(static_cast<int>(e.position.y), static_cast<int>(e.position.x));
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const DepthEdge& a, const DepthEdge& b) { return pixelOf(a) < pixelOf(b); });
  Image<int> firstOfPixel(width, height, -1);
  for (size_t i = edges.size(); i-- > 0;) {
    firstOfPixel(static_cast<int>(edges[i].position.x), static_cast<int>(edges[i].position.y)) = static_cast<int>(i);
  }
  std::vector<glm::vec2> normals(edges.size());
  parallelFor(edges.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      normals[i] = fittedNormal(edges[i], edges, firstOfPixel, options.lineFitRadiusPixels);
    }
  });
  for (size_t i = 0; i < edges.size(); ++i) {
    edges[i].normal = normals[i];
  }
  return edges;
}

}  // namespace ocelli
