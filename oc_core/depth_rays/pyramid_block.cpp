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
/// What the steps of a block are along one axis: 1 over the ends of their interval.
struct AxisSteps {
  float inverseLow = 0;
  float inverseHigh = 0;
  bool bothSigns = false;
};

/// Of steps from a corner to as much as `across` and `along` beside it.
std::array<AxisSteps, 3> axisSteps(const glm::vec3& corner, const glm::vec3& across, const glm::vec3& along) {
  std::array<AxisSteps, 3> steps;
  for (int axis = 0; axis < 3; ++axis) {
    const float margin =
        kBlockRounding * (std::abs(corner[axis]) + std::abs(across[axis]) + std::abs(along[axis])) + 1e-30f;
    const float low = corner[axis] + std::min(across[axis], 0.0f) + std::min(along[axis], 0.0f) - margin;
    const float high = corner[axis] + std::max(across[axis], 0.0f) + std::max(along[axis], 0.0f) + margin;
    steps[static_cast<size_t>(axis)] = {1 / low, 1 / high, low <= 0 && high >= 0};
  }
  return steps;
}

std::array<AxisSteps, 3> axisSteps(const RayBlock& block) {
  return axisSteps(block.first, block.perColumn * static_cast<float>(block.columns - 1),
                   block.perRow * static_cast<float>(block.rows - 1));
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

/// Where any ray of a block may enter and leave each of 16 boxes.
template <size_t kBoxes>
void enterBoxes(const std::array<AxisSteps, 3>& steps, const glm::vec3& from, float reach,
                const std::array<std::array<float, kBoxes>, 3>& lower,
                const std::array<std::array<float, kBoxes>, 3>& upper, std::array<float, kBoxes>& enter,
                std::array<float, kBoxes>& leave) {
  enter.fill(0);
  leave.fill(reach);
  for (size_t axis = 0; axis < 3; ++axis) {
    const float origin = from[static_cast<int>(axis)];
    const float low = steps[axis].inverseLow;
    const float high = steps[axis].inverseHigh;
    if (steps[axis].bothSigns) {
      // Only boxes beside the origin are entered later than at once; no share ends there.
      for (size_t i = 0; i < kBoxes; ++i) {
        enter[i] = std::max({enter[i], (lower[axis][i] - origin) * high, (upper[axis][i] - origin) * low});
      }
      continue;
    }
    for (size_t i = 0; i < kBoxes; ++i) {
      const float a = (lower[axis][i] - origin) * low;
      const float b = (lower[axis][i] - origin) * high;
      const float c = (upper[axis][i] - origin) * low;
      const float d = (upper[axis][i] - origin) * high;
      enter[i] = std::max(enter[i], std::min(std::min(a, b), std::min(c, d)));
      leave[i] = std::min(leave[i], std::max(std::max(a, b), std::max(c, d)));
    }
  }
}

/// Boxes beside each other, for loops over them.
template <size_t kMax>
struct BoxList {
  std::array<std::array<float, kMax>, 3> lower;
  std::array<std::array<float, kMax>, 3> upper;
  std::array<float, kMax> entry;
  std::array<uint32_t, kMax> reference;
  size_t count = 0;

  void add(const Box& box, float entryShare, uint32_t what) { put(count++, box, entryShare, what); }
  void put(size_t i, const Box& box, float entryShare, uint32_t what) {
    for (size_t axis = 0; axis < 3; ++axis) {
      lower[axis][i] = box.lower[static_cast<int>(axis)];
      upper[axis][i] = box.upper[static_cast<int>(axis)];
    }
    entry[i] = entryShare;
    reference[i] = what;
  }
  void removeAt(size_t i) {
    --count;
    for (size_t axis = 0; axis < 3; ++axis) {
      lower[axis][i] = lower[axis][count];
      upper[axis][i] = upper[axis][count];
    }
    entry[i] = entry[count];
    reference[i] = reference[count];
  }
  float sideOf(size_t i) const {
    return std::max({upper[0][i] - lower[0][i], upper[1][i] - lower[1][i], upper[2][i] - lower[2][i]});
  }
};

}  // namespace

void SamplePyramid::meetBlock(RayBlock& block, RayCost& cost) const {
  if (root_.box.empty()) {
    return;
  }
  const BlockPixels pixels(block);
  const std::array<AxisSteps, 3> steps = axisSteps(block);
  const std::vector<glm::vec3>& positions = cells_.mesh.positions;
  float reach = farthestReach(block);
  bool nearer = false;
  WaitingList waiting;
  size_t count = 0;
  waiting[count++] = {0, root_.reference};
  while (count > 0) {
    const Waiting next = waiting[--count];
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
    enterBoxes(steps, block.origin, reach, node.lower, node.upper, enter, leave);
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

void SamplePyramid::meetWideBlock(RayBlock& block, RayCost& cost) const {
  if (root_.box.empty()) {
    return;
  }
  const std::array<AxisSteps, 3> steps = axisSteps(block);
  const float reach = farthestReach(block);
  // A block is that wide a share of the way to it.
  const float width = std::max(glm::length(block.perColumn) * static_cast<float>(block.columns),
                               glm::length(block.perRow) * static_cast<float>(block.rows));
  BoxList<kMaxBegins> begins;
  begins.add(root_.box, 0, root_.reference);
  for (size_t i = 0; i < begins.count && begins.count + kChildren - 1 <= kMaxBegins;) {
    const bool isCell = (begins.reference[i] & kCellBit) != 0;
    if (isCell || begins.sideOf(i) < width * begins.entry[i]) {
      ++i;
      continue;
    }
    const Node& node = nodes_[begins.reference[i]];
    begins.removeAt(i);
    ++cost.nodes;
    cost.boxes += node.count;
    std::array<float, kChildren> enter;
    std::array<float, kChildren> leave;
    enterBoxes(steps, block.origin, reach, node.lower, node.upper, enter, leave);
    for (size_t child = 0; child < node.count; ++child) {
      if (enter[child] * (1 - kBlockRounding) <= leave[child] * (1 + kBlockRounding)) {
        const Box box{{node.lower[0][child], node.lower[1][child], node.lower[2][child]},
                      {node.upper[0][child], node.upper[1][child], node.upper[2][child]}};
        begins.add(box, enter[child] * (1 - kBlockRounding), node.child[child]);
      }
    }
  }
  if (begins.count == 0) {
    return;
  }
  // Loops over all boxes are faster than over some.
  for (size_t i = begins.count; i < kMaxBegins; ++i) {
    begins.put(i, Box{glm::vec3(1e30f), glm::vec3(1e30f)}, 0, 0);
  }
  for (int row = 0; row < block.rows; ++row) {
    for (int column = 0; column < block.columns; ++column) {
      const auto at = static_cast<size_t>(block.indexOf(column, row));
      const StraightRay ray = block.ray(column, row);
      const std::array<AxisSteps, 3> own = axisSteps(ray.step, glm::vec3(0), glm::vec3(0));
      std::array<float, kMaxBegins> enter;
      std::array<float, kMaxBegins> leave;
      enterBoxes(own, ray.origin, ray.reach * (1 + kBlockRounding), begins.lower, begins.upper, enter, leave);
      cost.boxes += begins.count;
      WaitingList waiting;
      size_t count = 0;
      for (size_t i = 0; i < begins.count; ++i) {
        if (enter[i] * (1 - kBlockRounding) > leave[i] * (1 + kBlockRounding)) {
          continue;
        }
        size_t place = count++;
        for (; place > 0 && waiting[place - 1].entry < enter[i]; --place) {
          waiting[place] = waiting[place - 1];
        }
        waiting[place] = {enter[i] * (1 - kBlockRounding), begins.reference[i]};
      }
      const auto meeting = count > 0 ? goOn(ray, waiting, count, cost) : std::nullopt;
      if (meeting && (!block.meets[at] || meeting->comesBefore(block.meeting[at]))) {
        block.meeting[at] = *meeting;
        block.meets[at] = true;
        block.reach[at] = std::nextafter(static_cast<float>(meeting->share), std::numeric_limits<float>::max());
      }
    }
  }
}

}  // namespace ocelli
