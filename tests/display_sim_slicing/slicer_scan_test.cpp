// Slices of scanned objects that are closed surfaces, by both slicers. Needs the meshes in $OCELLI_DATA_DIR.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <random>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/euler_angles.hpp>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/display_sim_slicing/flood_fill.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::FloodFill;

/// Every edge, by the positions of its ends, has two triangles.
bool isClosed(const Mesh& mesh) {
  const auto less = [](const glm::vec3& a, const glm::vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::map<glm::vec3, int, decltype(less)> corners(less);
  std::map<std::pair<int, int>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    std::array<int, 3> corner{};
    for (int k = 0; k < 3; ++k) {
      corner[static_cast<size_t>(k)] =
          corners.emplace(mesh.positions[t[k]], static_cast<int>(corners.size())).first->second;
    }
    for (size_t k = 0; k < 3; ++k) {
      ++edges[std::minmax(corner[k], corner[(k + 1) % 3])];
    }
  }
  return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 2; });
}

double volumeInside(const Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]);
    sum += glm::dot(a, glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) / 6;
  }
  return std::abs(sum);
}

// A dark cell lies wholly inside or wholly outside of a closed surface where all cells that it touches are lit. So the
// cells that the flood does not reach hold no more than the solid, and together with the lit ones no less: unless there
// is a leak, which would drain the inside.
void expectWatertight(const Mesh& mesh, const SweepGeometry& sweep, const Volume& volume) {
  const FloodFill flood(volume);
  const DisplayProfile& profile = volume.profile();
  double unreached = 0;
  double lit = 0;
  for (int i = 0; i < profile.slicesPerHalfTurn; ++i) {
    for (int row = 0; row < profile.height; ++row) {
      for (int column = 0; column < profile.width; ++column) {
        const double cell =
            2 * std::abs(sweep.columnRadius(column)) * sweep.tanHalfStep() * sweep.columnWidth() * sweep.rowHeight();
        if (volume.colorBits(i, column, row) != 0) {
          lit += cell;
        } else if (!flood.reached({i, column, row})) {
          unreached += cell;
        }
      }
    }
  }
  const double inside = volumeInside(mesh);
  EXPECT_LE(unreached, inside);
  EXPECT_GE(unreached + lit, inside);
  EXPECT_GT(unreached, 0.5 * inside) << "most of the inside is dark";
}

/// Whether a point lies inside of a closed mesh: how often a ray from it passes the surface.
bool isInside(const Mesh& mesh, const glm::dvec3& point) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.31, 0.9, 0.017));
  int passes = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - point;
    const glm::dvec3 b = glm::dvec3(mesh.positions[t.y]) - point;
    const glm::dvec3 c = glm::dvec3(mesh.positions[t.z]) - point;
    const double ab = glm::dot(glm::cross(a, b), direction);
    const double bc = glm::dot(glm::cross(b, c), direction);
    const double ca = glm::dot(glm::cross(c, a), direction);
    const bool through = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    passes += through && glm::dot(a, normal) / glm::dot(direction, normal) > 0 ? 1 : 0;
  }
  return passes % 2 == 1;
}

// The flood ends where it does between cells that the surface touches: it stays out of all cells that lie wholly
// inside, and reaches all that lie wholly outside. (A cell at the end of a narrow crevice may be outside, and yet
// walled off by the cells that the surface touches on both sides.) No more than `kMaxOutside` of the lit cells are not
// of `exact`.
void expectAsTight(const Mesh& mesh, const SweepGeometry& sweep, const Volume& fast, const Volume& exact) {
  constexpr double kMaxOutside = 1e-3;
  const FloodFill flood(fast);
  const FloodFill exactFlood(exact);
  size_t leaks = 0;
  size_t walledOff = 0;
  size_t lit = 0;
  size_t outside = 0;
  for (int i = 0; i < exact.profile().slicesPerHalfTurn; ++i) {
    for (int row = 0; row < exact.height(); ++row) {
      for (int column = 0; column < exact.width(); ++column) {
        const bool fastLit = fast.colorBits(i, column, row) != 0;
        const bool exactLit = exact.colorBits(i, column, row) != 0;
        lit += fastLit ? 1 : 0;
        outside += fastLit && !exactLit ? 1 : 0;
        if (!exactLit && !fastLit) {
          const bool reached = flood.reached({i, column, row});
          const bool shouldBe = exactFlood.reached({i, column, row});
          leaks += reached && !shouldBe && isInside(mesh, sweep.voxelCenter(i, column, row)) ? 1 : 0;
          walledOff += !reached && shouldBe ? 1 : 0;
        }
      }
    }
  }
  EXPECT_EQ(leaks, 0u);
  EXPECT_EQ(walledOff, 0u);
  EXPECT_LE(static_cast<double>(outside), kMaxOutside * static_cast<double>(lit));
  ::testing::Test::RecordProperty("lit", static_cast<int>(lit));
  ::testing::Test::RecordProperty("outside", static_cast<int>(outside));
}

class Scans : public ::testing::TestWithParam<const char*> {};

TEST_P(Scans, areWatertight) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: this test needs its " << GetParam();
  }
  const Mesh mesh = loadScene(std::string(folder) + "/" + GetParam(), {.shading = Shading::kNone});
  ASSERT_TRUE(isClosed(mesh));
  const DisplayProfile profile = test::smallProfile(96, 256, 256);
  const SweepGeometry sweep(profile);
  const SliceOptions options{ColorReduction::kOccupancy};
  const Volume exact = sliceExactly(mesh, profile, options);
  expectWatertight(mesh, sweep, exact);
  expectAsTight(mesh, sweep, slice(mesh, profile, options), exact);
}

// Triangles from a part of a voxel to many voxels, in all directions.
TEST_P(Scans, areWatertightHoweverTheyAreTurned) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: this test needs its " << GetParam();
  }
  const Mesh scan = loadScene(std::string(folder) + "/" + GetParam(), {.shading = Shading::kNone});
  std::mt19937 engine(7);
  const auto angle = [&] { return static_cast<float>(engine() >> 8) * 0x1p-24f * static_cast<float>(2 * kPi); };
  for (const int side : {64, 150, 300}) {
    Mesh mesh;
    const glm::mat4 turned = glm::eulerAngleXYZ(angle(), angle(), angle());
    append(mesh, scan, turned);
    const DisplayProfile profile = test::smallProfile(side / 2, side, side);
    const SliceOptions options{ColorReduction::kOccupancy};
    expectAsTight(mesh, SweepGeometry(profile), slice(mesh, profile, options), sliceExactly(mesh, profile, options));
  }
}

INSTANTIATE_TEST_SUITE_P(Slicer, Scans, ::testing::Values("dragon.obj", "horse.obj"), [](const auto& test) {
  const std::string file = test.param;
  return file.substr(0, file.find('.'));
});

}  // namespace
}  // namespace ocelli
