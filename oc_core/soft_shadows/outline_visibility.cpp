#include "oc_core/soft_shadows/outline_visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/soft_shadows/outline_block.h"

namespace ocelli {
namespace {

constexpr size_t kReceiversABlock = 256;
/// Blocks are halved until they hold so few receivers, ...
constexpr size_t kFewReceivers = 8;
/// ... or extend by no more than this share of the light.
constexpr float kSmallBlock = 0.25f;

/// A receiver that the light shines at.
struct Asked {
  size_t index = 0;
  glm::vec3 position{0};
};

Box boxOf(std::span<const Asked> asked) {
  Box box;
  for (const Asked& each : asked) {
    box.add(each.position);
  }
  return box;
}

/// What a thread needs.
struct Workspace {
  explicit Workspace(const LightGrid& grid) : cover(grid) {}

  LightCover cover;
  OutlineBlock block;
  std::vector<const OccluderEdge*> found;
  std::vector<SightLine> lines;
  std::vector<uint8_t> blocked;
};

}  // namespace

OutlineVisibility::OutlineVisibility(const Mesh& occluders, const AreaLight& light, const OutlineOptions& options)
    : frame_(light),
      options_(options),
      grid_(frame_, options.gridSide),
      edges_(occluderEdges(occluders, frame_)),
      rims_(edges_.rims, edges_.planes),
      folds_(edges_.folds, edges_.planes),
      rays_(edges_.mesh, true) {}

LightVisibility OutlineVisibility::of(std::span<const ShadowReceiver> receivers) const {
  LightVisibility result;
  result.share.assign(receivers.size(), 0);
  result.estimatedError.assign(receivers.size(), 0);
  const size_t tasks = (receivers.size() + kReceiversABlock - 1) / kReceiversABlock;
  std::vector<ShadowWork> workOf(tasks);

  const float cells = static_cast<float>(grid_.count());
  const auto solve = [&](std::span<Asked> asked, Workspace& own, ShadowWork& work) {
    const Box box = boxOf(asked);
    const LightShaft shaft(box, frame_.half());
    own.found.clear();
    work.elements += rims_.find(shaft, own.found);
    work.elements += folds_.find(shaft, own.found);
    own.block.take(own.found, edges_.planes, box);
    own.lines.resize(asked.size());
    own.blocked.resize(asked.size());
    for (size_t i = 0; i < asked.size(); ++i) {
      const glm::vec3& p = asked[i].position;
      float& share = result.share[asked[i].index];
      glm::vec3 to(0);
      share = 1;
      OutlineBlock::Projected projected;
      if (!own.block.empty()) {
        own.cover.clear();
        projected = own.block.project(p, grid_, edges_.planes, own.cover);
        work.elements += own.block.size();
      }
      if (projected.edges > 0) {
        const LightCover::Least least = own.cover.least();
        share = static_cast<float>(least.count) / cells;
        to = grid_.point(least.column, least.row);
        // Crofton: an outline crosses 4 / pi as many pairs of a grid as it is long.
        const float crossings = static_cast<float>(least.neighbours);
        const float meanShift = options_.footprintPerDistance * 0.5f *
                                static_cast<float>(projected.lengthening / static_cast<double>(projected.edges)) *
                                0.5f * (grid_.scale().x + grid_.scale().y);
        result.estimatedError[asked[i].index] =
            (std::sqrt(crossings / 12) + crossings * std::numbers::pi_v<float> / 4 * meanShift) / cells;
      }
      own.lines[i] = {p, to};
    }
    rays_.find(own.lines, own.blocked);
    work.rays += asked.size();
    for (size_t i = 0; i < asked.size(); ++i) {
      if (own.blocked[i] != 0) {
        result.share[asked[i].index] = 0;
        result.estimatedError[asked[i].index] = 0;
      }
    }
  };
  const auto halve = [&](auto& self, std::span<Asked> asked, Workspace& own, ShadowWork& work) -> void {
    if (asked.empty()) {
      return;
    }
    const glm::vec3 size = boxOf(asked).size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (asked.size() <= kFewReceivers || size[axis] <= kSmallBlock * std::max(frame_.half().x, frame_.half().y)) {
      solve(asked, own, work);
      return;
    }
    const auto middle = asked.begin() + static_cast<std::ptrdiff_t>(asked.size() / 2);
    std::nth_element(asked.begin(), middle, asked.end(), [axis](const Asked& p, const Asked& q) {
      return std::pair(p.position[axis], p.index) < std::pair(q.position[axis], q.index);
    });
    self(self, asked.first(asked.size() / 2), own, work);
    self(self, asked.subspan(asked.size() / 2), own, work);
  };
  parallelFor(tasks, 4, [&](size_t begin, size_t end) {
    Workspace own(grid_);
    std::vector<Asked> asked;
    for (size_t task = begin; task < end; ++task) {
      asked.clear();
      const size_t last = std::min((task + 1) * kReceiversABlock, receivers.size());
      for (size_t i = task * kReceiversABlock; i < last; ++i) {
        LitReceiver lit;
        if (isLit(receivers[i], frame_, options_.lift, lit)) {
          asked.push_back({i, lit.position});
        }
      }
      halve(halve, asked, own, workOf[task]);
    }
  });
  for (const ShadowWork& work : workOf) {
    result.work.rays += work.rays;
    result.work.elements += work.elements;
  }
  return result;
}

}  // namespace ocelli
