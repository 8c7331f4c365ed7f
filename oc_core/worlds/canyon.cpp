#include "oc_core/worlds/canyon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

constexpr size_t kPathPoints = 257;
constexpr float kRim = 150;  // of the plateau above the lower end of the river
constexpr float kFall = 14;  // of the river
constexpr float kBottom = -40;
constexpr float kBank = 8;           // width of the flat land on either side of the river
constexpr float kCanyonWidth = 130;  // from the bank to the rim
constexpr size_t kSideRows = 12;
constexpr size_t kMinCells = 8;

float smooth(float t) {
  return t * t * (3 - 2 * t);
}

/// Smooth noise in [-1, 1]: random values at whole coordinates, interpolated.
class ValueNoise {
 public:
  explicit ValueNoise(Random& random) {
    for (float& value : values_) {
      value = random.inRange(-1, 1);
    }
  }
  float at(float x, float z) const {
    const float left = std::floor(x);
    const float top = std::floor(z);
    const auto value = [&](int dx, int dz) {
      const auto wrap = [](int i) { return static_cast<size_t>(i + (1 << 20)) % kSide; };
      return values_[wrap(static_cast<int>(top) + dz) * kSide + wrap(static_cast<int>(left) + dx)];
    };
    const float u = smooth(x - left);
    return glm::mix(glm::mix(value(0, 0), value(1, 0), u), glm::mix(value(0, 1), value(1, 1), u), smooth(z - top));
  }
  /// Several sizes at once.
  float rough(float x, float z) const {
    return (at(x, z) + 0.5f * at(2.1f * x + 7, 2.1f * z + 3) + 0.25f * at(4.3f * x + 1, 4.3f * z + 11)) / 1.75f;
  }

 private:
  static constexpr size_t kSide = 32;
  std::array<float, kSide * kSide> values_{};
};

class Terrain {
 public:
  Terrain(const CanyonOptions& options, const std::vector<glm::vec3>& path)
      : path_(path), random_(options.seed), noise_(random_) {}

  float height(float x, float z) const {
    const float fromRiver = distanceToRiver(x, z);
    const float water = waterHeight(z);
    if (fromRiver < kRiverHalfWidth) {
      return water;
    }
    const float wander = 0.3f * noise_.rough(x / 90, z / 90);
    const float toRim = glm::clamp((fromRiver - kRiverHalfWidth - kBank) / (kCanyonWidth * (1 + wander)), 0.0f, 1.0f);
    const float plateau = kRim + 16 * noise_.rough(x / 160 + 5, z / 160 + 9);
    // Terraces: steep cliffs between ledges.
    constexpr float kTerraces = 4;
    const float step = std::floor(toRim * kTerraces);
    const float within = toRim * kTerraces - step;
    const float terraced = (step + smooth(glm::clamp((within - 0.35f) / 0.6f, 0.0f, 1.0f))) / kTerraces;
    const float bank = 1.5f * smooth(glm::clamp((fromRiver - kRiverHalfWidth) / kBank, 0.0f, 1.0f));
    const float roughness = 3.0f * toRim * noise_.rough(x / 22, z / 22);
    return water + bank + (plateau - water) * glm::mix(terraced, toRim, 0.2f) + roughness;
  }

  /// x of the middle of the river.
  float riverAt(float z) const {
    const size_t i = segmentAt(z);
    return glm::mix(path_[i].x, path_[i + 1].x, pathPlace(z) - static_cast<float>(i));
  }

  glm::vec3 color(const glm::vec3& point, float slope) const {
    const float fromRiver = distanceToRiver(point.x, point.z);
    const glm::vec3 grass = palette::fromSrgbBytes(120, 160, 84);
    if (fromRiver < kRiverHalfWidth + kBank) {
      const glm::vec3 water =
          palette::fromSrgbBytes(64, 150, 190) * (0.9f + 0.1f * noise_.at(point.x / 6, point.z / 14));
      return mix(water, grass, glm::clamp((fromRiver - kRiverHalfWidth) / 2, 0.0f, 1.0f));
    }
    const glm::vec3 flat = mix(palette::fromSrgbBytes(206, 176, 118), grass,
                               glm::clamp(0.5f + noise_.rough(point.x / 60, point.z / 60), 0.0f, 1.0f));
    return mix(flat, rock(point), smooth(glm::clamp((slope - 0.35f) / 0.5f, 0.0f, 1.0f)));
  }

  /// Layers of rock, a little wavy.
  glm::vec3 rock(const glm::vec3& point) const {
    static const std::array<glm::vec3, 6> kLayers{
        palette::fromSrgbBytes(172, 84, 56),  palette::fromSrgbBytes(214, 140, 88),
        palette::fromSrgbBytes(190, 104, 68), palette::fromSrgbBytes(232, 190, 140),
        palette::fromSrgbBytes(158, 74, 54),  palette::fromSrgbBytes(222, 156, 104)};
    const float y = (point.y + 300 + 4 * noise_.at(point.x / 50, point.z / 50)) / 14;
    const auto layer = static_cast<size_t>(y);
    const float within = smooth(glm::clamp((y - std::floor(y) - 0.7f) / 0.3f, 0.0f, 1.0f));
    return mix(kLayers[layer % kLayers.size()], kLayers[(layer + 1) % kLayers.size()], within);
  }

 private:
  static float waterHeight(float z) { return kFall * 0.5f * (1 - z / kCanyonHalfSize); }

  /// The place of z along the path, whose points are evenly spaced in z, counted in points.
  float pathPlace(float z) const { return (1 - z / kCanyonHalfSize) / 2 * static_cast<float>(path_.size() - 1); }

  size_t segmentAt(float z) const {
    return static_cast<size_t>(glm::clamp(pathPlace(z), 0.0f, static_cast<float>(path_.size() - 2)));
  }

  float distanceToRiver(float x, float z) const {
    const glm::vec2 point(x, z);
    float least2 = 1e12f;
    const auto visit = [&](size_t i) {
      const glm::vec2 a(path_[i].x, path_[i].z);
      const glm::vec2 along = glm::vec2(path_[i + 1].x, path_[i + 1].z) - a;
      const float t = glm::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0f, 1.0f);
      const glm::vec2 away = point - a - t * along;
      least2 = std::min(least2, glm::dot(away, away));
    };
    // z falls along the path: from the segment at this z both ways, until z alone is farther than what was found.
    const auto reaches = [&](float segmentZ) { return (segmentZ - z) * (segmentZ - z) < least2; };
    const size_t start = segmentAt(z);
    visit(start);
    for (size_t i = start; i > 0 && reaches(path_[i].z); --i) {
      visit(i - 1);
    }
    for (size_t i = start + 1; i + 1 < path_.size() && reaches(path_[i].z); ++i) {
      visit(i);
    }
    return std::sqrt(least2);
  }

  const std::vector<glm::vec3>& path_;
  Random random_;
  ValueNoise noise_;
};

/// Points of the height field and what lies below its edge.
class CanyonBuilder {
 public:
  CanyonBuilder(const CanyonOptions& options, const std::vector<glm::vec3>& path)
      : terrain_(options, path), cells_(options.cells) {}

  Mesh build() {
    addSurface();
    // Once around, counter-clockwise seen from above.
    std::vector<uint32_t> edge;
    for (size_t i = 0; i < cells_; ++i) {
      edge.push_back(vertex(i, cells_));
    }
    for (size_t i = 0; i < cells_; ++i) {
      edge.push_back(vertex(cells_, cells_ - i));
    }
    for (size_t i = 0; i < cells_; ++i) {
      edge.push_back(vertex(cells_ - i, 0));
    }
    for (size_t i = 0; i < cells_; ++i) {
      edge.push_back(vertex(0, i));
    }
    addSides(edge);
    return std::move(mesh_);
  }

 private:
  uint32_t vertex(size_t column, size_t row) const { return static_cast<uint32_t>(row * (cells_ + 1) + column); }

  /// Rows run straight from west to east, columns along the river and ever less so towards the edges; they lie closer
  /// together where the canyon is.
  glm::vec2 placeOf(size_t column, size_t row) const {
    const float u = 2 * static_cast<float>(column) / static_cast<float>(cells_) - 1;
    const float bent = 0.5f * u + 0.5f * u * u * u;
    const float z = kCanyonHalfSize * (2 * static_cast<float>(row) / static_cast<float>(cells_) - 1);
    return {kCanyonHalfSize * bent + terrain_.riverAt(z) * (1 - bent * bent), z};
  }

  void addSurface() {
    const size_t side = cells_ + 1;
    mesh_.positions.resize(side * side);
    mesh_.colors.resize(side * side);
    parallelFor(side, 1, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (size_t column = 0; column < side; ++column) {
          const glm::vec2 place = placeOf(column, row);
          mesh_.positions[vertex(column, row)] = {place.x, terrain_.height(place.x, place.y), place.y};
        }
      }
    });
    parallelFor(side, 1, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (size_t column = 0; column < side; ++column) {
          mesh_.colors[vertex(column, row)] = terrain_.color(mesh_.positions[vertex(column, row)], slope(column, row));
        }
      }
    });
    for (size_t row = 0; row < cells_; ++row) {
      for (size_t column = 0; column < cells_; ++column) {
        const uint32_t a = vertex(column, row);
        const uint32_t b = vertex(column + 1, row);
        const uint32_t c = vertex(column, row + 1);
        const uint32_t d = vertex(column + 1, row + 1);
        mesh_.triangles.push_back({a, c, d});
        mesh_.triangles.push_back({a, d, b});
      }
    }
  }

  /// Rise over run at a point, from its neighbours.
  float slope(size_t column, size_t row) const {
    const auto at = [&](size_t c, size_t r) {
      return mesh_.positions[vertex(std::min(c, cells_), std::min(r, cells_))];
    };
    const glm::vec3 alongRow = at(column + 1, row) - at(column > 0 ? column - 1 : 0, row);
    const glm::vec3 alongColumn = at(column, row + 1) - at(column, row > 0 ? row - 1 : 0);
    const glm::vec3 normal = glm::cross(alongColumn, alongRow);
    return std::hypot(normal.x, normal.z) / std::max(normal.y, 1e-6f);
  }

  /// Walls of layered rock from the edge down, and a fan that closes the bottom.
  void addSides(const std::vector<uint32_t>& edge) {
    const auto base = static_cast<uint32_t>(mesh_.positions.size());
    const auto count = static_cast<uint32_t>(edge.size());
    for (size_t row = 0; row <= kSideRows; ++row) {
      for (const uint32_t top : edge) {
        glm::vec3 point = mesh_.positions[top];
        if (row > 0) {
          point.y = glm::mix(point.y, kBottom, static_cast<float>(row) / static_cast<float>(kSideRows));
        }
        mesh_.positions.push_back(point);
        mesh_.colors.push_back(terrain_.rock(point));
      }
    }
    mesh_.positions.push_back({0, kBottom, 0});
    mesh_.colors.push_back(palette::slate());
    const auto middle = static_cast<uint32_t>(mesh_.positions.size() - 1);
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t next = (i + 1) % count;
      for (uint32_t row = 0; row < kSideRows; ++row) {
        const uint32_t upper = base + row * count;
        const uint32_t lower = upper + count;
        mesh_.triangles.push_back({upper + i, lower + i, lower + next});
        mesh_.triangles.push_back({upper + i, lower + next, upper + next});
      }
      const uint32_t lowest = base + static_cast<uint32_t>(kSideRows) * count;
      mesh_.triangles.push_back({lowest + next, lowest + i, middle});
    }
  }

  Terrain terrain_;
  size_t cells_;
  Mesh mesh_;
};

}  // namespace

size_t canyonTriangles(size_t cells) {
  return 2 * cells * cells + 4 * cells * (2 * kSideRows + 1);
}

size_t canyonCells(size_t triangles) {
  size_t cells = kMinCells;
  while (canyonTriangles(cells) + canyonTriangles(cells + 1) <= 2 * triangles) {
    ++cells;
  }
  return cells;
}

std::vector<glm::vec3> canyonPath(uint64_t seed) {
  Random random(seed);
  const float turns = random.inRange(1.6f, 2.4f);
  const float wide = random.inRange(95, 140);
  const float narrow = random.inRange(18, 34);
  const float phase = random.inRange(0, static_cast<float>(2 * kPi));
  const float otherPhase = random.inRange(0, static_cast<float>(2 * kPi));
  std::vector<glm::vec3> path;
  for (size_t i = 0; i < kPathPoints; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kPathPoints - 1);
    const auto angle = static_cast<float>(2 * kPi) * t;
    const float x = wide * std::sin(turns * angle + phase) + narrow * std::sin(2.7f * turns * angle + otherPhase);
    path.push_back({x, kFall * t, kCanyonHalfSize * (1 - 2 * t)});
  }
  return path;
}

Mesh makeCanyon(const CanyonOptions& options, const std::vector<glm::vec3>& path) {
  OC_CHECK(options.cells >= kMinCells && path.size() >= 2, "a canyon has a terrain and a river");
  return CanyonBuilder(options, path).build();
}

}  // namespace ocelli
