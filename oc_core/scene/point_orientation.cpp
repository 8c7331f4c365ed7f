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

/// Sets of things of which each is turned against another one of its set, or is not. A thing is never more steps from
/// its root than the logarithm of the size of the set.
class TurnedSets {
 public:
  struct Root {
    uint32_t thing;
    bool isAgainst;  ///< what was asked for is turned against it
  };

  explicit TurnedSets(size_t count) : above_(count), sizes_(count, 1), isAgainst_(count, false) {
    std::iota(above_.begin(), above_.end(), 0u);
  }

  Root rootOf(uint32_t thing) const {
    bool against = false;
    for (; above_[thing] != thing; thing = above_[thing]) {
      against = against != isAgainst_[thing];
    }
    return {thing, against};
  }

  /// Nothing changes where the two are in one set.
  void join(uint32_t a, uint32_t b, bool areAgainst) {
    Root larger = rootOf(a);
    Root smaller = rootOf(b);
    if (larger.thing == smaller.thing) {
      return;
    }
    if (sizes_[larger.thing] < sizes_[smaller.thing]) {
      std::swap(larger, smaller);
    }
    above_[smaller.thing] = larger.thing;
    sizes_[larger.thing] += sizes_[smaller.thing];
    isAgainst_[smaller.thing] = areAgainst != (larger.isAgainst != smaller.isAgainst);
  }

 private:
  std::vector<uint32_t> above_;  ///< itself at the root
  std::vector<uint32_t> sizes_;  ///< of the sets, at their roots
  std::vector<bool> isAgainst_;  ///< the one above; meaningless at the root
};

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
    const glm::vec3 apart = positions_[to] - positions_[from];
    const glm::vec3& normal = normals_[from];
    if (glm::dot(apart, apart) < std::numeric_limits<float>::min()) {
      return glm::dot(normal, normals_[to]);  // at one place, as far as squares tell
    }
    const glm::vec3 along = glm::normalize(apart);
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
    sets_ = TurnedSets(parts_);
    for (const auto& [pair, agree] : pairs) {
      sets_.join(pair.first, pair.second, agree < 0);
    }
    for (uint32_t point = 0; point < positions_.size(); ++point) {
      normals_[point] = sets_.rootOf(partOf_[point]).isAgainst ? -normals_[point] : normals_[point];
    }
  }

  /// What the extreme points of parts that are joined say.
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
      Outside& outside = outsides[sets_.rootOf(partOf_[point]).thing];
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
      if (outsides[sets_.rootOf(partOf_[point]).thing].isInside()) {
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
  TurnedSets sets_{0};  ///< of parts
};

}  // namespace

void orientNormals(std::span<const glm::vec3> positions, std::span<const uint32_t> neighbors, size_t perPoint,
                   std::span<glm::vec3> normals) {
  OC_CHECK(normals.size() == positions.size() && neighbors.size() == positions.size() * perPoint,
           "each point has a normal and its neighbours");
  Orienter(positions, neighbors, perPoint, normals).run();
}

}  // namespace ocelli
