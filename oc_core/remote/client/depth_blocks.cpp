#include "oc_core/remote/client/depth_blocks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kTile = 16;               ///< samples along a side of the largest block
constexpr float kMaxParallax = 0.06f;   ///< heights of a view: what CoverLimits lets near things move before far ones
constexpr double kMinSpan = 0.02;       ///< of 1/z, by that of near things: a wall has depth, too
constexpr float kMaxError = 0.2f;       ///< pixels
constexpr float kJoinedFootprints = 3;  ///< steps of z between two samples of a surface, as in image_mesh.h
constexpr float kViewLines = 720;
constexpr int kBandLines = 32;
constexpr float kMinW = 1e-6f;  ///< nearer to the view's plane than this, a block is left out

/// Places of the corners of samples in the pinhole, and 1/z of the samples.
struct DepthSource {
  Image<glm::vec2> corner;  ///< one more than samples, each way
  Image<glm::vec2> place;
  Image<float> inverse;  ///< 0 where there is none
};

DepthSource sourceOf(const ReferenceImage& image, const GpcMap& map) {
  DepthSource source{Image<glm::vec2>(image.width() + 1, image.height() + 1),
                     Image<glm::vec2>(image.width(), image.height()), Image<float>(image.width(), image.height())};
  parallelFor(static_cast<size_t>(image.height()) + 1, 16, [&](size_t begin, size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x <= image.width(); ++x) {
        source.corner(x, y) = glm::vec2(map.pinholeFromImage(glm::dvec2(x, y)));
        if (x < image.width() && y < image.height()) {
          source.place(x, y) = glm::vec2(map.pinholeFromImage(glm::dvec2(x + 0.5, y + 0.5)));
          const bool holds = image.holds(x, y) && image.t(x, y) > 0;
          source.inverse(x, y) = holds ? 1 / image.t(x, y) : 0;
        }
      }
    }
  });
  return source;
}

/// 1/z over the pinhole's image: at(p) = middle + gradient (p - center).
struct InversePlane {
  glm::vec2 center{0};
  float middle = 0;
  glm::vec2 gradient{0};

  float at(const glm::vec2& p) const { return middle + glm::dot(gradient, p - center); }
};

struct Rect {
  int x, y, width, height;
};

/// The plane through the samples of a block, by least squares; nothing where one is missing or too far from it. Two
/// rows or columns lie on a plane whatever stands between them: there it must not be steeper than surfaces are that
/// join.
std::optional<InversePlane> planeOf(const DepthSource& source, const Rect& rect, float tolerance, float focal) {
  glm::dvec2 center(0);
  double middle = 0;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      if (source.inverse(x, y) == 0) {
        return std::nullopt;
      }
      center += glm::dvec2(source.place(x, y));
      middle += static_cast<double>(source.inverse(x, y));
    }
  }
  const double count = rect.width * rect.height;
  center /= count;
  middle /= count;
  double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const glm::dvec2 p = glm::dvec2(source.place(x, y)) - center;
      const double w = static_cast<double>(source.inverse(x, y)) - middle;
      uu += p.x * p.x;
      uv += p.x * p.y;
      vv += p.y * p.y;
      uw += p.x * w;
      vw += p.y * w;
    }
  }
  InversePlane plane{glm::vec2(center), static_cast<float>(middle), glm::vec2(0)};
  const double determinant = uu * vv - uv * uv;
  if (determinant > 1e-9) {
    plane.gradient = glm::vec2((uw * vv - vw * uv) / determinant, (vw * uu - uw * uv) / determinant);
  }
  const float steepest = kJoinedFootprints * plane.middle / focal;
  if (std::min(rect.width, rect.height) <= 2 && glm::length(plane.gradient) > steepest) {
    return std::nullopt;
  }
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      if (std::abs(plane.at(source.place(x, y)) - source.inverse(x, y)) > tolerance) {
        return std::nullopt;
      }
    }
  }
  return plane;
}

/// The lesser of two slopes of one sign; 0 for slopes that disagree: an edge on one side.
float commonSlope(float a, float b) {
  return a * b <= 0 ? 0 : std::abs(a) < std::abs(b) ? a : b;
}

/// The plane of a single sample goes on as its neighbours do, where those of both sides say the same.
InversePlane planeOfSample(const DepthSource& source, int x, int y) {
  InversePlane plane{source.place(x, y), source.inverse(x, y), glm::vec2(0)};
  const auto slope = [&](int nx, int ny, int axis) {
    if (!source.inverse.contains(nx, ny) || source.inverse(nx, ny) == 0) {
      return 0.0f;
    }
    return (source.inverse(nx, ny) - plane.middle) / (source.place(nx, ny)[axis] - plane.center[axis]);
  };
  plane.gradient = {commonSlope(slope(x - 1, y, 0), slope(x + 1, y, 0)),
                    commonSlope(slope(x, y - 1, 1), slope(x, y + 1, 1))};
  return plane;
}

/// A block on the screen: pixels, and 1/z of the view.
struct ScreenBlock {
  std::array<glm::vec3, 4> at;
  float top = 0;
  float bottom = -1;
};

void drawTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int firstRow, int endRow,
                  Image<float>& inverse) {
  const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0 || !std::isfinite(area)) {
    return;
  }
  const float left = std::min({a.x, b.x, c.x});
  const float right = std::max({a.x, b.x, c.x});
  const float top = std::min({a.y, b.y, c.y});
  const float bottom = std::max({a.y, b.y, c.y});
  const auto clamped = [](float value, int least, int most) {
    return static_cast<int>(std::clamp(value, static_cast<float>(least), static_cast<float>(most)));
  };
  const int x0 = clamped(std::ceil(left - 0.5f), 0, inverse.width());
  const int x1 = clamped(std::floor(right - 0.5f) + 1, 0, inverse.width());
  const int y0 = clamped(std::ceil(top - 0.5f), firstRow, endRow);
  const int y1 = clamped(std::floor(bottom - 0.5f) + 1, firstRow, endRow);
  if (x0 >= x1 || y0 >= y1) {
    return;
  }
  // Barycentric coordinates grow linearly; edges belong to both of their triangles, where 1/z is the same.
  const float s = 1 / area;
  const auto edge = [s](const glm::vec3& p, const glm::vec3& q) {
    return glm::vec3((p.y - q.y) * s, (q.x - p.x) * s, (p.x * q.y - q.x * p.y) * s);
  };
  const glm::vec3 e0 = edge(b, c);
  const glm::vec3 e1 = edge(c, a);
  const glm::vec3 e2 = edge(a, b);
  const glm::vec3 depth = e0 * a.z + e1 * b.z + e2 * c.z;
  constexpr float kOutside = -1e-4f;
  for (int y = y0; y < y1; ++y) {
    const float v = static_cast<float>(y) + 0.5f;
    // The part of the row that no edge cuts off.
    float first = static_cast<float>(x0) + 0.5f;
    float last = static_cast<float>(x1) - 0.5f;
    for (const glm::vec3* e : {&e0, &e1, &e2}) {
      const float rest = kOutside - e->y * v - e->z;
      if (e->x > 0) {
        first = std::max(first, rest / e->x);
      } else if (e->x < 0) {
        last = std::min(last, rest / e->x);
      } else if (rest > 0) {
        last = -1;
      }
    }
    const int begin = clamped(std::ceil(first - 0.5f), x0, x1);
    const int end = clamped(std::floor(last - 0.5f) + 1, x0, x1);
    float* const row = &inverse(0, y);
    for (int x = begin; x < end; ++x) {
      row[x] = std::max(row[x], depth.x * (static_cast<float>(x) + 0.5f) + depth.y * v + depth.z);
    }
  }
}

}  // namespace

float blockTolerance(double nearZ, double farZ) {
  if (!(nearZ > 0)) {
    return 0;
  }
  // Between far and near things there may be kMaxParallax heights: so much is the span of 1/z.
  const double span = std::max(1 / nearZ - 1 / farZ, kMinSpan / nearZ);
  return static_cast<float>(static_cast<double>(kMaxError / (kMaxParallax * kViewLines)) * span);
}

DepthBlocks::DepthBlocks(const ReferenceImage& image, const GpcMap& map, float tolerance) : eye_(image.view.eye) {
  const PinholeCamera camera = image.reference();
  const DepthSource source = sourceOf(image, map);
  const auto directionOf = [&](const glm::vec2& place) {
    const glm::vec2 d = (place - camera.centerPixels()) / camera.focalPixels();
    return camera.forward() + camera.right() * d.x + camera.down() * d.y;
  };
  const auto rows = static_cast<size_t>((image.height() + kTile - 1) / kTile);
  std::vector<std::vector<Block>> found(rows);
  parallelFor(rows, 1, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const auto add = [&](const Rect& rect, const InversePlane& plane) {
        Block block;
        for (size_t i = 0; i < 4; ++i) {
          const glm::vec2 p =
              source.corner(rect.x + (i % 2 == 1 ? rect.width : 0), rect.y + (i >= 2 ? rect.height : 0));
          // A steep plane must not reach infinity at a corner.
          block.corners[i] = glm::vec4(directionOf(p), std::clamp(plane.at(p), plane.middle / 2, plane.middle * 2));
        }
        found[row].push_back(block);
      };
      const auto split = [&](const auto& self, const Rect& rect) -> void {
        if (rect.width <= 0 || rect.height <= 0) {
          return;
        }
        if (rect.width == 1 && rect.height == 1) {
          if (source.inverse(rect.x, rect.y) > 0) {
            add(rect, planeOfSample(source, rect.x, rect.y));
          }
          return;
        }
        if (const std::optional<InversePlane> plane = planeOf(source, rect, tolerance, camera.focalPixels())) {
          add(rect, *plane);
          return;
        }
        const int w = (rect.width + 1) / 2;
        const int h = (rect.height + 1) / 2;
        self(self, {rect.x, rect.y, w, h});
        self(self, {rect.x + w, rect.y, rect.width - w, h});
        self(self, {rect.x, rect.y + h, w, rect.height - h});
        self(self, {rect.x + w, rect.y + h, rect.width - w, rect.height - h});
      };
      const int y = static_cast<int>(row) * kTile;
      for (int x = 0; x < image.width(); x += kTile) {
        split(split, {x, y, std::min(kTile, image.width() - x), std::min(kTile, image.height() - y)});
      }
    }
  });
  for (const std::vector<Block>& each : found) {
    blocks_.insert(blocks_.end(), each.begin(), each.end());
  }
}

Image<float> DepthBlocks::inverseDepth(const PinholeCamera& view) const {
  Image<float> inverse(view.width(), view.height());
  std::vector<ScreenBlock> onScreen(blocks_.size());
  const glm::vec3 offset = eye_ - view.eye();
  const glm::vec2 center = view.centerPixels();
  const float focal = view.focalPixels();
  parallelFor(blocks_.size(), 1024, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      ScreenBlock block;
      glm::vec2 least(1e9f);
      glm::vec2 most(-1e9f);
      bool isInFront = true;
      for (size_t k = 0; k < 4; ++k) {
        const glm::vec4& corner = blocks_[i].corners[k];
        // The point by its z, divided by that: the projection is the same.
        const glm::vec3 p = glm::vec3(corner) + offset * corner.w;
        const float w = glm::dot(p, view.forward());
        isInFront = isInFront && w > kMinW;
        block.at[k] = {center.x + focal * glm::dot(p, view.right()) / w,
                       center.y + focal * glm::dot(p, view.down()) / w, corner.w / w};
        least = glm::min(least, glm::vec2(block.at[k]));
        most = glm::max(most, glm::vec2(block.at[k]));
      }
      if (isInFront && most.x >= 0 && least.x <= static_cast<float>(view.width())) {
        block.top = least.y;
        block.bottom = most.y;
      }
      onScreen[i] = block;
    }
  });
  const auto bands = static_cast<size_t>((view.height() + kBandLines - 1) / kBandLines);
  std::vector<std::vector<uint32_t>> blocksOfBand(bands);
  for (size_t i = 0; i < onScreen.size(); ++i) {
    const ScreenBlock& block = onScreen[i];
    if (block.bottom < 0 || block.top > static_cast<float>(view.height()) || block.bottom < block.top) {
      continue;
    }
    const auto first = static_cast<size_t>(std::max(block.top, 0.0f)) / kBandLines;
    const size_t last = std::min(bands - 1, static_cast<size_t>(std::min(block.bottom, 1e6f)) / kBandLines);
    for (size_t band = first; band <= last; ++band) {
      blocksOfBand[band].push_back(static_cast<uint32_t>(i));
    }
  }
  parallelFor(bands, 1, [&](size_t begin, size_t end) {
    for (size_t band = begin; band < end; ++band) {
      const int firstRow = static_cast<int>(band) * kBandLines;
      const int endRow = std::min(firstRow + kBandLines, view.height());
      for (const uint32_t i : blocksOfBand[band]) {
        const std::array<glm::vec3, 4>& at = onScreen[i].at;
        drawTriangle(at[0], at[1], at[3], firstRow, endRow, inverse);
        drawTriangle(at[0], at[3], at[2], firstRow, endRow, inverse);
      }
    }
  });
  return inverse;
}

}  // namespace ocelli
