#include "oc_core/depth_rays/sample_pyramid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr float kFar = std::numeric_limits<float>::max();
/// More than the three roundings of an entry into a box make of it.
constexpr float kRounding = 1e-6f;
/// What boxes are grown by, of the largest coordinate.
constexpr float kMarginShare = 2.5e-7f;
/// Of the extent of a block: where a gap is wider, its two sides get nodes of their own.
constexpr float kGapShare = 0.15f;

/// 1 / step, finite also where the ray runs along an axis: boxes are grown by more than it then moves across.
glm::vec3 inverseOf(const glm::vec3& step) {
  const float largest = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
  constexpr float kAlong = 1e-20f;
  glm::vec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const float least = std::max(kAlong * largest, 1e-30f);
    const float size = std::max(std::abs(step[axis]), least);
    inverse[axis] = std::copysign(1 / size, step[axis]);
  }
  return inverse;
}

}  // namespace

SamplePyramid::SamplePyramid(const SampleCells& cells) : cells_(cells), bounds_(boundsOf(cells.mesh)) {
  OC_CHECK(cells.cellCount() < kCellBit, "a pyramid of 2^31 pixels or more");
  const glm::vec3 largest = bounds_.empty() ? glm::vec3(0) : glm::max(glm::abs(bounds_.lower), glm::abs(bounds_.upper));
  const float margin = kMarginShare * std::max({largest.x, largest.y, largest.z});
  Children blocks;
  for (const SampleGrid& grid : cells.grids) {
    const Children ofPixel = cellsOf(grid, margin);
    Children block;
    for (int y = 0; y < grid.height; y += kSide) {
      for (int x = 0; x < grid.width; x += kSide) {
        block.clear();
        for (int v = y; v < std::min(y + kSide, grid.height); ++v) {
          for (int u = x; u < std::min(x + kSide, grid.width); ++u) {
            const Child& cell =
                ofPixel[static_cast<size_t>(v) * static_cast<size_t>(grid.width) + static_cast<size_t>(u)];
            if (!cell.box.empty()) {
              block.push_back(cell);
            }
          }
        }
        filledCells_ += block.size();
        addBlock(block, blocks);
      }
    }
  }
  if (!blocks.empty()) {
    root_ = treeOver(blocks);
  }
}

SamplePyramid::Children SamplePyramid::cellsOf(const SampleGrid& grid, float margin) const {
  Children children(static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height));
  constexpr size_t kGrain = 4096;
  parallelFor(children.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t cell = grid.firstPixel + i;
      Child& child = children[i];
      child.reference = static_cast<uint32_t>(cell) | kCellBit;
      for (uint32_t t = cells_.firstTriangle[cell]; t < cells_.firstTriangle[cell + 1]; ++t) {
        const glm::uvec3& triangle = cells_.mesh.triangles[t];
        for (int corner = 0; corner < 3; ++corner) {
          child.box.add(cells_.mesh.positions[triangle[corner]]);
        }
      }
      if (!child.box.empty()) {
        child.box.lower -= margin;
        child.box.upper += margin;
      }
    }
  });
  return children;
}

void SamplePyramid::addBlock(std::span<Child> cells, Children& blocks) {
  if (cells.empty()) {
    return;
  }
  // The widest gap that a plane across an axis finds between them.
  float widest = 0;
  int axisOfGap = 0;
  size_t afterGap = 0;
  glm::vec3 extent(0);
  const auto sortAlong = [&](int axis) {
    std::sort(cells.begin(), cells.end(), [axis](const Child& a, const Child& b) {
      return std::pair(a.box.lower[axis], a.reference) < std::pair(b.box.lower[axis], b.reference);
    });
  };
  for (int axis = 0; axis < 3 && cells.size() > 1; ++axis) {
    sortAlong(axis);
    float reached = cells[0].box.upper[axis];
    for (size_t i = 1; i < cells.size(); ++i) {
      if (const float gap = cells[i].box.lower[axis] - reached; gap > widest) {
        widest = gap;
        axisOfGap = axis;
        afterGap = i;
      }
      reached = std::max(reached, cells[i].box.upper[axis]);
    }
    extent[axis] = reached - cells[0].box.lower[axis];
  }
  if (widest > kGapShare * std::max({extent.x, extent.y, extent.z})) {
    sortAlong(axisOfGap);
    addBlock(cells.first(afterGap), blocks);
    addBlock(cells.subspan(afterGap), blocks);
    return;
  }
  blocks.push_back(nodeOf(cells));
}

SamplePyramid::Child SamplePyramid::treeOver(std::span<Child> children) {
  if (children.size() <= kChildren) {
    return nodeOf(children);
  }
  std::vector<std::span<Child>> parts{children};
  while (parts.size() < kChildren) {
    std::vector<std::span<Child>> halves;
    for (const std::span<Child>& part : parts) {
      Box middles;
      for (const Child& child : part) {
        middles.add(child.box.center());
      }
      const glm::vec3 size = middles.size();
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const size_t half = part.size() / 2;
      const auto middle = part.begin() + static_cast<std::ptrdiff_t>(half);
      std::nth_element(part.begin(), middle, part.end(), [axis](const Child& a, const Child& b) {
        return std::pair(a.box.center()[axis], a.reference) < std::pair(b.box.center()[axis], b.reference);
      });
      halves.push_back(part.first(half));
      halves.push_back(part.subspan(half));
    }
    parts = std::move(halves);
  }
  Children nodes;
  for (const std::span<Child>& part : parts) {
    nodes.push_back(treeOver(part));
  }
  return nodeOf(nodes);
}

/// A child alone needs no node above it.
SamplePyramid::Child SamplePyramid::nodeOf(std::span<const Child> children) {
  const size_t count = children.size();
  if (count == 1) {
    return children[0];
  }
  Child whole{{}, static_cast<uint32_t>(nodes_.size())};
  Node& node = nodes_.emplace_back();
  node.count = static_cast<uint32_t>(count);
  for (size_t i = 0; i < kChildren; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      node.lower[static_cast<size_t>(axis)][i] = i < count ? children[i].box.lower[axis] : kFar;
      node.upper[static_cast<size_t>(axis)][i] = i < count ? children[i].box.upper[axis] : kFar;
    }
    node.child[i] = i < count ? children[i].reference : 0;
    if (i < count) {
      whole.box.add(children[i].box.lower);
      whole.box.add(children[i].box.upper);
    }
  }
  return whole;
}

size_t SamplePyramid::depth() const {
  std::vector<size_t> depths(nodes_.size());
  size_t deepest = 0;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    for (size_t k = 0; k < nodes_[i].count; ++k) {
      const uint32_t child = nodes_[i].child[k];
      OC_CHECK((child & kCellBit) != 0 || child < i, "nodes stand behind those below them");
      depths[i] = std::max(depths[i], (child & kCellBit) != 0 ? 0 : depths[child]);
    }
    deepest = std::max(deepest, ++depths[i]);
  }
  return deepest;
}

std::optional<TriangleMeeting> SamplePyramid::meet(const StraightRay& ray, RayCost& cost) const {
  if (root_.box.empty()) {
    return std::nullopt;
  }
  WaitingList waiting;
  waiting[0] = {0, root_.reference};
  return goOn(ray, waiting, 1, cost);
}

std::optional<TriangleMeeting> SamplePyramid::goOn(const StraightRay& ray, WaitingList& waiting, size_t count,
                                                   RayCost& cost) const {
  const glm::vec3 inverse = inverseOf(ray.step);
  std::optional<TriangleMeeting> best;
  float reach = ray.reach * (1 + kRounding);
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.entry > reach) {
      continue;
    }
    if ((next.reference & kCellBit) != 0) {
      const uint32_t cell = next.reference & ~kCellBit;
      ++cost.cells;
      for (uint32_t t = cells_.firstTriangle[cell]; t < cells_.firstTriangle[cell + 1]; ++t) {
        const glm::uvec3& triangle = cells_.mesh.triangles[t];
        const std::vector<glm::vec3>& positions = cells_.mesh.positions;
        const auto meeting = meetTriangle(ray, positions[triangle.x], positions[triangle.y], positions[triangle.z], t);
        ++cost.triangles;
        if (meeting && (!best || meeting->comesBefore(*best))) {
          best = meeting;
          reach = static_cast<float>(meeting->share) * (1 + kRounding);
        }
      }
      continue;
    }
    const Node& node = nodes_[next.reference];
    ++cost.nodes;
    cost.boxes += node.count;
    std::array<float, kChildren> enter;
    std::array<float, kChildren> leave;
    enter.fill(0);
    leave.fill(reach);
    for (size_t axis = 0; axis < 3; ++axis) {
      const float origin = ray.origin[static_cast<int>(axis)];
      const float perStep = inverse[static_cast<int>(axis)];
      for (size_t i = 0; i < kChildren; ++i) {
        const float a = (node.lower[axis][i] - origin) * perStep;
        const float b = (node.upper[axis][i] - origin) * perStep;
        enter[i] = std::max(enter[i], std::min(a, b));
        leave[i] = std::min(leave[i], std::max(a, b));
      }
    }
    // The farthest child first, so that the nearest is the next one.
    const size_t first = count;
    for (size_t i = 0; i < node.count; ++i) {
      if (enter[i] * (1 - kRounding) > leave[i] * (1 + kRounding)) {
        continue;
      }
      size_t at = count++;
      for (; at > first && waiting[at - 1].entry < enter[i]; --at) {
        waiting[at] = waiting[at - 1];
      }
      waiting[at] = {enter[i] * (1 - kRounding), node.child[i]};
    }
  }
  return best;
}

std::optional<TriangleMeeting> meetEveryCell(const SampleCells& cells, const StraightRay& ray) {
  std::optional<TriangleMeeting> best;
  const std::vector<glm::vec3>& positions = cells.mesh.positions;
  for (uint32_t t = 0; t < cells.mesh.triangles.size(); ++t) {
    const glm::uvec3& triangle = cells.mesh.triangles[t];
    const auto meeting = meetTriangle(ray, positions[triangle.x], positions[triangle.y], positions[triangle.z], t);
    if (meeting && (!best || meeting->comesBefore(*best))) {
      best = meeting;
    }
  }
  return best;
}

}  // namespace ocelli
