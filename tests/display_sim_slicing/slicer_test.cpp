// The fast slicer against the exact one, and what can be said of it by hand.
#include "display_sim/slicing/slicer.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <numeric>
#include <set>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/display_sim_slicing/volume_checks.h"

namespace ocelli {
namespace {

using test::addTriangle;
using test::smallProfile;

Mesh colored(Mesh mesh) {
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::clamp(glm::abs(p), 0.0f, 1.0f));
  }
  return mesh;
}

/// Triangles of all sizes, some beyond the display and some through its axis.
Mesh soup(int triangles) {
  test::PointSource source(3);
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const glm::vec3 a = source.point(1.1f);
    const float size = std::pow(10.0f, source.uniform(-3, 0));
    addTriangle(mesh, a, a + source.point(size), a + source.point(size));
  }
  return colored(mesh);
}

// What the exact slicer does not light is lit only where a sample lies next to the border of its cell. At most: 1e-4
// voxels by rounding, and as the next test says. On average over the sector it is a third of that, and a column's
// border is one in three of a voxel.
TEST(FastSlicer, lightsWhatTheExactOneLights) {
  const Mesh meshes[] = {test::sphere(0.9, 150), test::torus(0.6, 0.3, 300, 200),
                         test::sphere(0.4, 300, {0.37, 0.2, 0}), test::torus(0.4, 0.2, 60, 40, {0.37, 0.01, 0.1}),
                         soup(2000)};
  for (const Mesh& mesh : meshes) {
    const DisplayProfile profile = smallProfile(48, 96, 80);
    const Volume fast = slice(mesh, profile, {ColorReduction::kOccupancy});
    const Volume exact = sliceExactly(mesh, profile, {ColorReduction::kOccupancy});
    size_t outside = 0;
    for (int i = 0; i < fast.slices(); ++i) {
      forEachLit(fast, i, [&](int column, int row, unsigned bits) {
        outside += (bits & ~exact.colorBits(i, column, row)) != 0 ? 1 : 0;
      });
    }
    EXPECT_GT(fast.litVoxels(), exact.litVoxels() / 2);
    EXPECT_LE(static_cast<double>(outside), 1e-3 * static_cast<double>(fast.litVoxels()));
  }
}

// A column is measured along its slice. The fast slicer takes the distance from the axis, which is larger by
// W / 2 (1 - cos(pi / 2N)) columns where the rim meets the border of a sector: 0.0257 here, 0.0121 for the reference
// display.
TEST(FastSlicer, isNoFartherBesideTheExactOneThanTheSagOfASector) {
  const DisplayProfile profile = smallProfile(48, 96, 80);
  const SweepGeometry sweep(profile);
  const double sag = 48 * (1 - std::cos(kPi / 96));
  ASSERT_NEAR(sag, 0.0257, 1e-4);
  test::PointSource source(11);
  std::vector<glm::dvec3> points;
  Mesh mesh;
  for (int i = 0; i < 20000; ++i) {
    const auto angle = static_cast<double>(source.uniform(0, static_cast<float>(2 * kPi)));
    const auto radius = static_cast<double>(source.uniform(0.8f, 0.995f));
    const glm::vec3 p(radius * std::cos(angle), source.uniform(-0.95f, 0.95f), radius * std::sin(angle));
    constexpr float kTiny = 1e-6f;  // 5e-5 columns
    addTriangle(mesh, p, p + glm::vec3(kTiny, 0, 0), p + glm::vec3(0, kTiny, kTiny));
    points.emplace_back(p);
  }
  const Volume fast = slice(mesh, profile, {ColorReduction::kOccupancy});
  const Volume exact = sliceExactly(mesh, profile, {ColorReduction::kOccupancy});
  double farthest = 0;
  size_t extra = 0;
  for (int i = 0; i < fast.slices(); ++i) {
    forEachLit(fast, i, [&](int column, int row, unsigned) {
      if (exact.colorBits(i, column, row) != 0) {
        return;
      }
      ++extra;
      // How far the point is outside that lit this voxel, in voxels: the one that is the least.
      double nearest = 1e300;
      const glm::dvec2& direction = sweep.sectorDirection(i);
      for (const glm::dvec3& p : points) {
        const double rows = std::abs(p.y - sweep.rowCenterY(row)) / sweep.rowHeight();
        const double along = p.x * direction.x + p.z * direction.y;
        const double columns = std::abs(along - sweep.columnRadius(column)) / sweep.columnWidth();
        if (std::max(rows, columns) < 1) {
          const double across = p.z * direction.x - p.x * direction.y;
          const double steps = std::abs(std::atan(across / along)) / sweep.stepRadians();
          nearest = std::min(nearest, std::max({steps, columns, rows}) - 0.5);
        }
      }
      farthest = std::max(farthest, nearest);
    });
  }
  EXPECT_GT(extra, 20u);
  EXPECT_LE(farthest, sag + 2e-4) << "rounding, and the size of the triangles";
  EXPECT_GT(farthest, 0.8 * sag) << "some lie at the rim, next to the border of a sector";
}

TEST(FastSlicer, givesTheSameBytesWithAnyNumberOfThreads) {
  const DisplayProfile profile = smallProfile(20, 64, 64);
  const Mesh mesh = soup(9000);
  setThreadCount(1);
  const Volume one = slice(mesh, profile);
  for (const int threads : {2, 3, 8}) {
    setThreadCount(threads);
    EXPECT_EQ(slice(mesh, profile), one) << threads;
  }
  setThreadCount(0);
}

TEST(FastSlicer, givesTheSameBytesWithEveryInstructionSet) {
  const Mesh mesh = soup(9000);
  for (const int bits : {1, 3}) {
    DisplayProfile profile = smallProfile(20, 65, 64, SecondHalfTurn::kOwn);
    profile.colorBitsPerChannel = bits;
    const SliceOptions options{ColorReduction::kDither, true};
    const Volume best = slice(mesh, profile, options);
    std::set<std::string> names{sliceInstructionSet()};
    for (int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
      hwy::SetSupportedTargetsForTest(targets & -targets);
      names.insert(sliceInstructionSet());
      EXPECT_EQ(slice(mesh, profile, options), best) << sliceInstructionSet();
    }
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_GT(names.size(), 1u);
  }
}

// Triangles are sampled each by itself, whatever their neighbours.
TEST(FastSlicer, givesTheSameBytesInAnyOrderOfTriangles) {
  const DisplayProfile profile = smallProfile(20, 64, 64);
  Mesh mesh = soup(9000);
  mesh.colors.clear();
  append(mesh, test::torus(0.6, 0.3, 70, 50));
  Slicer slicer(profile);
  const Volume asGiven = slicer.slice(SliceMesh(mesh));
  EXPECT_EQ(slicer.slice(SliceMesh(orderedForSlicing(mesh))), asGiven);
}

TEST(FastSlicer, cutsOffWhatLiesOutside) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  EXPECT_EQ(slice(test::sphere(0.3, 8, {5, 0, 0}), profile).litVoxels(), 0u);
  EXPECT_EQ(slice(test::sphere(0.3, 8, {0, -5, 0}), profile).litVoxels(), 0u);
  EXPECT_EQ(slice(test::sphere(7, 8), profile).litVoxels(), 0u);
  Mesh huge;
  addTriangle(huge, {-1e30f, 0.3f, -1e30f}, {1e30f, 0.3f, -1e30f}, {0, 0.3f, 1e30f});
  EXPECT_EQ(slice(huge, profile), sliceExactly(huge, profile));
}

TEST(FastSlicer, sharedVolumesStayAsTheyAreAndTheirMemoryIsUsedAgain) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  const Mesh large = test::sphere(0.7, 40);
  const Mesh small = test::sphere(0.3, 40);
  Slicer slicer(profile);
  slicer.slice(SliceMesh(large));
  std::shared_ptr<const Volume> first = slicer.takeShared();
  const uint8_t* data = first->slice(0).data();
  slicer.slice(SliceMesh(small));
  const std::shared_ptr<const Volume> second = slicer.takeShared();
  EXPECT_EQ(*first, slice(large, profile));
  EXPECT_EQ(*second, slice(small, profile));
  // Nobody holds the first any more: its memory comes next, whatever is in it.
  first = nullptr;
  slicer.takeShared();
  EXPECT_EQ(slicer.slice(SliceMesh(small)).slice(0).data(), data);
  EXPECT_EQ(*slicer.takeShared(), *second);
}

TEST(FastSlicer, anEmptyMeshIsDark) {
  EXPECT_EQ(slice(Mesh(), smallProfile(10, 16, 16)).litVoxels(), 0u);
}

TEST(FastSlicer, cornersAloneLightNothing) {
  Mesh mesh;
  addTriangle(mesh, {0.3f, 0.3f, 0.3f}, {0.31f, 0.3f, 0.3f}, {0.3f, 0.31f, 0.3f});
  mesh.positions.push_back({-0.5f, -0.5f, -0.5f});  // of no triangle
  const Volume volume = slice(mesh, smallProfile(10, 16, 16));
  EXPECT_EQ(volume.litVoxels(), 1u);
}

TEST(FastSlicer, blackLightsNothingAndWhiteFully) {
  Mesh mesh = test::sphere(0.7, 40);
  for (const int bits : {1, 2, 8}) {
    DisplayProfile profile = smallProfile(10, 16, 16);
    profile.colorBitsPerChannel = bits;
    mesh.colors.assign(mesh.positions.size(), glm::vec3(1, 0, 1));
    const Volume volume = slice(mesh, profile);
    for (int i = 0; i < volume.slices(); ++i) {
      forEachLevel(volume, i, [&](int, int, const Rgb8& levels) {
        EXPECT_EQ(levels, Rgb8(volume.fullLevel(), 0, volume.fullLevel()));
      });
    }
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0));
    EXPECT_EQ(slice(mesh, profile).litVoxels(), 0u);
  }
}

// Light is kept in steps of 2^-15, thresholds too: the two slicers differ where a rest is as near to a threshold.
TEST(FastSlicer, dithersAsTheExactOneDoes) {
  Mesh mesh = test::torus(0.6, 0.3, 200, 100);
  mesh.colors.assign(mesh.positions.size(), glm::vec3(0.3f, 0.71f, 0.04f));
  for (const ColorReduction colors :
       {ColorReduction::kDither, ColorReduction::kBlueNoise, ColorReduction::kNearest, ColorReduction::kOccupancy}) {
    for (const int bits : {1, 2, 5, 8}) {
      DisplayProfile profile = smallProfile(30, 64, 64);
      profile.colorBitsPerChannel = bits;
      const Volume fast = slice(mesh, profile, {colors});
      const Volume exact = sliceExactly(mesh, profile, {colors});
      size_t voxels = 0;
      size_t differing = 0;
      for (int i = 0; i < fast.slices(); ++i) {
        forEachLevel(fast, i, [&](int column, int row, const Rgb8& levels) {
          ++voxels;
          differing += exact.levels(i, column, row) != levels ? 1 : 0;
        });
      }
      EXPECT_GT(voxels, 1000u);
      EXPECT_LE(static_cast<double>(differing), 1e-3 * (1 << bits) * static_cast<double>(voxels)) << bits;
    }
  }
}

TEST(FastSlicer, theSecondHalfTurnMirrorsTheFirst) {
  const Mesh mesh = test::torus(0.6, 0.3, 60, 40, {0.1, 0.05, -0.07});
  const Volume half = slice(mesh, smallProfile(11, 21, 18));
  const Volume whole = slice(mesh, smallProfile(11, 21, 18, SecondHalfTurn::kOwn));
  ASSERT_EQ(whole.slices(), 22);
  for (int i = 0; i < 11; ++i) {
    for (int row = 0; row < 18; ++row) {
      for (int column = 0; column < 21; ++column) {
        EXPECT_EQ(whole.colorBits(i, column, row), half.colorBits(i, column, row));
        EXPECT_EQ(whole.colorBits(i + 11, 20 - column, row), half.colorBits(i, column, row));
      }
    }
  }
}

/// A wall from radius 0.3 to 0.9 at an angle in steps.
Mesh wallAt(double steps, int slices) {
  const double t = steps * kPi / slices;
  const glm::vec3 out(static_cast<float>(std::cos(t)), 0, static_cast<float>(std::sin(t)));
  Mesh mesh;
  addTriangle(mesh, out * 0.3f + glm::vec3(0, -0.5f, 0), out * 0.9f + glm::vec3(0, -0.5f, 0),
              out * 0.9f + glm::vec3(0, 0.5f, 0));
  addTriangle(mesh, out * 0.3f + glm::vec3(0, -0.5f, 0), out * 0.9f + glm::vec3(0, 0.5f, 0),
              out * 0.3f + glm::vec3(0, 0.5f, 0));
  return mesh;
}

TEST(AngularAntialiasing, sharesTheLightOfASampleBetweenTwoSlices) {
  const int slices = 20;
  DisplayProfile profile = smallProfile(slices, 64, 64);
  profile.colorBitsPerChannel = 8;
  for (const double steps : {3.25, 3.75, 4.0, 19.7, 20.4, -0.4, 39.9}) {
    for (const auto& slicer : {&slice, &sliceExactly}) {
      const Volume volume = slicer(wallAt(steps, slices), profile, {ColorReduction::kDither, true});
      std::vector<double> light(static_cast<size_t>(slices));
      for (int i = 0; i < slices; ++i) {
        forEachLevel(volume, i, [&](int, int, const Rgb8& levels) {
          light[static_cast<size_t>(i)] = std::max(light[static_cast<size_t>(i)], levels.r / 255.0);
        });
      }
      const double lower = std::floor(steps);
      const auto sliceOf = [&](double sector) {
        return static_cast<size_t>(static_cast<int>(sector + 2 * slices) % slices);
      };
      // A level is a step of 1/255; dithering takes one of two. Angles have a precision of some 1e-4 steps.
      EXPECT_NEAR(light[sliceOf(lower)], 1 - (steps - lower), 1.1 / 255) << steps;
      EXPECT_NEAR(light[sliceOf(lower + 1)], steps - lower, 1.1 / 255) << steps;
      EXPECT_NEAR(std::accumulate(light.begin(), light.end(), 0.0), 1, 2.2 / 255) << steps;
    }
  }
}

/// Vertices of the part, which come last, are moved.
Mesh moved(Mesh mesh, size_t vertices, const glm::vec3& by) {
  for (size_t i = mesh.positions.size() - vertices; i < mesh.positions.size(); ++i) {
    mesh.positions[i] += by;
  }
  return mesh;
}

TEST(SlicerUpdate, givesWhatSlicingEverythingGives) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    for (const bool antialiased : {false, true}) {
      const DisplayProfile profile = smallProfile(60, 64, 64, half);
      const SliceOptions options{ColorReduction::kDither, antialiased};
      Mesh mesh = test::torus(0.6, 0.3, 200, 120);
      const Mesh part = test::sphere(0.1, 60, {0.6, 0, 0.1});
      append(mesh, part);
      mesh = colored(mesh);
      SliceMesh prepared(mesh);
      Slicer slicer(profile, options);
      slicer.slice(prepared);
      glm::vec3 by(0);
      for (const glm::vec3& step : {glm::vec3(0, 0.05f, 0.02f), glm::vec3(-0.1f, 0, -0.3f), glm::vec3(-0.5f, 0, 0),
                                    glm::vec3(0), glm::vec3(3, 0, 0), glm::vec3(-3, 0, 0.2f)}) {
        by += step;
        const Mesh now = moved(mesh, part.positions.size(), by);
        prepared.setPositions(now.positions);
        const Volume updated = slicer.update(prepared);
        EXPECT_EQ(updated, Slicer(profile, options).slice(prepared));
        EXPECT_EQ(slicer.slicesMade() == 0, step == glm::vec3(0));
      }
    }
  }
}

TEST(SlicerUpdate, makesOnlyTheSlicesThatChange) {
  const DisplayProfile profile = smallProfile(180, 64, 64);
  Mesh mesh = test::torus(0.6, 0.3, 200, 120);
  append(mesh, test::sphere(0.05, 60, {0.6, 0, 0.1}));
  mesh = orderedForSlicing(mesh);
  SliceMesh prepared(mesh);
  Slicer slicer(profile);
  slicer.slice(prepared);
  EXPECT_EQ(slicer.slicesMade(), 180);
  for (glm::vec3& p : mesh.positions) {
    p.y += glm::distance(p, glm::vec3(0.6f, 0, 0.1f)) < 0.051f ? 0.01f : 0.0f;
  }
  prepared.setPositions(mesh.positions);
  slicer.update(prepared);
  // A chunk of the sphere holds some of the ring beside it, too.
  EXPECT_GT(slicer.slicesMade(), 5);
  EXPECT_LT(slicer.slicesMade(), 120);
}

}  // namespace
}  // namespace ocelli
