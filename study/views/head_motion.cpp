#include "study/views/head_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "display_sim/observing/eye_path.h"
#include "display_sim/observing/observer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/json_fields.h"
#include "study/task/task.h"

namespace ocelli {
namespace {

constexpr int kMaxImages = 241;
constexpr int kUsualImages = 41;
constexpr double kMaxSwayDegrees = 60;
constexpr double kUsualSwaySeconds = 4;
constexpr size_t kMaxPoses = 10000;

enum class SwayAxis : uint8_t { kHorizontal, kVertical };
constexpr std::array kSwayAxes{SwayAxis::kHorizontal, SwayAxis::kVertical};
const char* nameOf(SwayAxis axis) {
  return axis == SwayAxis::kHorizontal ? "horizontal" : "vertical";
}

int readImages(JsonFields& fields) {
  return fields.integer("images", 3, kMaxImages, kUsualImages);
}

}  // namespace

const char* nameOf(MadeAt madeAt) {
  return madeAt == MadeAt::kRest ? "rest" : "each";
}

HeadMotion HeadMotion::read(JsonFields& fields, const DisplayProfile& profile) {
  HeadMotion motion;
  const int images = readImages(fields);
  if (fields.has("poses")) {
    const nlohmann::json& list = fields.value("poses");
    if (list.is_array() && list.size() > kMaxPoses) {
      fields.fail("poses", fmt::format("has {} poses, but at most {} are read", list.size(), kMaxPoses));
    }
    const std::vector<EyePose> poses =
        eyePathFromJson(nlohmann::json{{"poses", list}}.dump(), fmt::format("{}, \"poses\"", fields.where()));
    motion.seconds_ = poses.back().seconds - poses.front().seconds;
    if (motion.seconds_ <= 0) {
      fields.fail("poses", "must be two or more, at different times");
    }
    for (int i = 0; i < images; ++i) {
      motion.eyes_.push_back(eyeAt(poses, poses.front().seconds + i * motion.seconds_ / (images - 1)));
      if (isInDisplay(motion.eyes_.back(), profile)) {
        fields.fail("poses", "take the eye into the display; they are in radii of the display, which is 1");
      }
    }
    return motion;
  }
  if (images % 2 == 0) {
    fields.fail("images",
                fmt::format("is {}, but must be odd, so that one of them is that of the eye at rest", images));
  }
  const double sway = radiansFromDegrees(fields.number("sway_degrees", 0.1, kMaxSwayDegrees));
  motion.seconds_ = fields.number("seconds", 0.5, 60, kUsualSwaySeconds);
  motion.vertical_ = fields.choiceOf("axis", kSwayAxes, SwayAxis::kHorizontal) == SwayAxis::kVertical;
  for (int i = 0; i < images; ++i) {
    motion.offsets_.push_back(sway * (2.0 * i / (images - 1) - 1));
  }
  return motion;
}

size_t HeadMotion::poseCount() const {
  return std::max<size_t>(1, std::max(offsets_.size(), eyes_.size()));
}

glm::vec3 HeadMotion::eyeOf(size_t pose, const glm::vec3& rest) const {
  if (!eyes_.empty()) {
    return eyes_[pose];
  }
  if (offsets_.empty()) {
    return rest;
  }
  const double angle = offsets_[pose];
  const glm::dvec3 from(rest);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  if (vertical_) {
    // In the plane of the axis and the eye.
    const double out = std::hypot(from.x, from.z);
    const double outNow = cosine * out - sine * from.y;
    return {glm::dvec3(from.x * outNow / out, sine * out + cosine * from.y, from.z * outNow / out)};
  }
  return {glm::dvec3(cosine * from.x + sine * from.z, from.y, cosine * from.z - sine * from.x)};
}

size_t HeadMotion::poseAt(int64_t tick) const {
  if (!moves()) {
    return 0;
  }
  const double turns = static_cast<double>(tick) / static_cast<double>(kTicksPerSecond) / seconds_;
  const auto last = static_cast<double>(poseCount() - 1);
  const double share = eyes_.empty() ? (std::sin(2 * kPi * turns) + 1) / 2 : std::min(turns, 1.0);
  return static_cast<size_t>(std::lround(share * last));
}

}  // namespace ocelli
