// The fast slicer against the definition: it lights all cells that the surface enters by more than rounding, and none
// that it misses by more than rounding.
#include "tests/display_sim_slicing/slicer_reference.h"

#include <gtest/gtest.h>

#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/display_sim_slicing/volume_checks.h"

namespace ocelli {
namespace {

using test::addTriangle;
using test::contains;
using test::PointSource;
using test::smallProfile;

/// `reach` is the largest coordinate, in display radii: the rounding bound grows with it.
void expectBracketed(const Mesh& mesh, const DisplayProfile& profile, double reach = 1) {
  const double rounding = kSliceRounding * std::max(reach, 1.0);
  const Volume fast = sliceExactly(mesh, profile);
  EXPECT_TRUE(contains(fast, sliceReference(mesh, profile, {.margin = -rounding}))) << "a cell is missing";
  EXPECT_TRUE(contains(sliceReference(mesh, profile, {.margin = rounding}), fast)) << "a cell is lit in vain";
}

/// The name says what is special about each.
struct NamedProfile {
  const char* name;
  DisplayProfile profile;
};

void PrintTo(const NamedProfile& named, std::ostream* out) {
  *out << named.name;
}

class Profiles : public ::testing::TestWithParam<NamedProfile> {};

TEST_P(Profiles, soupOfEverySize) {
  PointSource source(11);
  for (const float size : {0.02f, 0.2f, 1.5f}) {
    Mesh mesh;
    for (int i = 0; i < 150; ++i) {
      const glm::vec3 center = source.point(0.9f);
      addTriangle(mesh, center + source.point(size), center + source.point(size), center + source.point(size));
    }
    expectBracketed(mesh, GetParam().profile, 2.5);
  }
}

TEST_P(Profiles, evenLight) {
  PointSource source(17);
  Mesh mesh;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 center = source.point(0.9f);
    addTriangle(mesh, center + source.point(0.4f), center + source.point(0.4f), center + source.point(0.4f));
  }
  addTriangle(mesh, {0.1f, 0.2f, 0}, {0.7f, 0.3f, 0}, {0.1f, 0.2f, 0});  // without area
  for (const double radius : {0.3, 1.0}) {
    // A weight that rounds otherwise could cross a threshold, of which there are 2^23: none does here.
    const Volume fast = sliceExactly(mesh, GetParam().profile, {.evenLightRadius = radius});
    const auto reference = [&](double margin) {
      return sliceReference(mesh, GetParam().profile, {.margin = margin, .evenLightRadius = radius});
    };
    EXPECT_TRUE(contains(fast, reference(-2 * kSliceRounding))) << radius;
    EXPECT_TRUE(contains(reference(2 * kSliceRounding), fast)) << radius;
    EXPECT_NE(fast, sliceExactly(mesh, GetParam().profile)) << radius;
  }
}

TEST_P(Profiles, blueNoise) {
  Mesh mesh = test::torus(0.6, 0.25, 30, 20);
  mesh.colors.assign(mesh.positions.size(), {0.3f, 0.6f, 1.0f});
  const Volume fast = sliceExactly(mesh, GetParam().profile, {ColorReduction::kBlueNoise});
  const auto reference = [&](double margin) {
    return sliceReference(mesh, GetParam().profile, {.colors = ColorReduction::kBlueNoise, .margin = margin});
  };
  EXPECT_TRUE(contains(fast, reference(-kSliceRounding)));
  EXPECT_TRUE(contains(reference(kSliceRounding), fast));
}

TEST_P(Profiles, slivers) {
  PointSource source(12);
  Mesh mesh;
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 a = source.point(0.9f);
    const glm::vec3 b = source.point(0.9f);
    addTriangle(mesh, a, b, a + (b - a) * source.uniform(0, 1) + source.point(1e-5f));
  }
  expectBracketed(mesh, GetParam().profile);
}

TEST_P(Profiles, aroundTheAxis) {
  PointSource source(13);
  Mesh mesh;
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 onAxis(0, source.uniform(-0.9f, 0.9f), 0);
    const float size = i % 2 == 0 ? 0.3f : 0.003f;
    addTriangle(mesh, onAxis + source.point(size), onAxis + source.point(size), onAxis + source.point(size));
    addTriangle(mesh, onAxis, onAxis + source.point(size), onAxis + source.point(size));
  }
  expectBracketed(mesh, GetParam().profile);
}

TEST_P(Profiles, degenerateTriangles) {
  PointSource source(14);
  Mesh mesh;
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 a = source.point(0.9f);
    const glm::vec3 b = source.point(0.9f);
    addTriangle(mesh, a, a, a);
    addTriangle(mesh, a, b, a);
    addTriangle(mesh, a, b, (a + b) * 0.5f);
  }
  addTriangle(mesh, glm::vec3(0), glm::vec3(0), glm::vec3(0));
  addTriangle(mesh, {0, -0.5f, 0}, {0, 0.5f, 0}, {0, 0.2f, 0});
  expectBracketed(mesh, GetParam().profile);
}

TEST_P(Profiles, trianglesLargerThanTheDisplay) {
  PointSource source(15);
  for (const float size : {10.0f, 1e4f}) {
    Mesh mesh;
    for (int i = 0; i < 40; ++i) {
      // Planes through the display: two large sides from a point inside.
      const glm::vec3 inside = source.point(0.5f);
      const glm::vec3 u = source.point(size);
      const glm::vec3 v = source.point(size);
      addTriangle(mesh, inside - u - v, inside + u, inside + v);
    }
    expectBracketed(mesh, GetParam().profile, 4 * size);
  }
}

TEST_P(Profiles, closedSolids) {
  expectBracketed(test::sphere(0.83, 10, {0.01, 0.02, 0.03}), GetParam().profile);
  expectBracketed(test::torus(0.55, 0.3, 14, 9, {0.3, 0, 0.05}), GetParam().profile);
  expectBracketed(test::box({-0.71f, -0.6f, -0.33f}, {0.62f, 0.67f, 0.49f}), GetParam().profile);
}

INSTANTIATE_TEST_SUITE_P(SlicerReference, Profiles,
                         ::testing::Values(NamedProfile{"usual", smallProfile(12, 24, 20)},
                                           NamedProfile{"oddWidthAndSlices", smallProfile(9, 25, 16)},
                                           NamedProfile{"twoSlices", smallProfile(2, 12, 12)},
                                           NamedProfile{"ownSecondHalf",
                                                        smallProfile(5, 16, 14, SecondHalfTurn::kOwn)}),
                         ::testing::PrintToStringParamName());

// Where faces fall exactly on borders of cells that have an exact form, closed cells on both sides are lit, by both.
TEST(SlicerReference, facesOnCellBordersLightBothSides) {
  const DisplayProfile profile = smallProfile(12, 16, 16);
  Mesh mesh;
  addTriangle(mesh, {0.5f, 0.25f, 0}, {0.75f, 0.25f, 0}, {0.5f, 0.5f, 0});
  const Volume fast = sliceExactly(mesh, profile);
  EXPECT_EQ(fast, sliceReference(mesh, profile));
  EXPECT_EQ(fast.colorBits(0, 11, 4), 7u) << "left of r = 0.5, between columns 11 and 12";
  EXPECT_EQ(fast.colorBits(0, 14, 6), 7u) << "the corner (0.75, 0.25), between columns 13 and 14 and rows 5 and 6";
}

// Both colours are those of points of the triangle in the voxel, so they differ by at most the colour's change across a
// voxel; with red = height, by one row.
TEST(SlicerReference, colorsAgreeWithinAVoxel) {
  const DisplayProfile profile = smallProfile(16, 32, 32);
  Mesh mesh = test::sphere(0.9, 12);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.emplace_back((p.y + 1) / 2, 0, 0);
  }
  const Volume fast = sliceExactly(mesh, profile);
  const double row = 1.0 / 32;
  const auto moved = [&](double by) {
    Mesh other = mesh;
    for (glm::vec3& color : other.colors) {
      color.x += static_cast<float>(by);
    }
    return sliceReference(other, profile);
  };
  EXPECT_TRUE(contains(moved(row), fast));
  EXPECT_TRUE(contains(fast, moved(-row)));
  EXPECT_FALSE(contains(moved(-row), fast)) << "the colours had no effect";
}

}  // namespace
}  // namespace ocelli
