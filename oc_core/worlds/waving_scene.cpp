#include "oc_core/worlds/waving_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

WavingScene::WavingScene(Mesh rest, double seconds, float sway) : rest_(std::move(rest)), seconds_(seconds) {
  const Box bounds = boundsOf(rest_);
  const float height = bounds.size().y;
  const double perLength = height > 0 ? 2 * kPi / static_cast<double>(height) : 0;
  for (const glm::vec3& p : rest_.positions) {
    const double angle = -perLength * static_cast<double>(p.y - bounds.lower.y);
    circles_.push_back(sway * glm::vec2(std::cos(angle), std::sin(angle)));
  }
}

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
  const double turn = 2 * kPi * share;
  const auto cosine = static_cast<float>(std::cos(turn));
  const auto sine = static_cast<float>(std::sin(turn));
  constexpr size_t kVerticesPerRange = 1 << 14;
  parallelFor(rest_.positions.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3& p = rest_.positions[i];
      const glm::vec2& circle = circles_[i];
      moved.mesh.positions[i] = {p.x + cosine * circle.x - sine * circle.y, p.y,
                                 p.z + sine * circle.x + cosine * circle.y};
    }
  });
}

}  // namespace ocelli
