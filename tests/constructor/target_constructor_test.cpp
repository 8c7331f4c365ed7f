#include "oc_core/constructor/target_constructor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

/// From (x, 0, 10) along -z.
PinholeCamera viewFrom(float x = 0) {
  View view;
  view.eye = {x, 0, 10};
  view.target = {x, 0, 0};
  view.fovVerticalDegrees = 60;
  return {view, 160, 90};
}

Box cube(const glm::vec3& center, float half) {
  return {center - half, center + half};
}

const Box kTarget = cube({0, 0, 0}, 0.5f);
/// Just before the target, and just large enough to hide it.
const Box kBefore{{-0.45f, -1, 1.8f}, {0.45f, 1, 2}};

TEST(BentCamera, isThePinholeWithoutABend) {
  EXPECT_TRUE(bentCamera(viewFrom(), kTarget, 0).bends().empty());
  EXPECT_TRUE(bentCamera(viewFrom(), cube({0, 0, 20}, 1), 1).bends().empty());  // behind the eye
}

TEST(BentCamera, bendsToTheSideThatFSays) {
  for (const double f : {-1.0, -0.3, 1e-4, 0.5, 1.0}) {
    const CurvedRayCamera camera = bentCamera(viewFrom(), kTarget, f);
    ASSERT_EQ(camera.bends().size(), 1u) << f;
    // Half of the distance of 10 at most, on the other side.
    EXPECT_LT(glm::distance(camera.bends()[0].beyond(), glm::dvec3(-5 * f, 0, 10)), 1e-5) << f;
    const RayPath middle = camera.rayPath({80, 45});
    EXPECT_GT((middle.back() - middle[middle.size() - 2]).x * f, 0) << f;
    // Straight for half of the way, and bent before the target.
    EXPECT_LT(camera.bends()[0].planes().from.height({0, 0, 5}), 1e-4) << f;
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(160, 0), glm::vec2(160, 90), glm::vec2(0, 90)}) {
      const RayPath path = camera.rayPath(corner);
      EXPECT_GE(path[path.size() - 2].z, 10 - 0.81f * 10) << f;
    }
  }
}

TEST(BentCamera, changesSmoothlyWithF) {
  for (double f = -1; f < 1; f += 0.01) {
    const RayPath one = bentCamera(viewFrom(), kTarget, f).rayPath({30, 60});
    const RayPath other = bentCamera(viewFrom(), kTarget, f + 0.01).rayPath({30, 60});
    // The viewpoint moves by 0.05 m, 4 m before the middle of the bend: the direction by 0.0125 at most.
    EXPECT_LT(glm::distance(glm::normalize(one.back() - one[one.size() - 2]),
                            glm::normalize(other.back() - other[other.size() - 2])),
              0.0135f)
        << f;
  }
}

TEST(BentCamera, takesAnyViewAndTarget) {
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    View view;
    view.eye = {random.inRange(-3, 3), 0, random.inRange(2, 10)};
    view.fovVerticalDegrees = random.inRange(5, 120);
    view.centerShift = {random.inRange(-1, 1), 0};
    const glm::vec3 target(random.inRange(-3, 3), random.inRange(-3, 3), random.inRange(-9, 12));
    EXPECT_NO_THROW(bentCamera({view, 160, 90}, cube(target, 0.1f), random.inRange(-1, 1)));
  }
}

TEST(VisibleShare, countsWhatIsFree) {
  const CurvedRayCamera pinhole(viewFrom());
  EXPECT_EQ(visibleShare(pinhole, {}, kTarget), 1);
  EXPECT_EQ(visibleShare(pinhole, std::vector{kBefore}, kTarget), 0);
  EXPECT_EQ(visibleShare(pinhole, std::vector{cube({0, 0, -4}, 2)}, kTarget), 1);  // behind it
  const Box half{{0, -1, 4}, {1, 1, 5}};
  EXPECT_DOUBLE_EQ(visibleShare(pinhole, std::vector{half}, kTarget), 0.5);
  EXPECT_EQ(visibleShare(pinhole, {}, cube({0, 0, 12}, 0.5f)), 0);  // behind the eye
  EXPECT_EQ(visibleShare(pinhole, {}, cube({30, 0, 0}, 0.5f)), 0);  // out of the image
}

TEST(TargetTracker, bendsOnlyWhereItMust) {
  TargetTracker tracker({});
  EXPECT_EQ(tracker.wanted(viewFrom(), {}, kTarget), 0);
  const double f = tracker.wanted(viewFrom(), std::vector{kBefore}, kTarget);
  EXPECT_NE(f, 0);
  EXPECT_GE(visibleShare(bentCamera(viewFrom(), kTarget, f), std::vector{kBefore}, kTarget), 0.5);
  // A little less does not do.
  EXPECT_LT(visibleShare(bentCamera(viewFrom(), kTarget, f * 0.8), std::vector{kBefore}, kTarget), 0.5);
}

TEST(TargetTracker, givesUpWhereNothingHelps) {
  const std::vector<Box> cage{{{-9, -9, 8}, {9, 9, 8.5f}}};
  TargetTracker tracker({});
  EXPECT_EQ(tracker.wanted(viewFrom(), cage, kTarget), 0);
  EXPECT_TRUE(tracker.update(viewFrom(), cage, kTarget).bends().empty());
}

/// Runs frames of `scene(t)`, t from 0 to 1; f never moves by more than the cap. Returns in how many of the frames the
/// target is in sight of the camera, and of the pinhole.
template <class Frame>
std::pair<int, int> track(const Frame& frame, int frames) {
  const TargetOptions options;
  TargetTracker tracker(options);
  std::pair<int, int> visible{0, 0};
  for (int i = 0; i < frames; ++i) {
    const auto [view, occluders, target] = frame(static_cast<float>(i) / static_cast<float>(frames - 1));
    const double before = tracker.f();
    const CurvedRayCamera camera = tracker.update(view, occluders, target);
    EXPECT_LE(std::abs(tracker.f() - before), options.maxChange + 1e-12);
    EXPECT_LE(std::abs(tracker.f()), options.maxF);
    visible.first += visibleShare(camera, occluders, target) >= options.visibleShare;
    visible.second += visibleShare(CurvedRayCamera(view), occluders, target) >= options.visibleShare;
  }
  return visible;
}

struct Frame {
  PinholeCamera view;
  std::vector<Box> occluders;
  Box target;
};

constexpr int kFrames = 400;
const Box kWide{{-0.6f, -1, 1.8f}, {0.6f, 1, 2}};

TEST(TargetTracker, followsAMovingTarget) {
  const auto [camera, pinhole] = track(
      [](float t) {
        return Frame{viewFrom(), {kWide}, cube({2 * t - 1, 0, 0}, 0.5f)};
      },
      kFrames);
  EXPECT_GE(camera, pinhole + 20);  // all, but for the frames in which rays swing to f
}

TEST(TargetTracker, followsWhileTheViewMoves) {
  const auto [camera, pinhole] = track(
      [](float t) {
        return Frame{viewFrom(3 * t - 1.5f), {kWide}, kTarget};
      },
      kFrames);
  EXPECT_GE(camera, pinhole + 20);
}

TEST(TargetTracker, followsWhileAnOccluderPasses) {
  const auto [camera, pinhole] = track(
      [](float t) {
        return Frame{viewFrom(), {{{2 * t - 1.6f, -1, 1.8f}, {2 * t - 0.4f, 1, 2}}}, kTarget};
      },
      kFrames);
  EXPECT_GE(camera, pinhole + 20);
}

TEST(TargetTracker, returnsToThePinhole) {
  TargetTracker tracker({});
  for (int i = 0; i < 40; ++i) {
    tracker.update(viewFrom(), std::vector{kBefore}, kTarget);
  }
  ASSERT_NE(tracker.f(), 0);
  for (int i = 0; i < 25; ++i) {
    tracker.update(viewFrom(), {}, kTarget);
  }
  EXPECT_EQ(tracker.f(), 0);
}

std::string targetError(const TargetOptions& options, const PinholeCamera& view) {
  try {
    buildTargetCamera(options, {}, view);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TargetCamera, bendsAroundNamedOccluders) {
  TargetOptions options;
  options.box = kTarget;
  options.occluders = {kBefore};
  EXPECT_EQ(buildTargetCamera(options, {}, viewFrom()).bends().size(), 1u);
  options.maxF = 0;
  EXPECT_TRUE(buildTargetCamera(options, {}, viewFrom()).bends().empty());
}

TEST(TargetCamera, aTargetThatCannotBeSeenIsRefused) {
  EXPECT_THAT(targetError({}, viewFrom()), HasSubstr("no target"));
  TargetOptions options;
  options.box = cube({0, 0, 10}, 1);
  EXPECT_THAT(targetError(options, viewFrom()), HasSubstr("in the box"));
  options.box = cube({0, 0, 14}, 1);
  EXPECT_THAT(targetError(options, viewFrom()), HasSubstr("behind the eye"));
}

}  // namespace
}  // namespace ocelli
