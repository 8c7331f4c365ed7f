#include "study/tasks/estimate_policy.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

constexpr double kJudgedDegrees = 2;         ///< from the gaze
constexpr double kMaxLookSeconds = 4;        ///< then it guesses
constexpr double kEstimateAgainSeconds = 4;  ///< where nothing came of an answer
/// One clicks on a mark of that size, pixels.
constexpr double kMarkPixels = 6;
constexpr double kMarkOnDial = 0.8;  ///< of its radius
/// Pieces of floor are to the sides from there on, by their distance ahead.
constexpr double kAsideShare = 0.1;

}  // namespace

double SeemingPlace::degrees() const {
  return withinTurn(degreesFromRadians(std::atan2(right, ahead)));
}

std::optional<double> seemingFocalPixels(const Percept& seen) {
  if (!seen.standing || seen.views.empty()) {
    return std::nullopt;
  }
  const WalkerPose& eye = *seen.standing;
  const glm::dvec2 forward(std::sin(eye.headingRadians), -std::cos(eye.headingRadians));
  std::vector<double> focals;
  for (const FloorPatch& patch : seen.floor) {
    const glm::dvec2 way = patch.place - glm::dvec2(eye.x, eye.z);
    const double ahead = glm::dot(way, forward);
    const double right = glm::dot(way, glm::dvec2(-forward.y, forward.x));
    if (patch.straight && ahead > 0 && std::abs(right) > kAsideShare * ahead) {
      focals.push_back((patch.centroid.x - seen.views.front().center().x) * ahead / right);
    }
  }
  if (focals.empty()) {
    return std::nullopt;
  }
  const auto middle = focals.begin() + static_cast<std::ptrdiff_t>(focals.size() / 2);
  std::nth_element(focals.begin(), middle, focals.end());
  return *middle;
}

SeemingPlace seemingPlace(const Sighting& object, const PixelRect& view, double focalPixels, double eyeHeightMeters) {
  const double below = object.upper.y - view.center().y;  // where it stands on the floor
  const double far = focalPixels * eyeHeightMeters / kFarMeters;
  SeemingPlace place;
  place.ahead = focalPixels * eyeHeightMeters / std::max(below, far);
  place.right = place.ahead * (object.centroid.x - view.center().x) / focalPixels;
  return place;
}

double EstimatePolicy::think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (!seen.views.empty() && !estimate_) {
    judge(seen, from);
  }
  if ((seen.scale || seen.dial) && now >= answersAgainAt_) {
    const bool isHidden = seen.views.empty();
    if (!estimate_ && (isHidden || (began_ && secondsOf(now - *began_) > kMaxLookSeconds))) {
      // It saw nothing, and says anything.
      estimate_ = seen.scale ? seen.scale->least + uniform(random_) * (seen.scale->most - seen.scale->least)
                             : uniform(random_) * kDegreesOfTurn;
    }
    if (estimate_) {
      answer(seen, now, motor);
    }
  }
  return 0;
}

void EstimatePolicy::judge(const Percept& seen, int64_t from) {
  if (!began_) {
    began_ = from;
    gaze_ = seen.views.front().center();
  }
  const Sighting* largest = nullptr;
  for (const Sighting& each : seen.objects) {
    if (vision_.notices(each, gaze_) && (largest == nullptr || each.pixels > largest->pixels)) {
      largest = &each;
    }
  }
  if (largest == nullptr) {
    // What does not stand out from here may do so from elsewhere.
    const PixelRect& view = seen.views[random_.below(seen.views.size())];
    gaze_ = {view.left + uniform(random_) * view.width, view.top + uniform(random_) * view.height};
    return;
  }
  if (vision_.degrees(largest->centroid, gaze_) > kJudgedDegrees) {
    gaze_ = largest->centroid;
    return;
  }
  const PixelRect& view = seen.views[static_cast<size_t>(largest->view)];
  // Without a floor that tells, as if it were seen through a window in the place of the picture.
  const double focal = seemingFocalPixels(seen).value_or(degreesFromRadians(vision_.pixelsPerDegree()));
  estimate_ = estimateOf(seemingPlace(*largest, view, focal, eyeHeight_));
}

double EstimatePolicy::estimateOf(const SeemingPlace& place) {
  const HumanFactors& factors = vision_.factors();
  return asked_ == Asked::kMeters ? place.meters() * std::exp(normal(random_, 0, factors.lengthErrorShare))
                                  : withinTurn(place.degrees() + normal(random_, 0, factors.pointingErrorDegrees));
}

glm::dvec2 EstimatePolicy::markOf(const Percept& seen, double estimate) const {
  if (seen.scale) {
    const SeenScale& scale = *seen.scale;
    const double share = std::clamp((estimate - scale.least) / (scale.most - scale.least), 0.0, 1.0);
    // Within the scale, as a click beside it does nothing.
    return {std::clamp(scale.place.left + share * scale.place.width, scale.place.left + kMarkPixels,
                       scale.place.right() - kMarkPixels),
            scale.place.center().y};
  }
  const double angle = radiansFromDegrees(estimate);
  return seen.dial->place.center() +
         kMarkOnDial * seen.dial->place.width / 2 * glm::dvec2(std::sin(angle), -std::cos(angle));
}

void EstimatePolicy::answer(const Percept& seen, int64_t now, MotorModel& motor) {
  const HumanFactors& factors = vision_.factors();
  const int64_t decided = now + nanosecondsOf(factors.decideSeconds * normalWithin(random_, 1, 0.25, 0.4, 2.5));
  const int64_t there = motor.point(markOf(seen, *estimate_), kMarkPixels, decided);
  const int64_t clicked = there + nanosecondsOf(factors.clickSeconds);
  motor.click(clicked);
  motor.tap(Key::kEnter, clicked + nanosecondsOf(factors.reactionSeconds + factors.clickSeconds));
  answersAgainAt_ = now + nanosecondsOf(kEstimateAgainSeconds);
}

}  // namespace ocelli
