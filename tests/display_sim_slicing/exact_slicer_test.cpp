// What can be said of slices by hand.
#include "display_sim/slicing/exact_slicer.h"

#include <gtest/gtest.h>

#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::addTriangle;
using test::smallProfile;

Mesh rectangle(const glm::vec3& corner, const glm::vec3& side, const glm::vec3& otherSide) {
  Mesh mesh;
  addTriangle(mesh, corner, corner + side, corner + side + otherSide);
  addTriangle(mesh, corner, corner + side + otherSide, corner + otherSide);
  return mesh;
}

TEST(Slicer, aSurfaceInASlicePlaneLightsThatSliceAndTheAxis) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  // z = 0 is the plane of slice 0; x from -0.8 to 0.8 is columns 1.6 to 14.4, y from -0.3 to 0.6 rows 3.2 to 10.4.
  const Volume volume = sliceExactly(rectangle({-0.8f, -0.3f, 0}, {1.6f, 0, 0}, {0, 0.9f, 0}), profile);
  for (int i = 0; i < 10; ++i) {
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const bool inRows = row >= 3 && row <= 10;
        const bool inColumns = i == 0 ? column >= 1 && column <= 14 : column == 7 || column == 8;
        EXPECT_EQ(volume.colorBits(i, column, row), inRows && inColumns ? 7u : 0u) << i << " " << column << " " << row;
      }
    }
  }
}

TEST(Slicer, aSurfaceBetweenTwoSlicePlanesIsNotLost) {
  const int slices = 10;
  const DisplayProfile profile = smallProfile(slices, 16, 16);
  const double t = (3 + 0.499) * kPi / slices;
  const glm::vec3 along(static_cast<float>(std::cos(t)), 0, static_cast<float>(std::sin(t)));
  const Volume volume =
      sliceExactly(rectangle(along * 0.3f + glm::vec3(0, -0.3f, 0), along * 0.4f, {0, 0.5f, 0}), profile);
  for (int i = 0; i < slices; ++i) {
    EXPECT_EQ(volume.colorBits(i, 12, 8), i == 3 ? 7u : 0u) << i;
  }
}

TEST(Slicer, aFloorLightsOneRowOfEverySlice) {
  for (const int width : {16, 17}) {
    const DisplayProfile profile = smallProfile(9, width, 16);
    const Volume volume = sliceExactly(rectangle({-3, 0.3f, -3}, {6, 0, 0}, {0, 0, 6}), profile);
    EXPECT_EQ(volume.litVoxels(), static_cast<size_t>(9 * width));
    for (int i = 0; i < 9; ++i) {
      for (int column = 0; column < width; ++column) {
        EXPECT_EQ(volume.colorBits(i, column, 5), 7u);  // row 5 holds y from 0.25 to 0.375
      }
    }
  }
}

TEST(Slicer, aTriangleAcrossTheAxisLightsEverySectorAroundIt) {
  const DisplayProfile profile = loadProfile("perspecta");
  Mesh mesh;
  addTriangle(mesh, {1e-3f, 0.301f, 1.5e-3f}, {-1.2e-3f, 0.3f, 0.4e-3f}, {0.2e-3f, 0.3005f, -1e-3f});
  const Volume volume = sliceExactly(mesh, profile);
  const int row = static_cast<int>(SweepGeometry(profile).rowOfY(0.3004));
  for (int i = 0; i < profile.slicesPerHalfTurn; ++i) {
    EXPECT_NE(volume.colorBits(i, 383, row), 0u) << i;
    EXPECT_NE(volume.colorBits(i, 384, row), 0u) << i;
  }
}

TEST(Slicer, aVertexOrAnEdgeOnTheAxisTouchesEverySector) {
  const DisplayProfile profile = smallProfile(12, 16, 16);
  Mesh mesh;
  addTriangle(mesh, {0, 0.3f, 0}, {0.5f, 0.3f, 0.1f}, {0.5f, 0.3f, 0.2f});
  addTriangle(mesh, {0, -0.5f, 0}, {0, -0.7f, 0}, {-0.5f, -0.6f, 0.01f});
  const Volume volume = sliceExactly(mesh, profile);
  for (int i = 0; i < 12; ++i) {
    for (const int row : {5, 12, 13}) {  // y = 0.3 is row 5.6; -0.5 to -0.7 rows 12 to 13.6
      EXPECT_EQ(volume.colorBits(i, 7, row), 7u) << i;
      EXPECT_EQ(volume.colorBits(i, 8, row), 7u) << i;
    }
  }
}

TEST(Slicer, theWrapContinuesInTheMirroredColumn) {
  // A band at radius 0.7 around the angle of half a step below 0: half in slice 0, half in slice N - 1 on its other
  // side.
  const int slices = 10;
  const DisplayProfile profile = smallProfile(slices, 16, 16);
  const double step = kPi / slices;
  const auto at = [&](double steps, float y) {
    return glm::vec3(static_cast<float>(0.7 * std::cos(steps * step)), y,
                     static_cast<float>(0.7 * std::sin(steps * step)));
  };
  Mesh mesh;
  addTriangle(mesh, at(-0.9, 0.3f), at(-0.1, 0.3f), at(-0.1, 0.31f));
  addTriangle(mesh, at(9.1, -0.3f), at(9.9, -0.3f), at(9.9, -0.31f));
  const Volume volume = sliceExactly(mesh, profile);
  const int column = 13;  // r = 0.7 is column 13.6
  EXPECT_EQ(volume.litVoxels(), 4u);
  EXPECT_EQ(volume.colorBits(0, column, 5), 7u);
  EXPECT_EQ(volume.colorBits(slices - 1, 15 - column, 5), 7u);
  EXPECT_EQ(volume.colorBits(slices - 1, column, 10), 7u);
  EXPECT_EQ(volume.colorBits(0, 15 - column, 10), 7u);
}

TEST(Slicer, cutsOffWhatLiesOutside) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  EXPECT_EQ(sliceExactly(test::sphere(0.3, 8, {5, 0, 0}), profile).litVoxels(), 0u);
  EXPECT_EQ(sliceExactly(test::sphere(0.3, 8, {0, -5, 0}), profile).litVoxels(), 0u);
  EXPECT_EQ(sliceExactly(test::sphere(7, 8), profile).litVoxels(), 0u);
}

TEST(Slicer, blackLightsNothingAndFullWhiteEverything) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  Mesh mesh = test::sphere(0.7, 12);
  const Volume white = sliceExactly(mesh, profile);
  EXPECT_EQ(white, sliceExactly(mesh, profile, {ColorReduction::kOccupancy}));
  mesh.colors.assign(mesh.positions.size(), glm::vec3(0));
  EXPECT_EQ(sliceExactly(mesh, profile).litVoxels(), 0u);
  mesh.colors.assign(mesh.positions.size(), glm::vec3(1e-3f, 0, 0));
  const Volume red = sliceExactly(mesh, profile, {ColorReduction::kOccupancy});
  EXPECT_EQ(red.litVoxels(), white.litVoxels());
  EXPECT_EQ(white.colorBits(0, 13, 8), 7u);
  EXPECT_EQ(red.colorBits(0, 13, 8), 1u);
}

TEST(Slicer, severalSurfacesInAVoxelAddTheirBits) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  Mesh mesh = rectangle({-2, 0.3f, -2}, {4, 0, 0}, {0, 0, 4});
  mesh.colors.assign(mesh.positions.size(), glm::vec3(1, 0, 0));
  Mesh other = rectangle({-2, 0.31f, -2}, {4, 0, 0}, {0, 0, 4});
  other.colors.assign(other.positions.size(), glm::vec3(0, 0, 1));
  append(mesh, other);
  EXPECT_EQ(sliceExactly(mesh, profile).colorBits(3, 2, 5), 5u);
}

// The mean of dithered bits is the linear colour: a floor of colour c lights the share c of its voxels. An additive
// recurrence over n = 48 x 64 voxels strays by O(log n / n); 1 % is ten times that.
TEST(Slicer, ditheringKeepsTheMeanColor) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const DisplayProfile profile = smallProfile(48, 64, 16, half);
    for (const glm::vec3& color : {glm::vec3(0.1f, 0.5f, 0.93f), glm::vec3(0.02f, 0.25f, 0.7f)}) {
      Mesh mesh = rectangle({-3, 0.3f, -3}, {6, 0, 0}, {0, 0, 6});
      mesh.colors.assign(mesh.positions.size(), color);
      const Volume volume = sliceExactly(mesh, profile);
      glm::dvec3 sum(0);
      for (int i = 0; i < volume.slices(); ++i) {
        forEachLit(volume, i,
                   [&](int, int, unsigned bits) { sum += glm::dvec3(bits & 1u, bits >> 1 & 1u, bits >> 2); });
      }
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(sum[channel] / (volume.slices() * 64.0), color[channel], 0.01);
      }
    }
  }
}

TEST(Slicer, interpolatesColorsBetweenVertices) {
  // A floor whose red rises with x from 0 at -1 to 1 at +1. In slice 0 column x has the mean colour (x + 0.5) / 64;
  // over 8 columns and the slices next to slice 0 dithering leaves less than one part in twelve.
  const DisplayProfile profile = smallProfile(180, 64, 16);
  Mesh mesh = rectangle({-1, 0.3f, -1}, {2, 0, 0}, {0, 0, 2});
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.emplace_back((p.x + 1) / 2, 0, 0);
  }
  const Volume volume = sliceExactly(mesh, profile);
  for (int block = 0; block < 8; ++block) {
    double lit = 0;
    for (int i = 0; i < 12; ++i) {
      for (int column = 8 * block; column < 8 * block + 8; ++column) {
        lit += volume.colorBits(i, column, 5);
      }
    }
    EXPECT_NEAR(lit / 96, (block + 0.5) / 8, 1.0 / 12) << block;
  }
}

TEST(Slicer, ownSecondHalfTurnHoldsTheSameVoxelsMirrored) {
  const Mesh mesh = test::torus(0.6, 0.25, 30, 20);
  const Volume half = sliceExactly(mesh, smallProfile(11, 20, 18));
  const Volume whole = sliceExactly(mesh, smallProfile(11, 20, 18, SecondHalfTurn::kOwn));
  ASSERT_EQ(whole.slices(), 22);
  for (int i = 0; i < 11; ++i) {
    for (int row = 0; row < 18; ++row) {
      for (int column = 0; column < 20; ++column) {
        EXPECT_EQ(whole.colorBits(i, column, row), half.colorBits(i, column, row));
        EXPECT_EQ(whole.colorBits(i + 11, 19 - column, row), half.colorBits(i, column, row));
      }
    }
  }
}

TEST(Slicer, sameBytesWithAnyNumberOfThreads) {
  Mesh mesh = test::torus(0.55, 0.4, 150, 90, {0.04, 0, 0});
  test::PointSource source(3);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.colors.push_back(glm::abs(source.point(1)));
  }
  const DisplayProfile profile = smallProfile(60, 128, 128);
  setThreadCount(1);
  const Volume one = sliceExactly(mesh, profile);
  for (const int threads : {2, 8}) {
    setThreadCount(threads);
    EXPECT_EQ(sliceExactly(mesh, profile), one) << threads;
  }
  setThreadCount(0);
}

}  // namespace
}  // namespace ocelli
