#include "oc_core/worlds/waving_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

WavingScene::WavingScene(Mesh rest, double seconds, float sway)
    : rest_(std::move(rest)), seconds_(seconds), sway_(sway), bounds_(boundsOf(rest_)) {}

std::vector<double> WavingScene::sampleTimes() const {
  // A layer goes a circle of which any chord between two of these is 1 - cos(pi / 32) = 0.5 % of the sway short.
  constexpr size_t kTimes = 33;
  return evenTimes(seconds_, kTimes);
}

void WavingScene::moveTo(double seconds, MovedMesh& moved) const {
  if (moved.topology != 1) {
    moved = {rest_, 1};
  }
  const double share = std::clamp(seconds / seconds_, 0.0, 1.0);
  moved.shape = std::bit_cast<uint64_t>(share);
  const auto turn = static_cast<float>(2 * kPi * share);
  const float height = bounds_.size().y;
  const float perLength = height > 0 ? static_cast<float>(2 * kPi) / height : 0;
  constexpr size_t kVerticesPerRange = 1 << 13;
  parallelFor(rest_.positions.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3& p = rest_.positions[i];
      const float angle = turn - perLength * (p.y - bounds_.lower.y);
      moved.mesh.positions[i] = {p.x + sway_ * std::cos(angle), p.y, p.z + sway_ * std::sin(angle)};
    }
  });
}

}  // namespace ocelli
