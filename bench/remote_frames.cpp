#include "bench/remote_frames.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {

std::vector<View> remotePath(const View& view, const glm::ivec2& screen, const RemoteRange& range, bool moves,
                             double nearest, size_t frames) {
  const PinholeCamera camera(view, screen.x, screen.y);
  const double half = radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2;
  const double halfAcross = std::atan(std::tan(half) * screen.x / screen.y);
  const auto distance = static_cast<double>(glm::distance(view.eye, view.target));
  std::vector<View> path;
  for (size_t i = 0; i < frames; ++i) {
    // A Lissajous curve: three frequencies that share no period.
    const double phase = 2 * kPi * static_cast<double>(i) / static_cast<double>(frames);
    const double zoom = std::pow(range.zoom, 0.5 - 0.5 * std::cos(phase));
    // In angles of the screen, on an ellipse: a corner that is panned along both axes leaves the image first. Zoomed
    // in, the screen is narrower: it may pan farther.
    const double room = (2 * range.pan + 1 - 1 / zoom) / std::sqrt(2.0);
    const double right = std::tan(halfAcross * room * std::sin(2 * phase));
    const double down = std::tan(half * room * std::sin(3 * phase));
    View next = view;
    const glm::vec3 direction =
        camera.forward() + camera.right() * static_cast<float>(right) + camera.down() * static_cast<float>(down);
    if (moves) {
      const auto step = static_cast<float>(range.translation * nearest);
      next.eye += step *
                  (camera.right() * static_cast<float>(std::sin(4 * phase + 1)) +
                   camera.down() * static_cast<float>(std::sin(3 * phase + 2)) +
                   camera.forward() * static_cast<float>(std::sin(5 * phase + 3))) *
                  0.57735f;
    }
    next.target = next.eye + glm::normalize(direction) * static_cast<float>(distance);
    next.fovVerticalDegrees = degreesFromRadians(2 * std::atan(std::tan(half) / zoom));
    path.push_back(next);
  }
  return path;
}

Image<Rgb8> directFrame(const RemoteScene& scene, const View& view, const glm::ivec2& screen, int samples) {
  const RemotePlan plan{PinholeCamera(view, screen.x, screen.y), {.regions = {}}};
  return srgbFromLinear(scene.draw(plan, samples).color);
}

}  // namespace ocelli
