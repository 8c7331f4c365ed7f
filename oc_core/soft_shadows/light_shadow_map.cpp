#include "oc_core/soft_shadows/light_shadow_map.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {

LightShadowMap::LightShadowMap(const ReferenceImage& image, const LightFrame& frame)
    : center_(image.reference().centerPixels()), samples_(image.sampleCount()) {
  const PinholeCamera camera = image.reference();
  perSlope_ = {camera.focalPixels() * std::copysign(1.0f, glm::dot(camera.right(), frame.light().right)),
               camera.focalPixels() * std::copysign(1.0f, glm::dot(camera.down(), frame.light().up))};
  Image<float> depths(image.width(), image.height(), kNothing);
  for (size_t i = 0; i < depths.size(); ++i) {
    depths[i] = image.holds(i) ? image.t[i] : kNothing;
  }
  levels_.push_back(std::move(depths));
  while (levels_.back().width() > 1 || levels_.back().height() > 1) {
    const Image<float>& below = levels_.back();
    Image<float> level((below.width() + 1) / 2, (below.height() + 1) / 2, kNothing);
    for (int y = 0; y < below.height(); ++y) {
      for (int x = 0; x < below.width(); ++x) {
        float& least = level(x / 2, y / 2);
        least = std::min(least, below(x, y));
      }
    }
    levels_.push_back(std::move(level));
  }
}

View lightView(const AreaLight& light, const Mesh& cast, int width, int height, const std::string& where) {
  const LightFrame frame(light);
  constexpr double kMargin = 1.04;
  constexpr double kMaxTangent = 4;  // 152 degrees
  constexpr double kMinTangent = 1e-3;
  constexpr float kNearShare = 1e-3f;
  double tangent = kMinTangent;
  float farthest = 0;
  for (const glm::uvec3& t : cast.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      farthest = std::max(farthest, frame.fromWorld(cast.positions[t[corner]]).z);
    }
  }
  if (!(farthest > 0)) {
    throw InputError("nothing that casts shadows stands in front of the light", where,
                     "turn the light to it, or give other objects the role \"cast\"");
  }
  for (const glm::uvec3& t : cast.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p(frame.fromWorld(cast.positions[t[corner]]));
      if (p.z > static_cast<double>(kNearShare * farthest)) {
        tangent = std::max(tangent, std::max(std::abs(p.y), std::abs(p.x) * height / width) / p.z);
      }
    }
  }
  View view;
  view.eye = light.center;
  view.target = light.center + light.direction();
  view.up = light.up;
  view.zNear = kNearShare * farthest;
  view.zFar = 2 * farthest;
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(std::min(tangent * kMargin, kMaxTangent)));
  return view;
}

}  // namespace ocelli
