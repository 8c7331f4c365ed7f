#include "oc_core/constructor/occluder_constructor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/constructor/object_boxes.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

const Box kBox{{-1, -3, -1}, {1, 3, 1}};

PinholeCamera viewFrom(const glm::vec3& eye, const glm::vec3& target = {0, 0, 0}) {
  View view;
  view.eye = eye;
  view.target = target;
  view.fovVerticalDegrees = 50;
  return {view, 160, 90};
}

GraphCamera aroundBox(const PinholeCamera& view, double shadow = 1) {
  OccluderOptions options;
  options.box = kBox;
  options.shadow = shadow;
  return buildOccluderCamera(options, {}, view);
}

/// Whether the ray of the point's image gets there without meeting the box.
template <Camera C>
bool sees(const C& camera, const glm::vec3& point) {
  const auto image = camera.project(point);
  if (!image) {
    return false;
  }
  const RayPath path = camera.rayPath({image->u, image->v});
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const glm::vec3 way = path[i + 1] - path[i];
    const float share = glm::dot(point - path[i], way) / glm::dot(way, way);
    const bool here = share >= 0 && share <= 1 && glm::distance(path[i] + way * share, point) < 1e-3f;
    if (meets(kBox, path[i], here ? point : path[i + 1])) {
      return false;
    }
    if (here) {
      return true;
    }
  }
  return false;
}

TEST(OccluderCamera, showsWhatIsBehindTheBox) {
  const PinholeCamera view = viewFrom({0, 0, 10});
  const GraphCamera camera = aroundBox(view);
  // The wedge behind the box ends a width of 2 behind its back, at z = -3.
  for (float z = -3.2f; z > -40; z -= 0.7f) {
    for (const float x : {-0.4f, -0.05f, 0.05f, 0.4f}) {
      EXPECT_FALSE(sees(view, {x, 0.3f, z})) << x << " " << z;
      EXPECT_TRUE(sees(camera, {x, 0.3f, z})) << x << " " << z;
    }
  }
  EXPECT_FALSE(sees(camera, {0, 0, -2}));
}

TEST(OccluderCamera, theWedgeIsAsLongAsAsked) {
  for (const double shadow : {0.5, 1.0, 3.0}) {
    const GraphCamera camera = aroundBox(viewFrom({0, 0, 10}), shadow);
    const auto end = static_cast<float>(-1 - 2 * shadow);
    EXPECT_TRUE(sees(camera, {0.001f, 0, end - 0.05f})) << shadow;
    EXPECT_FALSE(sees(camera, {0.001f, 0, end + 0.05f})) << shadow;
  }
}

TEST(OccluderCamera, showsTheSidesAndTheFrontOfTheBox) {
  const PinholeCamera view = viewFrom({0, 0, 10});
  const GraphCamera camera = aroundBox(view);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float z : {-0.9f, 0.0f, 0.9f}) {
      EXPECT_FALSE(sees(view, {side * 1.001f, 0, z}));
      EXPECT_TRUE(sees(camera, {side * 1.001f, 0, z})) << side << " " << z;
    }
  }
  EXPECT_TRUE(sees(camera, {0.5f, 0, 1.001f}));
  EXPECT_TRUE(sees(camera, {0, 0, 1.001f}));
}

TEST(OccluderCamera, isThePinholeBeforeTheSplit) {
  const PinholeCamera view = viewFrom({0, 0, 10});
  const GraphCamera camera = aroundBox(view);
  for (const glm::vec3& point : {glm::vec3(0, 0, 2), glm::vec3(1, -1, 4), glm::vec3(-2, 1, 3)}) {
    const auto mine = camera.project(point);
    const auto theirs = view.project(point);
    ASSERT_TRUE(mine && theirs);
    EXPECT_NEAR(mine->u, theirs->u, 1e-3);
    EXPECT_NEAR(mine->v, theirs->v, 1e-3);
  }
}

/// No point behind the box is on the free rays of two pixels: one half of the image shows what is left of the middle.
TEST(OccluderCamera, showsNothingTwice) {
  const GraphCamera camera = aroundBox(viewFrom({0, 0, 10}));
  for (float u = 1; u < 160; u += 0.5f) {
    const RayPath path = camera.rayPath({u, 45});
    bool blocked = false;
    for (size_t i = 0; i + 1 < path.size(); ++i) {
      blocked = blocked || meets(kBox, path[i], path[i + 1]);
    }
    if (!blocked) {
      EXPECT_GT((path.back().x) * (u - 80), 0) << u;
    }
  }
}

TEST(OccluderCamera, takesViewsFromAllSides) {
  Random random(8);
  size_t seen = 0;
  size_t built = 0;
  for (int i = 0; i < 300; ++i) {
    const double angle = random.inRange(0, 6.28f);
    const auto distance = static_cast<double>(random.inRange(5, 30));
    const glm::vec3 eye(glm::dvec3(std::cos(angle) * distance, random.inRange(-1, 2), std::sin(angle) * distance));
    const PinholeCamera view = viewFrom(eye, {random.inRange(-1, 1), 0, random.inRange(-1, 1)});
    const GraphCamera camera = aroundBox(view);
    ++built;
    const glm::vec3 way = -glm::normalize(glm::vec3(eye.x, 0, eye.z));
    const glm::vec3 behind = way * 8.0f + glm::vec3(-way.z, 0, way.x) * 0.05f;
    EXPECT_FALSE(sees(view, behind));
    seen += sees(camera, behind);
  }
  EXPECT_EQ(seen, built);
}

std::string errorOf(const OccluderOptions& options, const PinholeCamera& view, const GuidedScene& scene = {}) {
  try {
    buildOccluderCamera(options, scene, view);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OccluderCamera, boxesThatAreNotBeforeTheEyeAreRefused) {
  OccluderOptions options;
  options.box = kBox;
  EXPECT_EQ(errorOf(options, viewFrom({0, 0, 10})), "");
  EXPECT_THAT(errorOf(options, viewFrom({0, 0, 0.5f}, {0, 0, -5})), HasSubstr("in the box"));
  EXPECT_THAT(errorOf(options, viewFrom({0, 0, -10}, {0, 0, -20})), HasSubstr("behind the eye"));
  EXPECT_THAT(errorOf(options, viewFrom({0, 0, 10}, {20, 0, -5})), HasSubstr("not in view"));
}

TEST(OccluderCamera, objectsAreFoundByTheirNumber) {
  const GuidedScene scene = loadGuidedScene("builtin:boxes,count=1,floor=1");
  const PinholeCamera view = viewFrom({0, 0, 4});
  OccluderOptions options;
  EXPECT_THAT(errorOf(options, view, scene), HasSubstr("neither a box nor an object"));
  options.object = 7;
  EXPECT_THAT(errorOf(options, view, scene), HasSubstr("no object 7"));
  options.object = 1;
  EXPECT_EQ(buildOccluderCamera(options, scene, view).frusta().size(), 5u);
}

}  // namespace
}  // namespace ocelli
