#include "oc_core/soft_shadows/outline_visibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/soft_shadows/visibility_reference.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

using test::floorGrid;
using test::lightAbove;
using test::onFloor;
using test::plate;

std::vector<float> outlineShares(const Mesh& mesh, const AreaLight& light, const std::vector<ShadowReceiver>& receivers,
                                 int gridSide = 32) {
  return OutlineVisibility(mesh, light, {.gridSide = gridSide}).of(receivers).share;
}

/// Both look at the same samples of the light. Single precision tells the place of an edge to some 1e-6 of the light,
/// and there is a sample each 1e-3 along a row: where many edges pass, single samples differ.
void expectAsSlow(const Mesh& mesh, const AreaLight& light, const std::vector<ShadowReceiver>& receivers,
                  const char* what) {
  const std::vector<float> fast = outlineShares(mesh, light, receivers);
  size_t different = 0;
  for (size_t i = 0; i < receivers.size(); ++i) {
    const float slow = visibilitySlowly(mesh, light, receivers[i]);
    EXPECT_NEAR(fast[i], slow, 2.01f / 1024) << what << ", receiver " << i;
    different += fast[i] != slow;
  }
  EXPECT_LE(different, receivers.size() / 20) << what;
}

TEST(OutlineVisibility, seesAllWithoutOccluders) {
  for (const float share : outlineShares({}, lightAbove(), floorGrid(5, 2))) {
    EXPECT_EQ(share, 1);
  }
}

// An occluder that is the half plane x < 0 at half of the height: from (x, 0) the part of the light with
// x' > -x is free.
TEST(OutlineVisibility, ofAHalfPlaneIsLinear) {
  const Mesh half = plate(-100, 0, -100, 100, 2);
  for (const float x : {-1.2f, -0.9f, -0.5f, -0.01f, 0.0f, 0.3f, 0.77f, 0.999f, 1.3f}) {
    const float exact = std::clamp((1 + x) / 2, 0.0f, 1.0f);
    // An edge across the rows passes a sample each 1 / 32 in each of them, at 32 different places.
    EXPECT_NEAR(outlineShares(half, lightAbove(), {onFloor(x, 0.1f)})[0], exact, 1.0f / 512) << x;
  }
  const Mesh across = plate(-100, 100, -100, 0, 2);
  for (const float z : {-0.4f, -0.1f, 0.2f, 0.45f}) {
    // An edge along the rows passes all samples of one at once.
    EXPECT_NEAR(outlineShares(across, lightAbove(), {onFloor(0, z)})[0], 0.5f + z, 0.5f / 32 + 1e-4f) << z;
  }
}

// A plate of w x h at half of the height hides 2w x 2h of the light from below its middle.
TEST(OutlineVisibility, ofAPlateIsItsShare) {
  const Mesh mesh = plate(-0.3f, 0.3f, -0.1f, 0.1f, 2);
  EXPECT_NEAR(outlineShares(mesh, lightAbove(), {onFloor(0, 0)})[0], 1 - 1.2f * 0.4f / 2, 2.0f / 32);
  const float disc = outlineShares(mesh, lightAbove(true, 2, 2), {onFloor(0, 0)})[0];
  EXPECT_NEAR(disc, 1 - 1.2f * 0.4f / 3.14159f, 2.0f / 32);
}

// Two plates over each other hide no more than the larger; two beside each other hide both of their shares.
TEST(OutlineVisibility, countsWhatOverlapsOnce) {
  const AreaLight light = lightAbove();
  Mesh both = plate(-0.2f, 0.2f, -0.1f, 0.1f, 2);
  const float one = outlineShares(both, light, {onFloor(0, 0)})[0];
  append(both, plate(-0.05f, 0.05f, -0.03f, 0.03f, 1));
  EXPECT_EQ(outlineShares(both, light, {onFloor(0, 0)})[0], one);
}

TEST(OutlineVisibility, isThatOfTheSlowReference) {
  const std::vector<ShadowReceiver> receivers = floorGrid(9, 1.6f);
  expectAsSlow(test::randomBoxes(12, 1), lightAbove(), receivers, "boxes");
  expectAsSlow(test::randomBoxes(12, 2), lightAbove(true, 1.5f, 1.5f), receivers, "boxes under a disc");
  expectAsSlow(test::randomTriangles(25, 3), lightAbove(), receivers, "triangles");
  expectAsSlow(test::randomTriangles(25, 4), lightAbove(false, 0.2f, 3), receivers, "a narrow light");
}

// Receivers among the occluders: these reach behind the planes of receivers, and the blocks of receivers extend.
TEST(OutlineVisibility, isThatOfTheSlowReferenceAmongOccluders) {
  Random random(5);
  std::vector<ShadowReceiver> receivers;
  for (int i = 0; i < 120; ++i) {
    const float x = random.inRange(-1.5f, 1.5f);
    const float y = random.inRange(0, 3);
    const float z = random.inRange(-1.5f, 1.5f);
    receivers.push_back({{x, y, z}, {0, 1, 0}});
  }
  expectAsSlow(test::randomBoxes(25, 6), lightAbove(), receivers, "boxes");
  expectAsSlow(test::randomTriangles(30, 7), lightAbove(), receivers, "triangles");
}

// Receivers on the occluders themselves, which hide the light from their own other side.
TEST(OutlineVisibility, isThatOfTheSlowReferenceOnOccluders) {
  const Mesh mesh = test::randomBoxes(10, 8);
  std::vector<ShadowReceiver> receivers;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3& a = mesh.positions[t.x];
    const glm::vec3& b = mesh.positions[t.y];
    const glm::vec3& c = mesh.positions[t.z];
    receivers.push_back({(a + b + c) / 3.0f, glm::normalize(glm::cross(b - a, c - a))});
  }
  expectAsSlow(mesh, lightAbove(), receivers, "on boxes");
}

// What lies behind the light, or reaches through its plane, hides only with what lies in front.
TEST(OutlineVisibility, cutsOccludersAtTheLight) {
  Mesh mesh = plate(-3, 3, -3, 3, 4.5f);
  EXPECT_EQ(outlineShares(mesh, lightAbove(), {onFloor(0, 0)})[0], 1);
  append(mesh, plate(-0.2f, 0.2f, -2, 2, 0),
         glm::rotate(glm::translate(glm::mat4(1), {1.5f, 4, 0}), 1.0f, glm::vec3(0, 0, 1)));
  expectAsSlow(mesh, lightAbove(), floorGrid(5, 2), "a plate through the plane of the light");
}

TEST(OutlineVisibility, ofDegenerateThingsIsClear) {
  const Mesh mesh = plate(-0.3f, 0.3f, -0.3f, 0.3f, 2);
  const AreaLight light = lightAbove();
  const float nan = std::nanf("");
  const std::vector<float> shares = outlineShares(mesh, light,
                                                  {{{0, 5, 0}, {0, 1, 0}},    // behind the light
                                                   {{0, 4, 0}, {0, 1, 0}},    // in its plane
                                                   {{0, 0, 0}, {0, -1, 0}},   // turned away
                                                   {{0, 0, 0}, {0, 0, 0}},    // without a normal
                                                   {{nan, 0, 0}, {0, 1, 0}},  // nowhere
                                                   {{0, 2, 0}, {0, 1, 0}}});  // on top of the occluder
  EXPECT_EQ(shares, (std::vector<float>{0, 0, 0, 0, 0, 1}));
  // A receiver inside of a closed box sees nothing.
  Mesh box;
  append(box, makeBox({0.2f, 0.2f, 0.2f}), glm::translate(glm::mat4(1), {0, 1, 0}));
  EXPECT_EQ(outlineShares(box, light, {{{0, 1, 0}, {0, 1, 0}}})[0], 0);
  EXPECT_TRUE(outlineShares(box, light, {}).empty());
  // Triangles without an area hide nothing.
  Mesh flat;
  flat.positions = {{-1, 2, 0}, {0, 2, 0}, {1, 2, 0}};
  flat.triangles = {{0, 1, 2}, {0, 0, 1}, {1, 1, 1}};
  EXPECT_EQ(outlineShares(flat, light, {onFloor(0, 0)})[0], 1);
}

// The shadow of a point is hard.
TEST(OutlineVisibility, ofAPointIsHard) {
  const Mesh mesh = plate(-0.3f, 0.3f, -0.3f, 0.3f, 2);
  const AreaLight point = lightAbove(false, 0, 0);
  EXPECT_EQ(outlineShares(mesh, point, {onFloor(0.5f, 0.5f), onFloor(0.599f, 0), onFloor(0.601f, 0), onFloor(0, 0.7f)}),
            (std::vector<float>{0, 0, 1, 1}));
}

TEST(OutlineVisibility, isTheSameWithAnyNumberOfThreads) {
  const Mesh mesh = test::randomBoxes(20, 9);
  const std::vector<ShadowReceiver> receivers = floorGrid(40, 1.8f);
  const OutlineVisibility visibility(mesh, lightAbove());
  const LightVisibility all = visibility.of(receivers);
  setThreadCount(1);
  const LightVisibility alone = visibility.of(receivers);
  setThreadCount(0);
  EXPECT_EQ(all.share, alone.share);
  EXPECT_EQ(all.estimatedError, alone.estimatedError);
  EXPECT_EQ(all.work.elements, alone.work.elements);
}

// Many half planes: what the samples of the light lose is what the estimate says on the whole, and never more than the
// cells that the edge crosses.
TEST(OutlineVisibility, saysWhatTheSamplesOfTheLightLose) {
  Random random(10);
  for (const int side : {8, 16, 32}) {
    double squares = 0;
    double expected = 0;
    int count = 0;
    for (int i = 0; i < 60; ++i) {
      const float angle = random.inRange(0, 6.28f);
      const float offset = random.inRange(-0.2f, 0.2f);
      Mesh half = plate(-100, 0, -100, 100, 0);
      // At half of the height, through (offset, 0), turned about the vertical.
      const glm::mat4 placed = glm::rotate(glm::translate(glm::mat4(1), {0, 2, 0}), angle, glm::vec3(0, 1, 0));
      Mesh turned;
      append(turned, plate(-100, offset, -100, 100, 0), placed);
      const OutlineVisibility visibility(turned, lightAbove(), {.gridSide = side});
      const LightVisibility found = visibility.of(std::vector<ShadowReceiver>{onFloor(0, 0)});
      // The exact share: with the light cut into many strips.
      constexpr int kStrips = 4000;
      double exact = 0;
      for (int strip = 0; strip < kStrips; ++strip) {
        const double z = (strip + 0.5) / kStrips - 0.5;
        // Free where x cos(angle) - z sin(angle) > 2 offset, for x from -1 to 1.
        const double c = std::cos(static_cast<double>(angle));
        const double bound = (2 * static_cast<double>(offset) + z * std::sin(static_cast<double>(angle))) / c;
        const double free = c > 0 ? (1 - std::clamp(bound, -1.0, 1.0)) / 2 : (std::clamp(bound, -1.0, 1.0) + 1) / 2;
        exact += free / kStrips;
      }
      const double error = static_cast<double>(found.share[0]) - exact;
      EXPECT_LE(std::abs(error), (2.0 * side - 1) / (side * side)) << side << " " << i;
      squares += error * error;
      expected += static_cast<double>(found.estimatedError[0]) * static_cast<double>(found.estimatedError[0]);
      ++count;
    }
    // Rows that are shifted against each other do better than chance.
    EXPECT_LE(std::sqrt(squares / count), 1.2 * std::sqrt(expected / count)) << side;
    EXPECT_LE(std::sqrt(expected / count), 0.6 / std::pow(side, 1.5)) << side;
  }
}

}  // namespace
}  // namespace ocelli
