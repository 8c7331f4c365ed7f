// The only file that knows Recast.
#include <Recast.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/walkable/walk_columns.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {
namespace {

struct FreeHeightfield {
  void operator()(rcHeightfield* field) const { rcFreeHeightField(field); }
};

[[noreturn]] void failForMemory() {
  throw WorkError("memory is missing for the height field of the scene", "walkable floor",
                  "give a larger cell size of the height field (--cell-size)");
}

/// RC_WALKABLE_AREA for triangles on which one can stand.
std::vector<unsigned char> floorMarks(const Mesh& mesh, const WalkRaster& raster) {
  const auto least = static_cast<float>(std::cos(radiansFromDegrees(raster.slopeDegrees)));
  std::vector<unsigned char> marks(mesh.triangles.size(), RC_NULL_AREA);
  for (size_t i = 0; i < marks.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::vec3& a = mesh.positions[t.x];
    const glm::dvec3 normal = glm::cross(glm::dvec3(mesh.positions[t.y] - a), glm::dvec3(mesh.positions[t.z] - a));
    const double length = glm::length(normal);
    const double up = raster.bothSides ? std::abs(normal.y) : normal.y;
    if (length > 0 && up >= least * length) {
      marks[i] = RC_WALKABLE_AREA;
    }
  }
  return marks;
}

/// Puts the tops of floors where their triangles are in the middles of columns: Recast rounds them up.
void settleFloors(const Mesh& mesh, const std::vector<unsigned char>& marks, WalkColumns& columns) {
  constexpr float kUnsettled = -1e30f;
  std::vector<float> heights(columns.spans.size(), kUnsettled);
  const float tolerance = columns.cellSize * 0.01f;
  for (size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != RC_WALKABLE_AREA) {
      continue;
    }
    const glm::uvec3& t = mesh.triangles[i];
    const std::array<glm::vec3, 3> p{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const auto column = [&](float at, float origin, int count) {
      return std::clamp(static_cast<int>((at - origin) / columns.cellSize), 0, count - 1);
    };
    const int x0 = column(std::min({p[0].x, p[1].x, p[2].x}), columns.origin.x, columns.width);
    const int x1 = column(std::max({p[0].x, p[1].x, p[2].x}), columns.origin.x, columns.width);
    const int z0 = column(std::min({p[0].z, p[1].z, p[2].z}), columns.origin.y, columns.depth);
    const int z1 = column(std::max({p[0].z, p[1].z, p[2].z}), columns.origin.y, columns.depth);
    const glm::dvec2 u(p[1].x - p[0].x, p[1].z - p[0].z);
    const glm::dvec2 v(p[2].x - p[0].x, p[2].z - p[0].z);
    const double area = u.x * v.y - u.y * v.x;
    if (area == 0) {
      continue;
    }
    for (int z = z0; z <= z1; ++z) {
      for (int x = x0; x <= x1; ++x) {
        const glm::dvec2 q(columns.origin.x + (x + 0.5) * columns.cellSize - p[0].x,
                           columns.origin.y + (z + 0.5) * columns.cellSize - p[0].z);
        const double a = (q.x * v.y - q.y * v.x) / area;
        const double b = (u.x * q.y - u.y * q.x) / area;
        if (a < 0 || b < 0 || a + b > 1) {
          continue;
        }
        const auto y = static_cast<float>(p[0].y + a * (p[1].y - p[0].y) + b * (p[2].y - p[0].y));
        const size_t cell = static_cast<size_t>(z) * columns.width + x;
        for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
          const SolidSpan& span = columns.spans[s];
          if (y >= span.lower - tolerance && y <= span.upper + tolerance) {
            heights[s] = std::max(heights[s], y);
          }
        }
      }
    }
  }
  for (size_t s = 0; s < heights.size(); ++s) {
    SolidSpan& span = columns.spans[s];
    if (span.isFloor && heights[s] > span.upper - columns.cellSize && heights[s] != kUnsettled) {
      span.upper = heights[s];
    }
  }
}

}  // namespace

bool canFindWalkable() {
  return true;
}

WalkColumns rasterizedColumns(const Mesh& mesh, const WalkRaster& raster, const Progress& progress) {
  const Box box = boundsOf(mesh);
  WalkColumns columns;
  columns.cellSize = raster.cellSize;
  const float unit = raster.cellSize / 2;
  // A margin, so that what stands at the border is not cut off.
  const glm::vec3 lower = box.lower - glm::vec3(raster.cellSize, unit, raster.cellSize);
  columns.width = static_cast<int>(std::ceil((box.upper.x - lower.x) / raster.cellSize)) + 1;
  columns.depth = static_cast<int>(std::ceil((box.upper.z - lower.z) / raster.cellSize)) + 1;
  columns.origin = {lower.x, lower.z};
  const float upper[3] = {lower.x + static_cast<float>(columns.width) * raster.cellSize, box.upper.y + unit,
                          lower.z + static_cast<float>(columns.depth) * raster.cellSize};

  rcContext context(false);
  const std::unique_ptr<rcHeightfield, FreeHeightfield> field(rcAllocHeightfield());
  if (!field ||
      !rcCreateHeightfield(&context, *field, columns.width, columns.depth, &lower.x, upper, raster.cellSize, unit)) {
    failForMemory();
  }
  const std::vector<unsigned char> marks = floorMarks(mesh, raster);
  constexpr size_t kBatch = 1 << 16;  // triangles between two reports
  for (size_t begin = 0; begin < marks.size(); begin += kBatch) {
    const size_t count = std::min(kBatch, marks.size() - begin);
    // Indices are below 2^31: Mesh is validated, and 2^31 positions do not fit into a file that was read.
    if (!rcRasterizeTriangles(&context, &mesh.positions[0].x, static_cast<int>(mesh.positions.size()),
                              reinterpret_cast<const int*>(&mesh.triangles[begin].x), marks.data() + begin,
                              static_cast<int>(count), *field, 1)) {
      failForMemory();
    }
    report(progress, "rasterise floors", static_cast<double>(begin + count) / static_cast<double>(marks.size()));
  }
  constexpr float kMaxUnits = 1e5f;  // more than any difference of heights, which Recast has in 16 bits
  const auto inUnit = [&](float length) { return static_cast<int>(std::min(length / unit, kMaxUnits)); };
  rcFilterLowHangingWalkableObstacles(&context, inUnit(raster.stepHeight), *field);
  rcFilterWalkableLowHeightSpans(&context, std::max(3, inUnit(raster.agentHeight)), *field);

  const size_t cells = static_cast<size_t>(columns.width) * static_cast<size_t>(columns.depth);
  columns.first.reserve(cells + 1);
  for (size_t i = 0; i < cells; ++i) {
    columns.first.push_back(static_cast<uint32_t>(columns.spans.size()));
    for (const rcSpan* span = field->spans[i]; span != nullptr; span = span->next) {
      columns.spans.push_back({lower.y + static_cast<float>(span->smin) * unit,
                               lower.y + static_cast<float>(span->smax) * unit, span->area == RC_WALKABLE_AREA});
    }
  }
  columns.first.push_back(static_cast<uint32_t>(columns.spans.size()));
  settleFloors(mesh, marks, columns);
  return columns;
}

}  // namespace ocelli
