#include "study/tasks/frontmost_policy.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {
namespace {

constexpr int kLooks = 3;               ///< whose evidence is added up; a guess
constexpr double kCoveredSpread = 0.1;  ///< of the logarithm of how much of a thing shows; a guess
constexpr double kSizeSpread = 0.06;    ///< of the logarithm of a height, as in the task `nearer`; a guess
constexpr double kMaxFrontLookSeconds = 4;
constexpr double kFrontAgainSeconds = 4;

/// A thing in the picture, put together of its parts that show.
struct SeenThing {
  LandmarkShape shape = LandmarkShape::kSphere;
  LandmarkColor color = LandmarkColor::kOrange;
  double pixels = 0;
  glm::dvec2 lower{1e9};
  glm::dvec2 upper{-1e9};

  double height() const { return upper.y - lower.y; }
};

std::vector<SeenThing> thingsIn(const Percept& seen, const Vision& vision, const glm::dvec2& gaze) {
  std::vector<SeenThing> things;
  for (const Sighting& each : seen.objects) {
    if (!vision.notices(each, gaze)) {
      continue;
    }
    const auto isSame = [&](const SeenThing& thing) { return thing.shape == each.shape && thing.color == each.color; };
    auto found = std::find_if(things.begin(), things.end(), isSame);
    if (found == things.end()) {
      found = things.insert(things.end(), {each.shape, each.color, 0, glm::dvec2(1e9), glm::dvec2(-1e9)});
    }
    found->pixels += static_cast<double>(each.pixels);
    found->lower = glm::min(found->lower, each.lower);
    found->upper = glm::max(found->upper, each.upper);
  }
  std::stable_sort(things.begin(), things.end(),
                   [](const SeenThing& a, const SeenThing& b) { return a.pixels > b.pixels; });
  return things;
}

WholeShape measureWhole(LandmarkShape shape) {
  constexpr int kSide = 256;
  constexpr float kAway = 20;  // radii: nearly parallel rays
  Maze maze(1, 1);
  maze.cellSize = 1 / kLandmarkRadius;
  const Mesh mesh = makeLandmark(maze, {{0, 0}, shape, LandmarkColor::kOrange});
  const Box box = boundsOf(mesh);
  View view;
  view.target = box.center();
  view.eye = view.target + glm::vec3(0, 0, kAway);
  view.fovVerticalDegrees = 15;
  view.zNear = 1;
  view.zFar = 100;
  const FragmentImage seen = rasterize(PinholeCamera(view, kSide, kSide), mesh);
  int pixels = 0;
  int top = kSide;
  int bottom = -1;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (seen(x, y).covered()) {
        ++pixels;
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
  }
  OC_CHECK(bottom > top, "a landmark shows");
  const double height = bottom - top + 1;
  return {static_cast<double>(box.size().y), pixels / (height * height)};
}

}  // namespace

WholeShape wholeShape(LandmarkShape shape) {
  static const std::array<WholeShape, kLandmarkShapes.size()> kWhole = [] {
    std::array<WholeShape, kLandmarkShapes.size()> all;
    for (size_t i = 0; i < all.size(); ++i) {
      all[i] = measureWhole(kLandmarkShapes[i]);
    }
    return all;
  }();
  const auto at = std::find(kLandmarkShapes.begin(), kLandmarkShapes.end(), shape);
  return kWhole[static_cast<size_t>(at - kLandmarkShapes.begin())];
}

double FrontPolicy::think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (seen.views.empty() || seen.choices.size() != 2 || now < answersAgainAt_) {
    return 0;
  }
  if (!began_) {
    began_ = from;
    gaze_ = seen.views.front().center();
  }
  const std::vector<SeenThing> things = thingsIn(seen, vision_, gaze_);
  if (things.size() >= 2) {
    const bool inOrder = things[0].lower.x + things[0].upper.x < things[1].lower.x + things[1].upper.x;
    const std::array<const SeenThing*, 2> sides{&things[inOrder ? 0 : 1], &things[inOrder ? 1 : 0]};
    std::array<double, 2> front{};
    for (size_t i = 0; i < 2; ++i) {
      const WholeShape whole = wholeShape(sides[i]->shape);
      const double height = sides[i]->height();
      const double shows = std::log(sides[i]->pixels / (whole.areaOfHeight * height * height));
      front[i] = normal(random_, shows, kCoveredSpread) + normal(random_, std::log(height / whole.height), kSizeSpread);
    }
    evidence_.push_back(front[0] - front[1]);
    gaze_ = (things[0].lower + things[0].upper + things[1].lower + things[1].upper) / 4.0;
  } else if (!things.empty()) {
    gaze_ = (things[0].lower + things[0].upper) / 2.0;
  }
  if (evidence_.size() < kLooks && secondsOf(now - *began_) < kMaxFrontLookSeconds) {
    return 0;
  }
  double sum = 0;
  for (const double each : evidence_) {
    sum += each;
  }
  const HumanFactors& factors = vision_.factors();
  const bool isLeft = evidence_.empty() ? happens(random_, 0.5) : sum > 0;
  const bool slips = happens(random_, factors.slip);
  motor.tap(seen.choices[isLeft != slips ? 0 : 1].key,
            now + nanosecondsOf(factors.decideSeconds * normalWithin(random_, 1, 0.25, 0.4, 2.5)));
  answersAgainAt_ = now + nanosecondsOf(kFrontAgainSeconds);
  return 0;
}

}  // namespace ocelli
