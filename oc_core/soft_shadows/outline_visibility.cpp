#include "oc_core/soft_shadows/outline_visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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
  LitReceiver lit;
};

/// The horizon of a receiver, where it crosses the light, as an edge of what it hides. In the light's plane it is the
/// line on which dot(normal, point) is the horizon.
void addHorizon(const LitReceiver& lit, const LightGrid& grid, LightCover& cover) {
  // In grid coordinates the normal of the line shrinks where these are wider.
  const glm::vec2 normal = glm::vec2(lit.normal) / grid.scale();
  const float length = glm::length(normal);
  const glm::vec2 unit = normal / length;
  const float distance = (lit.horizon + glm::dot(normal, grid.offset())) / length;
  // Far beyond the light to both sides; what is hidden lies to the left of the edge.
  const float far = 8.0f * static_cast<float>(grid.side());
  const glm::vec2 middle(static_cast<float>(grid.side()) / 2);
  const glm::vec2 foot = middle + unit * (distance - glm::dot(unit, middle));
  const glm::vec2 along(-unit.y, unit.x);
  cover.add(foot - along * far, foot + along * far, LightCover::kHorizonWeight);
}

Box boxOf(std::span<const Asked> asked) {
  Box box;
  for (const Asked& each : asked) {
    box.add(each.lit.position);
  }
  return box;
}

/// A ray to each sample.
float shareByRays(const LitReceiver& lit, const LightGrid& grid, const BlockedRays& rays) {
  std::vector<SightLine> lines;
  for (int column = 0; column < grid.side(); ++column) {
    for (int row = 0; row < grid.side(); ++row) {
      const glm::vec3 to = grid.point(column, row);
      if (grid.isOnLight(column, row) && lit.isAbove(to)) {
        lines.push_back({lit.position, to});
      }
    }
  }
  std::vector<uint8_t> blocked(lines.size());
  rays.find(lines, blocked);
  return static_cast<float>(std::count(blocked.begin(), blocked.end(), 0)) / static_cast<float>(grid.count());
}

/// What a thread needs.
struct Workspace {
  explicit Workspace(const LightGrid& grid) : cover(grid) {}

  LightCover cover;
  OutlineBlock block;
  std::vector<const OccluderEdge*> found;
  std::vector<SightLine> lines;
  std::vector<uint8_t> blocked;
  std::vector<uint8_t> mustBeBlocked;
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

  // Half a footprint, of the light's mean side.
  const float shiftPerDistance = options_.footprintPerDistance * 0.5f * (grid_.scale().x + grid_.scale().y) * 0.5f /
                                 static_cast<float>(grid_.side());
  const float cells = static_cast<float>(grid_.count());
  const auto solve = [&](std::span<Asked> asked, Workspace& own, ShadowWork& work) {
    const Box box = boxOf(asked);
    const LightShaft shaft(box, frame_.half());
    own.found.clear();
    work.elements += rims_.find(shaft, own.found);
    work.elements += folds_.find(shaft, own.found);
    own.block.take(own.found, edges_.planes, box);
    own.lines.clear();
    own.mustBeBlocked.clear();
    for (size_t i = 0; i < asked.size(); ++i) {
      const LitReceiver& lit = asked[i].lit;
      const glm::vec3& p = lit.position;
      float& share = result.share[asked[i].index];
      glm::vec3 to(0);
      glm::vec3 other(0);
      std::optional<glm::vec3> hidden;
      share = 1;
      OutlineBlock::Projected projected;
      if (!own.block.empty() || lit.seesHorizon) {
        own.cover.clear();
        projected = own.block.project(p, grid_, edges_.planes, shiftPerDistance, own.cover);
        work.elements += own.block.size();
      }
      if (lit.seesHorizon) {
        addHorizon(lit, grid_, own.cover);
      }
      if (projected.edges > 0 || lit.seesHorizon) {
        const LightCover::Least least = own.cover.least();
        share = static_cast<float>(least.count) / cells;
        to = grid_.point(least.column, least.row);
        other = grid_.point(least.otherColumn, least.otherRow);
        if (least.hasHidden) {
          hidden = grid_.point(least.hiddenColumn, least.hiddenRow);
        }
        if (!lit.isAbove(to)) {
          share = 0;  // no sample lies over the horizon
        }
        // Crofton: an outline crosses 4 / pi as many pairs of a grid as it is long.
        const float crossings = static_cast<float>(least.neighbours);
        const float length = crossings * std::numbers::pi_v<float> / 4 / static_cast<float>(grid_.side());
        const float meanShift = projected.shift / static_cast<float>(std::max<size_t>(projected.edges, 1));
        result.estimatedError[asked[i].index] = std::min(1.0f, std::sqrt(crossings / 12) / cells + length * meanShift);
      }
      own.lines.push_back({p, to});
      own.lines.push_back({p, other});
      // Below the horizon nothing else needs to stand before it.
      own.lines.push_back({p, hidden && lit.isAbove(*hidden) ? *hidden : to});
      own.mustBeBlocked.push_back(hidden && lit.isAbove(*hidden) ? 1 : 0);
    }
    own.blocked.resize(own.lines.size());
    rays_.find(own.lines, own.blocked);
    work.rays += own.lines.size();
    for (size_t i = 0; i < asked.size(); ++i) {
      const bool isLeastBlocked = own.blocked[3 * i] != 0;
      if (isLeastBlocked != (own.blocked[3 * i + 1] != 0) ||
          (own.mustBeBlocked[i] != 0 && own.blocked[3 * i + 2] == 0)) {
        result.share[asked[i].index] = shareByRays(asked[i].lit, grid_, rays_);
        work.rays += static_cast<uint64_t>(grid_.count());
      } else if (isLeastBlocked) {
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
      return std::pair(p.lit.position[axis], p.index) < std::pair(q.lit.position[axis], q.index);
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
          asked.push_back({i, lit});
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
