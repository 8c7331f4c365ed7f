#include "oc_core/relief/relief_picture.h"

#include <gtest/gtest.h>

#include "oc_core/base/parallel.h"
#include "oc_core/relief/relief_errors.h"
#include "oc_core/relief/relief_light.h"
#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

using test::oneTile;
using test::viewFrom;

std::shared_ptr<const PlainGeometry> groundAt(float y, float half = 3) {
  Mesh ground = makeBox({half, 0.01f, half});
  paint(ground, {0.4f, 0.4f, 0.4f});
  Mesh placed;
  append(placed, ground, placedAt({0, y - 0.01f, 0}));
  return std::make_shared<const PlainGeometry>(placed);
}

// Blocks of rays meet what each ray by itself meets at every cell: but for rays that touch an edge, as a block's are
// moved into a tile together, and so rounded differently.
TEST(ReliefPicture, isThatOfEveryRayAtEveryTile) {
  std::vector<ReliefTile> tiles{{0, placedAt({-0.4f, 0, 0}, 20), glm::vec3(1)},
                                {0, glm::scale(placedAt({0.5f, -0.2f, 0.3f}, 200), glm::vec3(0.5f)), glm::vec3(1)},
                                {0, placedAt({0.1f, 0.1f, -0.9f}, 70), glm::vec3(1)}};
  for (const char* way : {"cell", "spoc", "di"}) {
    const auto scene = std::make_shared<const ReliefScene>(
        ReliefScene::Objects{buildReliefObject(way, test::table(), 1200).object}, tiles);
    const ReliefRenderer renderer(scene, groundAt(-0.4f));
    for (const double elevation : {10.0, 60.0}) {
      const PinholeCamera camera(viewFrom(elevation), 60, 41);
      const ReliefPicture fast = renderer.draw(camera);
      const ReliefPicture slow = renderer.drawSlowly(camera);
      size_t others = 0;
      size_t shown = 0;
      for (size_t i = 0; i < fast.shown.size(); ++i) {
        shown += slow.shown[i] >= 0;
        others += fast.shown[i] != slow.shown[i] || std::abs(fast.z[i] - slow.z[i]) > 1e-4f;
      }
      EXPECT_GT(shown, 50u) << way;
      EXPECT_LE(others, 3u) << way;
    }
  }
}

// Depth of a box's front from a hand-placed eye, and of the ground behind it.
TEST(ReliefPicture, writesDepth) {
  const ReliefRenderer renderer(oneTile(buildReliefObject("cell", test::redBox(), 40'000).object), groundAt(-0.25f));
  View view;
  view.eye = {0, 0, 5};
  const PinholeCamera camera(view, 61, 61);
  const ReliefPicture picture = renderer.draw(camera);
  EXPECT_EQ(picture.shown(30, 30), 0);
  EXPECT_NEAR(picture.z(30, 30), 4.5f, 0.01f);
  EXPECT_EQ(picture.shown(0, 30), ReliefPicture::kNothing);
  EXPECT_EQ(picture.z(0, 30), 0);
  // The ground before the box, which stands on it.
  EXPECT_EQ(picture.shown(30, 40), ReliefPicture::kGeometry);
  EXPECT_LT(picture.z(30, 40), 4.5f);
}

// A tile that is sunk into the ground ends where the ground begins, and one behind another ends there too.
TEST(ReliefPicture, tilesMeetTheGroundAndEachOther) {
  const auto object = buildReliefObject("cell", test::redBox(), 40'000).object;
  const auto scene = std::make_shared<const ReliefScene>(
      ReliefScene::Objects{object},
      std::vector<ReliefTile>{{0, placedAt({0, 0, 0}), glm::vec3(1)}, {0, placedAt({0.6f, 0, 0}), glm::vec3(1)}});
  const ReliefRenderer renderer(scene, groundAt(0));
  const PinholeCamera camera(viewFrom(40), 160, 120);
  const ReliefPicture picture = renderer.draw(camera);
  size_t alone = 0;
  for (size_t i = 0; i < picture.shown.size(); ++i) {
    if (picture.shown[i] >= 0) {
      // Half sunk: nothing of it is seen under the ground.
      EXPECT_GT(picture.point[i].y, -0.01f);
      // They overlap from x = 0.1 to 0.5; beside that, and a few texels, each is alone.
      if (picture.point[i].x < 0.06f || picture.point[i].x > 0.54f) {
        EXPECT_EQ(picture.shown[i], picture.point[i].x < 0.3f ? 0 : 1) << picture.point[i].x;
        ++alone;
      }
    }
  }
  EXPECT_GT(alone, 1000u);
}

// The sun is in the direction of (0.45, 0.75, 0.85): the shadow of a box of height 0.5 over the ground ends 0.5 * 0.45
// / 0.75 to the left of it and 0.5 * 0.85 / 0.75 behind.
TEST(ReliefPicture, castsAndReceivesShadows) {
  const ReliefRenderer renderer(oneTile(buildReliefObject("cell", test::redBox(), 40'000).object), groundAt(-0.25f));
  View view;
  view.eye = {0, 8, 0.01f};
  view.target = {0, -0.25f, 0};
  view.fovVerticalDegrees = 25;
  const PinholeCamera camera(view, 200, 200);
  const ReliefPicture picture = renderer.draw(camera);
  const auto inShadow = [&](float x, float z) {
    const auto q = camera.project({x, -0.25f, z});
    EXPECT_TRUE(picture.z.contains(static_cast<int>(q->u), static_cast<int>(q->v)));
    return picture.inShadow(static_cast<int>(q->u), static_cast<int>(q->v)) != 0;
  };
  EXPECT_TRUE(inShadow(-0.6f, -0.8f));
  EXPECT_TRUE(inShadow(0, -1.0f));
  EXPECT_FALSE(inShadow(0, -1.15f));
  EXPECT_FALSE(inShadow(-0.85f, -0.5f));
  EXPECT_FALSE(inShadow(0.7f, 0));
  EXPECT_FALSE(inShadow(0, 0.7f));
  // The top of the box is lit.
  const auto top = camera.project({0, 0.25f, 0});
  EXPECT_EQ(picture.inShadow(static_cast<int>(top->u), static_cast<int>(top->v)), 0);
  EXPECT_NEAR(sunlitShade(directionToSun(), true), 1, 1e-6f);
  EXPECT_NEAR(sunlitShade(directionToSun(), false), 0.25f, 1e-6f);
}

TEST(ReliefPicture, theEyeMayStandInsideOfATile) {
  const ReliefRenderer renderer(oneTile(buildReliefObject("cell", test::redBox(), 20'000).object), nullptr);
  View view;
  view.eye = {0, 0, 0};
  view.target = {1, 0, 0};
  view.fovVerticalDegrees = 60;
  const ReliefPicture picture = renderer.draw(PinholeCamera(view, 40, 40));
  EXPECT_EQ(picture.shown(20, 20), 0);
  EXPECT_NEAR(picture.z(20, 20), 0.5f, 0.02f);
}

TEST(ReliefPicture, nothingIsDrawnOfNothing) {
  const PinholeCamera camera(viewFrom(30), 20, 10);
  const ReliefPicture none =
      ReliefRenderer(std::make_shared<const ReliefScene>(ReliefScene::Objects{}, std::vector<ReliefTile>{}), nullptr)
          .draw(camera);
  for (const glm::vec3& color : none.color) {
    EXPECT_EQ(color, reliefBackground());
  }
  // A tile behind the eye.
  const ReliefRenderer behind(oneTile(buildReliefObject("di", test::redBox(), 400).object, placedAt({0, 0, 50})),
                              nullptr);
  View view;
  EXPECT_EQ(behind.draw(PinholeCamera(view, 20, 10)).rays, 0u);
  // A picture of one pixel.
  EXPECT_EQ(ReliefRenderer(oneTile(buildReliefObject("di", test::redBox(), 400).object), nullptr)
                .draw(PinholeCamera(viewFrom(60), 1, 1))
                .shown(0, 0),
            0);
}

TEST(ReliefPicture, isTheSameWithAnyNumberOfThreads) {
  const ReliefRenderer renderer(oneTile(buildReliefObject("cell", test::table(), 4000).object), groundAt(-0.4f));
  const PinholeCamera camera(viewFrom(25), 120, 90);
  const ReliefPicture many = renderer.draw(camera);
  setThreadCount(1);
  const ReliefPicture one = renderer.draw(camera);
  setThreadCount(0);
  EXPECT_EQ(one.cost.steps(), many.cost.steps());
  for (size_t i = 0; i < one.color.size(); ++i) {
    ASSERT_EQ(one.color[i], many.color[i]);
    ASSERT_EQ(one.z[i], many.z[i]);
  }
}

}  // namespace
}  // namespace ocelli
