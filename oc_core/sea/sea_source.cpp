#include "oc_core/sea/sea_source.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "oc_core/base/error.h"
#include "oc_core/sea/sea_format.h"

namespace ocelli {

std::string imageName(const std::vector<std::string>& names, size_t image) {
  return image < names.size() ? names[image] : fmt::format("image {}", image);
}

void validatePoses(const std::vector<SeaPose>& poses, const std::vector<std::string>& names, const std::string& where) {
  if (poses.empty()) {
    throw InputError("there are no images", where, "a sea takes at least one");
  }
  if (poses.size() > sea::kMaxImages) {
    throw InputError(fmt::format("there are {} images; a sea has at most {}", poses.size(), sea::kMaxImages), where,
                     "part them into several seas");
  }
  constexpr double kMost = 1e9;
  std::map<std::tuple<double, double, double>, size_t> taken;
  for (size_t i = 0; i < poses.size(); ++i) {
    const glm::dvec3& p = poses[i].position;
    const double length = glm::length(poses[i].worldFromCamera);
    if (!(std::abs(p.x) < kMost && std::abs(p.y) < kMost && std::abs(p.z) < kMost && std::abs(length - 1) < 1e-6)) {
      throw InputError(
          fmt::format("the pose of {} is none: numbers must be finite, and below 1e9", imageName(names, i)), where,
          "mend the pose, or leave the image out");
    }
    const auto [found, isNew] = taken.try_emplace({p.x, p.y, p.z}, i);
    if (!isNew) {
      throw InputError(
          fmt::format("{} and {} stand at the same place", imageName(names, found->second), imageName(names, i)), where,
          "leave one of them out");
    }
  }
}

}  // namespace ocelli
