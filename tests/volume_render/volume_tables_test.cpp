// What the renderer prepares: tables of optical depth, occupancy of bricks; and how places are lit.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/scene/shading.h"
#include "oc_core/volume_render/optical_table.h"
#include "oc_core/volume_render/volume_lighting.h"
#include "oc_core/volume_render/volume_occupancy.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

double integralUpTo(const OpticalTable& table, int entry) {
  const OpticalTable::Entry& e = table.entries()[static_cast<size_t>(entry)];
  return static_cast<double>(e.integral[0]) + static_cast<double>(e.rest[0]);
}

TEST(OpticalTable, keepsTheIntegralOfExtinction) {
  // From 10 to 30 the opacity of a length of 2 grows from 0 to 0.6: the integral of -ln(1 - o) / 2 over values.
  const OpticalTable table(TransferFunction({{10, {1, 0.5, 0}, 0}, {30, {1, 0.5, 0}, 0.6}}, 2), {0, 100});
  const double expected = 20 / 0.6 * (0.4 * std::log(0.4) + 0.6) / 2;
  const int last = OpticalTable::kEntries - 1;
  const double beyond = (last - (30 - table.firstValue()) * table.entriesByValue()) / table.entriesByValue();
  const double constant = -std::log(0.4) / 2 * beyond;
  // Between entries extinction is taken to be linear: 2043 of them, whose error shrinks with their square.
  EXPECT_NEAR(integralUpTo(table, last) / table.entriesByValue() - constant, expected, 1e-5);
  EXPECT_NEAR(static_cast<double>(table.entries().back().at[0]), -std::log(0.4) / 2, 1e-6);
  EXPECT_NEAR(static_cast<double>(table.entries().back().at[2]), -std::log(0.4) / 4, 1e-6) << "green";
}

TEST(OpticalTable, noPeakIsTooThinToBeSeen) {
  for (int i = 0; i < 20; ++i) {
    // A hundredth of an entry.
    const double value = 40 + 0.0047 * i;
    const double width = 0.0005;
    const TransferFunction peak({{0, {1, 0, 0}, 0},
                                 {value, {1, 0, 0}, 0},
                                 {value + width / 2, {1, 0, 0}, 1},
                                 {value + width, {1, 0, 0}, 0},
                                 {100, {1, 0, 0}, 0}},
                                2);
    const OpticalTable table(peak, {0, 100});
    EXPECT_FALSE(table.isEmpty(39, 41)) << value;
    EXPECT_TRUE(table.isEmpty(42, 99)) << value;
    // The integral of -ln(1 - o) from 0 to 1 is 1; the last ten-thousandth counts as its beginning, a loss of 1e-4.
    const double integral = integralUpTo(table, OpticalTable::kEntries - 1) / table.entriesByValue();
    EXPECT_NEAR(integral / (width / 2), 1 - 1e-4, 1e-6) << value;
  }
}

TEST(OpticalTable, aFaintValueBehindADenseOneIsNotLost) {
  // An extinction of 9.2, and behind it one of 1e-6: a sum of single precision could not hold the latter.
  const OpticalTable table(
      TransferFunction({{0, {1, 1, 1}, 1}, {50, {1, 1, 1}, 1}, {50, {1, 1, 1}, 1e-6}, {100, {1, 1, 1}, 1e-6}}, 1),
      {0, 100});
  const double step = integralUpTo(table, 1900) - integralUpTo(table, 1890);
  EXPECT_NEAR(step / 10, 1e-6, 1e-9);
}

TEST(OpticalTable, isEmptyWhereNothingIsSeen) {
  const OpticalTable table(
      TransferFunction(
          {{10, {1, 1, 1}, 0}, {20, {1, 1, 1}, 0.5}, {30, {1, 1, 1}, 0}, {60, {1, 1, 1}, 0}, {70, {1, 1, 1}, 1}}, 1),
      {0, 100});
  EXPECT_TRUE(table.isEmpty(0, 9));
  EXPECT_TRUE(table.isEmpty(-1e9, 9.5));
  EXPECT_FALSE(table.isEmpty(0, 11));
  EXPECT_TRUE(table.isEmpty(31, 59));
  EXPECT_FALSE(table.isEmpty(29, 29.5));
  EXPECT_FALSE(table.isEmpty(31, 61));
  EXPECT_FALSE(table.isEmpty(5, 59)) << "a peak lies within";
  EXPECT_FALSE(table.isEmpty(80, 1e9)) << "constant beyond the last";
}

TEST(VolumeOccupancy, distancesAreThoseOfTheNearestBrickThatShowsSomething) {
  constexpr int kEdge = VolumeBricks::kEdge;
  const glm::ivec3 bricks(7, 5, 6);
  const glm::ivec3 seen[] = {{1, 2, 0}, {6, 4, 5}};
  const VolumeScene scene = test::floatVolume(
      bricks * kEdge + 1, 1,
      [&](const glm::dvec3& p) {
        for (const glm::ivec3& brick : seen) {
          if (glm::distance(p, (glm::dvec3(brick) + 0.5) * double(kEdge)) < 1) {
            return 1;
          }
        }
        return 0;
      },
      TransferFunction({{0.5, {1, 1, 1}, 0}, {1, {1, 1, 1}, 1}}, 1));
  const VolumeOccupancy occupancy(VolumeBricks(*scene.volume), OpticalTable(scene.appearance.transfer, {0, 1}));
  ASSERT_EQ(occupancy.size(), bricks);
  for (int k = 0; k < bricks.z; ++k) {
    for (int j = 0; j < bricks.y; ++j) {
      for (int i = 0; i < bricks.x; ++i) {
        int nearest = 255;
        for (const glm::ivec3& brick : seen) {
          nearest = std::min(nearest, std::max({std::abs(brick.x - i), std::abs(brick.y - j), std::abs(brick.z - k)}));
        }
        EXPECT_EQ(occupancy.distances()[static_cast<size_t>((k * bricks.y + j) * bricks.x + i)], nearest)
            << i << ", " << j << ", " << k;
      }
    }
  }
}

TEST(VolumeLighting, lightsByTheFormula) {
  // A slope along j of a volume whose voxels are 0.5 wide in the scene: the normal is y.
  VolumeScene scene = test::floatVolume(
      glm::ivec3(10), 0.5, [](const glm::dvec3& p) { return 3 * p.y; }, test::everywhere(0.5, 1));
  scene.appearance.shading = {.isOn = true, .ambient = 0.2, .diffuse = 0.6, .specular = 0.3, .shininess = 8};
  const VolumeLighting lighting(scene, valueRange(*scene.volume));
  const glm::dvec3 gradient = lighting.indexGradientAt({4.3, 4.4, 4.5});
  EXPECT_NEAR(glm::distance(gradient, glm::dvec3(0, 3, 0)), 0, 1e-12);
  const glm::dvec3 l(directionToLight());
  const glm::dvec3 ray(0, 0, -1);
  const glm::dvec3 h = glm::normalize(l + glm::dvec3(0, 0, 1));
  const PlaceLight<double> light = lighting.at({4.3, 4.4, 4.5}, ray);
  EXPECT_NEAR(light.factor, 0.2 + 0.6 * l.y, 1e-6);
  EXPECT_NEAR(light.added, 0.3 * std::pow(h.y, 8), 1e-6);
  // At the faces the difference is that of the outermost voxels: half of it.
  EXPECT_NEAR(lighting.indexGradientAt({4, 9.4, 4}).y, 1.5, 1e-12);
}

TEST(VolumeLighting, aFlatFieldIsNotLit) {
  VolumeScene scene = test::floatVolume(
      glm::ivec3(10), 0.5, [](const glm::dvec3& p) { return p.x < 5 ? 0 : 1; }, test::everywhere(0.5, 1));
  scene.appearance.shading.isOn = true;
  const VolumeLighting lighting(scene, valueRange(*scene.volume));
  EXPECT_EQ(lighting.at({2, 5, 5}, {0, 0, -1}).factor, 1);
  EXPECT_EQ(lighting.at({2, 5, 5}, {0, 0, -1}).added, 0);
  EXPECT_NE(lighting.at({4.5, 5, 5}, {0, 0, -1}).factor, 1);
}

}  // namespace
}  // namespace ocelli
