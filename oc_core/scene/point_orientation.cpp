#include "oc_core/scene/point_orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr size_t kSteps = 1024;

class Orienter {
 public:
  Orienter(std::span<const glm::vec3> positions, std::span<const uint32_t> neighbors, size_t perPoint,
           std::span<glm::vec3> normals)
      : positions_(positions),
        neighbors_(neighbors),
        perPoint_(perPoint),
        normals_(normals),
        partOf_(positions.size(), kNoPart) {}

  void run() {
    for (uint32_t seed = 0; seed < positions_.size(); ++seed) {
      if (partOf_[seed] == kNoPart) {
        join(seed, parts_++);
        spread();
      }
    }
    joinParts();
    turnOutwards();
  }

 private:
  static constexpr uint32_t kNoPart = 0xffffffffu;

  struct Step {
    uint32_t to, from;
  };

  std::span<const uint32_t> neighborsOf(uint32_t point) const {
    return neighbors_.subspan(point * perPoint_, perPoint_);
  }

  /// 1 where the normal of `to` is the one that a circular arc from `from` to it would have there, whose normals mirror
  /// each other in the plane between the two; -1 where it is its opposite. So the other side of a thin sheet gets the
  /// opposite normal (after Koenig and Gumhold 2009, section 3).
  float agreement(uint32_t from, uint32_t to) const {
    const glm::vec3 along = glm::normalize(positions_[to] - positions_[from]);
    const glm::vec3& normal = normals_[from];
    return glm::dot(normal - 2 * glm::dot(normal, along) * along, normals_[to]);
  }

  void join(uint32_t point, uint32_t part) {
    partOf_[point] = part;
    for (const uint32_t neighbor : neighborsOf(point)) {
      if (neighbor == kNoNeighbor || partOf_[neighbor] != kNoPart) {
        continue;
      }
      const float doubt = 1 - std::min(1.0f, std::abs(agreement(point, neighbor)));
      const auto step = std::min(kSteps - 1, static_cast<size_t>(doubt * static_cast<float>(kSteps)));
      steps_[step].push_back({neighbor, point});
      first_ = std::min(first_, step);
    }
  }

  /// Reaches all that can be reached, the least doubtful first.
  void spread() {
    while (true) {
      while (first_ < kSteps && steps_[first_].empty()) {
        ++first_;
      }
      if (first_ == kSteps) {
        return;
      }
      const Step step = steps_[first_].back();
      steps_[first_].pop_back();
      if (partOf_[step.to] == kNoPart) {
        if (agreement(step.from, step.to) < 0) {
          normals_[step.to] = -normals_[step.to];
        }
        join(step.to, partOf_[step.from]);
      }
    }
  }

  /// Neighbours need not name each other, so that a part may name points of another one that was spread before. All
  /// that do so decide together how the two go together.
  void joinParts() {
    std::map<std::pair<uint32_t, uint32_t>, double> agreements;
    for (uint32_t point = 0; point < positions_.size(); ++point) {
      for (const uint32_t neighbor : neighborsOf(point)) {
        if (neighbor != kNoNeighbor && partOf_[neighbor] != partOf_[point]) {
          const auto agree = static_cast<double>(agreement(point, neighbor));
          agreements[std::minmax(partOf_[point], partOf_[neighbor])] += agree * std::abs(agree);
        }
      }
    }
    std::vector<std::pair<std::pair<uint32_t, uint32_t>, double>> pairs(agreements.begin(), agreements.end());
    std::ranges::stable_sort(pairs, std::greater(), [](const auto& pair) { return std::abs(pair.second); });
    // A forest whose trees are what belongs together; each part knows whether it is turned against the one above.
    above_.resize(parts_);
    std::iota(above_.begin(), above_.end(), 0u);
    isAgainst_.assign(parts_, false);
    for (const auto& [pair, agree] : pairs) {
      const auto [first, firstAgainst] = rootOf(pair.first);
      const auto [second, secondAgainst] = rootOf(pair.second);
      if (first != second) {
        above_[second] = first;
        isAgainst_[second] = (agree < 0) != (firstAgainst != secondAgainst);
      }
    }
    for (uint32_t point = 0; point < positions_.size(); ++point) {
      const auto [root, against] = rootOf(partOf_[point]);
      normals_[point] = against ? -normals_[point] : normals_[point];
    }
  }

  /// The part at the root, and whether `part` is turned against it. Shortens the way there.
  std::pair<uint32_t, bool> rootOf(uint32_t part) {
    if (above_[part] == part) {
      return {part, false};
    }
    const auto [root, against] = rootOf(above_[part]);
    above_[part] = root;
    isAgainst_[part] = isAgainst_[part] != against;
    return {root, isAgainst_[part]};
  }

  /// What the extreme points of a tree of parts say.
  struct Outside {
    glm::vec3 lowest{std::numeric_limits<float>::max()};
    glm::vec3 highest{std::numeric_limits<float>::lowest()};
    glm::vec3 normalAtLowest{0};  ///< along each axis
    glm::vec3 normalAtHighest{0};
    double sumZ = 0;

    bool isInside() const {
      const glm::vec3 outwards = normalAtHighest - normalAtLowest;
      const float sum = outwards.x + outwards.y + outwards.z;
      constexpr float kNothing = 1e-3f;
      return std::abs(sum) < kNothing ? sumZ < 0 : sum < 0;
    }
  };

  void turnOutwards() {
    std::vector<Outside> outsides(parts_);
    for (uint32_t point = 0; point < positions_.size(); ++point) {
      Outside& outside = outsides[rootOf(partOf_[point]).first];
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        const float place = positions_[point][axis];
        const float along = normals_[point][axis];
        if (place < outside.lowest[axis]) {
          outside.lowest[axis] = place;
          outside.normalAtLowest[axis] = along;
        }
        if (place > outside.highest[axis]) {
          outside.highest[axis] = place;
          outside.normalAtHighest[axis] = along;
        }
      }
      outside.sumZ += static_cast<double>(normals_[point].z);
    }
    for (uint32_t point = 0; point < positions_.size(); ++point) {
      if (outsides[rootOf(partOf_[point]).first].isInside()) {
        normals_[point] = -normals_[point];
      }
    }
  }

  std::span<const glm::vec3> positions_;
  std::span<const uint32_t> neighbors_;
  size_t perPoint_;
  std::span<glm::vec3> normals_;
  std::vector<uint32_t> partOf_;
  uint32_t parts_ = 0;
  std::array<std::vector<Step>, kSteps> steps_;
  size_t first_ = kSteps;
  std::vector<uint32_t> above_;  ///< of each part; itself at the root
  std::vector<bool> isAgainst_;
};

}  // namespace

void orientNormals(std::span<const glm::vec3> positions, std::span<const uint32_t> neighbors, size_t perPoint,
                   std::span<glm::vec3> normals) {
  OC_CHECK(normals.size() == positions.size() && neighbors.size() == positions.size() * perPoint,
           "each point has a normal and its neighbours");
  Orienter(positions, neighbors, perPoint, normals).run();
}

}  // namespace ocelli
