#include "oc_core/pack/scene_parts.h"

#include <algorithm>
#include <glm/common.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr uint32_t kDepth = 7;
static_assert(1u << kDepth == ScenePlan::kCellsPerAxis);
constexpr uint32_t kCells = 1u << (3 * kDepth);

uint32_t mortonOf(const glm::uvec3& cell) {
  uint32_t code = 0;
  for (uint32_t bit = 0; bit < kDepth; ++bit) {
    code |= ((cell.x >> bit & 1U) | (cell.y >> bit & 1U) << 1U | (cell.z >> bit & 1U) << 2U) << (3 * bit);
  }
  return code;
}

/// Cuts ranges of cells into parts.
class Planner {
 public:
  Planner(const std::vector<uint32_t>& counts, ScenePlan& plan) : counts_(counts), plan_(plan) {}

  /// The part of cells [begin, end), which are those of a node of the octree.
  uint32_t add(uint32_t begin, uint32_t end) {
    const uint64_t triangles = countOf(begin, end);
    if (triangles <= ScenePlan::kPartTriangles || end - begin == 1) {
      return addPart({begin, end, triangles, 0, {}});
    }
    ScenePart part{begin, end, triangles, 0, {}};
    const uint32_t step = (end - begin) / 8;
    for (uint32_t child = begin; child < end;) {
      // Neighbours that are small together are one part.
      uint32_t childEnd = child + step;
      uint64_t together = countOf(child, childEnd);
      while (childEnd < end && together + countOf(childEnd, childEnd + step) <= ScenePlan::kPartTriangles) {
        together += countOf(childEnd, childEnd + step);
        childEnd += step;
      }
      if (together > 0) {
        part.children.push_back(childEnd - child == step ? add(child, childEnd)
                                                         : addPart({child, childEnd, together, 0, {}}));
      }
      child = childEnd;
    }
    return addPart(std::move(part));
  }

 private:
  uint64_t countOf(uint32_t begin, uint32_t end) const {
    uint64_t count = 0;
    for (uint32_t cell = begin; cell < end; ++cell) {
      count += counts_[cell];
    }
    return count;
  }
  uint32_t addPart(ScenePart part) {
    const auto index = static_cast<uint32_t>(plan_.parts.size());
    if (part.children.empty()) {
      part.firstTriangle = placed_;
      placed_ += part.triangles;
      std::fill(plan_.partOfCell.begin() + part.firstCell, plan_.partOfCell.begin() + part.endCell, index);
    }
    plan_.parts.push_back(std::move(part));
    return index;
  }

  const std::vector<uint32_t>& counts_;
  ScenePlan& plan_;
  uint64_t placed_ = 0;
};

}  // namespace

glm::uvec3 ScenePlan::cellAt(const glm::dvec3& point) const {
  const glm::dvec3 extent(box.size());
  const double side = std::max({extent.x, extent.y, extent.z, 1e-30});
  const glm::dvec3 cell = (point - glm::dvec3(box.lower)) * (kCellsPerAxis / side);
  return glm::uvec3(glm::clamp(cell, 0.0, kCellsPerAxis - 1.0));
}

uint32_t ScenePlan::cellOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
  return mortonOf(cellAt((glm::dvec3(glm::min(a, glm::min(b, c))) + glm::dvec3(glm::max(a, glm::max(b, c)))) * 0.5));
}

bool ScenePlan::isWithinOneCell(const std::array<glm::vec3, 3>& corners) const {
  const auto& [a, b, c] = corners;
  return cellAt(glm::dvec3(glm::min(a, glm::min(b, c)))) == cellAt(glm::dvec3(glm::max(a, glm::max(b, c))));
}

ScenePlan planOf(const TriangleSource& source, const std::string& where) {
  ScenePlan plan;
  source.forEachPart([&](const Mesh& part) {
    for (const glm::vec3& p : part.positions) {
      plan.box.add(p);
    }
    plan.triangles += part.triangles.size();
  });
  if (plan.triangles == 0) {
    throw InputError("there is no triangle in this scene", where, "give a scene with surfaces");
  }
  std::vector<uint32_t> counts(kCells, 0);
  source.forEachPart([&](const Mesh& part) {
    for (const glm::uvec3& t : part.triangles) {
      ++counts[plan.cellOf(part.positions[t.x], part.positions[t.y], part.positions[t.z])];
    }
  });
  plan.partOfCell.resize(kCells);
  Planner(counts, plan).add(0, kCells);
  return plan;
}

}  // namespace ocelli
