// Blocks of rays through the pyramid: each node is opened once for all of them, with intervals of their directions in
// the place of one, and each cell is tested with the rays of the pixels that it covers.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "oc_core/depth_rays/sample_pyramid.h"

namespace ocelli {
namespace {

constexpr float kBlockRounding = 2e-6f;
/// As in sample_pyramid.cpp.
constexpr size_t kMaxBlockWaiting = 16 * 16;

/// What the steps of a block are along one axis: 1 over the ends of their interval.
struct AxisSteps {
  float inverseLow = 0;
  float inverseHigh = 0;
  bool bothSigns = false;
};

AxisSteps axisSteps(const RayBlock& block, int axis) {
  const auto right = static_cast<float>(block.columns - 1);
  const auto down = static_cast<float>(block.rows - 1);
  const float corner = block.first[axis];
  const float across = block.perColumn[axis] * right;
  const float along = block.perRow[axis] * down;
  const float margin = kBlockRounding * (std::abs(corner) + std::abs(across) + std::abs(along)) + 1e-30f;
  const float low = corner + std::min(across, 0.0f) + std::min(along, 0.0f) - margin;
  const float high = corner + std::max(across, 0.0f) + std::max(along, 0.0f) + margin;
  return {1 / low, 1 / high, low <= 0 && high >= 0};
}

/// Where points lie among the columns and rows of a block.
class BlockPixels {
 public:
  explicit BlockPixels(const RayBlock& block)
      : block_(block), columnsOf_(glm::inverse(glm::dmat3(block.perColumn, block.perRow, block.first))) {}

  struct Range {
    int firstColumn = 0;
    int lastColumn = 0;
    int firstRow = 0;
    int lastRow = 0;
  };
  /// The rays that may meet the triangle; the last ones lie before the first ones where there is none.
  Range around(const glm::vec3& p, const glm::vec3& q, const glm::vec3& r) const {
    glm::vec2 low(1e30f);
    glm::vec2 high(-1e30f);
    for (const glm::vec3* corner : {&p, &q, &r}) {
      const glm::vec3 way = columnsOf_ * (*corner - block_.origin);
      if (!(way.z > kNearest)) {
        return {0, block_.columns - 1, 0, block_.rows - 1};
      }
      const glm::vec2 place = glm::vec2(way) / way.z;
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
    // Within a block places are rounded by far less than that.
    constexpr float kMargin = 0.01f;
    const auto from = [](float value, int count) {
      return static_cast<int>(std::ceil(std::clamp(value - kMargin, 0.0f, static_cast<float>(count))));
    };
    const auto upTo = [](float value, int count) {
      return static_cast<int>(std::floor(std::clamp(value + kMargin, -1.0f, static_cast<float>(count - 1))));
    };
    return {from(low.x, block_.columns), upTo(high.x, block_.columns), from(low.y, block_.rows),
            upTo(high.y, block_.rows)};
  }

 private:
  static constexpr float kNearest = 1e-4f;

  const RayBlock& block_;
  glm::mat3 columnsOf_;
};

float farthestReach(const RayBlock& block) {
  float reach = 0;
  for (int i = 0; i < block.rays(); ++i) {
    reach = std::max(reach, block.reach[static_cast<size_t>(i)]);
  }
  return reach * (1 + kBlockRounding);
}

struct BlockWaiting {
  float entry;
  uint32_t reference;
};

}  // namespace

void SamplePyramid::meetBlock(RayBlock& block, RayCost& cost) const {
  if (root_.box.empty()) {
    return;
  }
  const BlockPixels pixels(block);
  const std::array<AxisSteps, 3> steps{axisSteps(block, 0), axisSteps(block, 1), axisSteps(block, 2)};
  const std::vector<glm::vec3>& positions = cells_.mesh.positions;
  float reach = farthestReach(block);
  bool nearer = false;
  std::array<BlockWaiting, kMaxBlockWaiting> waiting;
  size_t count = 0;
  waiting[count++] = {0, root_.reference};
  while (count > 0) {
    const BlockWaiting next = waiting[--count];
    if (next.entry > reach) {
      continue;
    }
    if ((next.reference & kCellBit) != 0) {
      const uint32_t cell = next.reference & ~kCellBit;
      ++cost.cells;
      for (uint32_t t = cells_.firstTriangle[cell]; t < cells_.firstTriangle[cell + 1]; ++t) {
        const glm::uvec3& corners = cells_.mesh.triangles[t];
        const glm::vec3& p = positions[corners.x];
        const glm::vec3& q = positions[corners.y];
        const glm::vec3& r = positions[corners.z];
        const BlockPixels::Range range = pixels.around(p, q, r);
        for (int row = range.firstRow; row <= range.lastRow; ++row) {
          for (int column = range.firstColumn; column <= range.lastColumn; ++column) {
            ++cost.triangles;
            const auto meeting = meetTriangle(block.ray(column, row), p, q, r, t);
            const auto i = static_cast<size_t>(block.indexOf(column, row));
            if (meeting && (!block.meets[i] || meeting->comesBefore(block.meeting[i]))) {
              block.meeting[i] = *meeting;
              block.meets[i] = true;
              block.reach[i] = std::nextafter(static_cast<float>(meeting->share), std::numeric_limits<float>::max());
              nearer = true;
            }
          }
        }
      }
      continue;
    }
    if (nearer) {
      reach = farthestReach(block);
      nearer = false;
      if (next.entry > reach) {
        continue;
      }
    }
    const Node& node = nodes_[next.reference];
    ++cost.nodes;
    cost.boxes += node.count;
    std::array<float, kChildren> enter;
    std::array<float, kChildren> leave;
    enter.fill(0);
    leave.fill(reach);
    for (size_t axis = 0; axis < 3; ++axis) {
      const float origin = block.origin[static_cast<int>(axis)];
      const float low = steps[axis].inverseLow;
      const float high = steps[axis].inverseHigh;
      if (steps[axis].bothSigns) {
        // Only boxes beside the origin are reached at once; no share ends there.
        for (size_t i = 0; i < kChildren; ++i) {
          enter[i] = std::max({enter[i], (node.lower[axis][i] - origin) * high, (node.upper[axis][i] - origin) * low});
        }
        continue;
      }
      for (size_t i = 0; i < kChildren; ++i) {
        const float a = (node.lower[axis][i] - origin) * low;
        const float b = (node.lower[axis][i] - origin) * high;
        const float c = (node.upper[axis][i] - origin) * low;
        const float d = (node.upper[axis][i] - origin) * high;
        enter[i] = std::max(enter[i], std::min(std::min(a, b), std::min(c, d)));
        leave[i] = std::min(leave[i], std::max(std::max(a, b), std::max(c, d)));
      }
    }
    const size_t first = count;
    for (size_t i = 0; i < node.count; ++i) {
      if (enter[i] * (1 - kBlockRounding) > leave[i] * (1 + kBlockRounding)) {
        continue;
      }
      size_t at = count++;
      for (; at > first && waiting[at - 1].entry < enter[i]; --at) {
        waiting[at] = waiting[at - 1];
      }
      waiting[at] = {enter[i] * (1 - kBlockRounding), node.child[i]};
    }
  }
}

}  // namespace ocelli
