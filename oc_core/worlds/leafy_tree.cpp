#include "oc_core/worlds/leafy_tree.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/random_places.h"

namespace ocelli {
namespace {

constexpr int kLevels = 4;       ///< of branches, with the trunk
constexpr size_t kChildren = 4;  ///< of each branch
constexpr uint32_t kSides = 5;
constexpr size_t kTrianglesOfBranch = 4 * kSides - 4;
constexpr float kTrunkLength = 0.72f;
constexpr float kTrunkRadius = 0.062f;
constexpr float kLeafArea = 4.2f;  ///< of all leaves

constexpr size_t branchCount() {
  size_t count = 0;
  size_t ofLevel = 1;
  for (int level = 0; level < kLevels; ++level) {
    count += ofLevel;
    ofLevel *= kChildren;
  }
  return count;
}

struct Twig {
  glm::vec3 from, to;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(uint64_t seed) : random_(seed) {}

  void grow() { addBranch({0, 0, 0}, {0, 1, 0}, kTrunkLength, kTrunkRadius, 0); }

  void addLeaves(size_t triangles) {
    const size_t leaves = (triangles + 1) / 2;
    // A leaf is half as wide as long, and a rhombus: its area is a quarter of its length squared.
    const float length = std::sqrt(4 * kLeafArea / static_cast<float>(leaves));
    for (size_t i = 0; i < leaves; ++i) {
      addLeaf(length, 2 * i + 1 == triangles);
    }
  }

  Mesh take() { return std::move(tree_); }

 private:
  void addBranch(const glm::vec3& from, const glm::vec3& direction, float length, float radius, int level) {
    const glm::vec3 to = from + direction * length;
    constexpr float kTaper = 0.68f;
    addWood(from, to, radius, radius * kTaper);
    if (level + 2 >= kLevels) {
      twigs_.push_back({from, to});
    }
    if (level + 1 == kLevels) {
      return;
    }
    // Around the branch, evenly but for some chance; each bends up again a little.
    const glm::vec3 x = randomBeside(direction, random_);
    const glm::vec3 z = glm::cross(direction, x);
    for (size_t i = 0; i < kChildren; ++i) {
      const auto turn =
          static_cast<float>(2 * kPi / kChildren) * (static_cast<float>(i) + random_.inRange(-0.15f, 0.15f));
      const float spread = random_.inRange(0.5f, 0.95f);
      const glm::vec3 aside = x * std::cos(turn) + z * std::sin(turn);
      const glm::vec3 child =
          glm::normalize(direction * std::cos(spread) + aside * std::sin(spread) + glm::vec3(0, 0.12f, 0));
      const float start = i == 0 ? 1.0f : random_.inRange(0.75f, 1.0f);
      addBranch(glm::mix(from, to, start), child, length * random_.inRange(0.62f, 0.82f), radius * kTaper, level + 1);
    }
  }

  /// A closed prism that tapers.
  void addWood(const glm::vec3& from, const glm::vec3& to, float fromRadius, float toRadius) {
    const glm::vec3 along = glm::normalize(to - from);
    const glm::vec3 x =
        glm::normalize(glm::cross(std::abs(along.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1), along));
    const glm::vec3 y = glm::cross(along, x);
    const auto base = static_cast<uint32_t>(tree_.positions.size());
    const glm::vec3 color = palette::fromSrgbBytes(128, 92, 66) * random_.inRange(0.8f, 1.1f);
    for (const auto& [middle, radius] : {std::pair{from, fromRadius}, std::pair{to, toRadius}}) {
      for (uint32_t i = 0; i < kSides; ++i) {
        const auto angle = static_cast<float>(2 * kPi * i / kSides);
        tree_.positions.push_back(middle + radius * (x * std::cos(angle) + y * std::sin(angle)));
        tree_.colors.push_back(color);
      }
    }
    for (uint32_t i = 0; i < kSides; ++i) {
      const uint32_t j = (i + 1) % kSides;
      tree_.triangles.push_back({base + i, base + j, base + kSides + j});
      tree_.triangles.push_back({base + i, base + kSides + j, base + kSides + i});
      if (i > 0 && j > 0) {
        tree_.triangles.push_back({base, base + j, base + i});
        tree_.triangles.push_back({base + kSides, base + kSides + i, base + kSides + j});
      }
    }
  }

  /// Somewhere along a twig or beyond its end, near it.
  void addLeaf(float length, bool half) {
    const Twig& twig = twigs_[random_.below(twigs_.size())];
    constexpr float kCloud = 0.16f;
    const glm::vec3 stem = glm::mix(twig.from, twig.to, random_.inRange(0.3f, 1.25f)) + kCloud * randomInBall(random_);
    // Leaves hang outwards and a little down.
    const glm::vec3 along = glm::normalize(randomDirection(random_) + glm::vec3(stem.x, -0.5f, stem.z));
    const glm::vec3 beside = randomBeside(along, random_);
    const glm::vec3 up = glm::cross(along, beside);
    const glm::vec3 middle = stem + 0.45f * length * along + 0.08f * length * up;  // of its sides: it is folded
    const auto base = static_cast<uint32_t>(tree_.positions.size());
    tree_.positions.push_back(stem);
    tree_.positions.push_back(middle - 0.25f * length * beside);
    tree_.positions.push_back(stem + length * along);
    tree_.triangles.push_back({base, base + 1, base + 2});
    if (!half) {
      tree_.positions.push_back(middle + 0.25f * length * beside);
      tree_.triangles.push_back({base, base + 2, base + 3});
    }
    static const std::array<glm::vec3, 4> kGreens{
        palette::fromSrgbBytes(86, 150, 58), palette::fromSrgbBytes(122, 178, 66), palette::fromSrgbBytes(66, 128, 62),
        palette::fromSrgbBytes(170, 190, 74)};
    tree_.colors.resize(tree_.positions.size(), kGreens[random_.below(kGreens.size())] * random_.inRange(0.85f, 1.1f));
  }

  Random random_;
  Mesh tree_;
  std::vector<Twig> twigs_;
};

}  // namespace

size_t minTreeTriangles() {
  return branchCount() * kTrianglesOfBranch + 1;
}

Mesh makeLeafyTree(size_t triangles, uint64_t seed) {
  OC_CHECK(triangles >= minTreeTriangles(), "a tree has a trunk, branches and a leaf");
  TreeBuilder builder(seed);
  builder.grow();
  builder.addLeaves(triangles - branchCount() * kTrianglesOfBranch);
  return builder.take();
}

}  // namespace ocelli
