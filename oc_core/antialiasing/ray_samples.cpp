#include "oc_core/antialiasing/ray_samples.h"

#include <algorithm>
#include <vector>

namespace ocelli {

Image<glm::vec3> raySampledImage(int width, int height, const std::function<RayPath(const glm::vec2&)>& rayPath,
                                 const RayScene& scene, const SamplePattern& pattern, const glm::vec3& background) {
  Image<glm::vec3> image(width, height);
  parallelFor(image.size(), 16, [&](size_t begin, size_t end) {
    constexpr size_t kPacket = 64;  // rays at a time: a path is large
    std::vector<RayPath> rays;
    std::vector<Fragment> fragments(kPacket);
    for (size_t pixel = begin; pixel < end; ++pixel) {
      const int x = static_cast<int>(pixel % static_cast<size_t>(width));
      const int y = static_cast<int>(pixel / static_cast<size_t>(width));
      const std::span<const float> u = pattern.u(x, y);
      const std::span<const float> v = pattern.v(x, y);
      glm::dvec3 sum(0);
      for (size_t first = 0; first < u.size(); first += kPacket) {
        rays.clear();
        for (size_t i = first; i < std::min(first + kPacket, u.size()); ++i) {
          rays.push_back(rayPath({static_cast<float>(x) + u[i], static_cast<float>(y) + v[i]}));
        }
        const std::span<Fragment> met = std::span(fragments).first(rays.size());
        scene.intersect(rays, met);
        for (const Fragment& each : met) {
          sum += each.covered() ? colorOf(each, scene.mesh()) : background;
        }
      }
      image[pixel] = glm::vec3(sum / static_cast<double>(u.size()));
    }
  });
  return image;
}

}  // namespace ocelli
