#include "display_sim/slicing/turn_about_axis.h"

#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kPointsAtOnce = 1 << 14;

glm::vec3 turnedBy(const glm::vec3& p, float cosine, float sine) {
  return {cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x};
}

}  // namespace

glm::vec3 turnedAboutAxis(const glm::vec3& point, double radians) {
  return turnedBy(point, static_cast<float>(std::cos(radians)), static_cast<float>(std::sin(radians)));
}

void turnAboutAxis(std::span<const glm::vec3> points, double radians, std::span<glm::vec3> turned) {
  OC_CHECK(points.size() == turned.size(), "a place for each point");
  const auto cosine = static_cast<float>(std::cos(radians));
  const auto sine = static_cast<float>(std::sin(radians));
  parallelFor(points.size(), kPointsAtOnce, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      turned[i] = turnedBy(points[i], cosine, sine);
    }
  });
}

}  // namespace ocelli
