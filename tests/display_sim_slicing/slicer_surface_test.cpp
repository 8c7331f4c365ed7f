// Slices of closed surfaces, by both slicers: watertight, and nowhere far from the surface.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "tests/display_sim_slicing/flood_fill.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::FloodFill;
using test::smallProfile;
using test::Voxel;

/// A closed mesh with what is known of its solid: the signed distance from its smooth surface, negative inside, and how
/// far the flat triangles lie inside of it at most.
struct Solid {
  const char* name;
  Mesh mesh;
  std::function<double(const glm::dvec3&)> distance;
  double sag = 0;
};

void PrintTo(const Solid& solid, std::ostream* out) {
  *out << solid.name;
}

Solid sphereSolid(const char* name, double radius, uint32_t rings, const glm::dvec3& center) {
  // A facet spans 180 / rings degrees both ways, so its middle is at least radius cos^2(90 degrees / rings) out.
  const double facet = std::cos(kPi / 2 / rings);
  return {name, test::sphere(radius, rings, center),
          [=](const glm::dvec3& p) { return glm::distance(p, center) - radius; }, radius * (1 - facet * facet)};
}

Solid torusSolid(const char* name, double ring, double tube, const glm::dvec3& center) {
  constexpr uint32_t kAcross = 90;
  constexpr uint32_t kAlong = 40;
  // Sagitta along the ring (at the outer rim) plus along the tube.
  const double sag = (ring + tube) * (1 - std::cos(kPi / kAcross)) + tube * (1 - std::cos(kPi / kAlong));
  return {name, test::torus(ring, tube, kAcross, kAlong, center),
          [=](const glm::dvec3& p) {
            const glm::dvec3 q = p - center;
            return std::hypot(std::hypot(q.x, q.z) - ring, q.y) - tube;
          },
          sag};
}

Solid boxSolid(const char* name, const glm::vec3& lower, const glm::vec3& upper) {
  return {name, test::box(lower, upper), [=](const glm::dvec3& p) {
            const glm::dvec3 past = glm::max(glm::dvec3(lower) - p, p - glm::dvec3(upper));
            return std::max({past.x, past.y, past.z});
          }};
}

using SliceFunction = Volume (*)(const Mesh&, const DisplayProfile&, const SliceOptions&);

class ClosedSolids : public ::testing::TestWithParam<std::tuple<Solid, SliceFunction>> {
 protected:
  const Solid& solid_ = std::get<0>(GetParam());
  const DisplayProfile profile_ = smallProfile(48, 80, 80);
  const SweepGeometry sweep_{profile_};
  const Volume volume_ = std::get<1>(GetParam())(solid_.mesh, profile_, {});
};

TEST_P(ClosedSolids, areWatertight) {
  const FloodFill flood(volume_);
  size_t inside = 0;
  size_t leaks = 0;
  size_t walledOff = 0;
  for (int i = 0; i < profile_.slicesPerHalfTurn; ++i) {
    for (int row = 0; row < profile_.height; ++row) {
      for (int column = 0; column < profile_.width; ++column) {
        const Voxel voxel{i, column, row};
        if (volume_.colorBits(i, column, row) != 0) {
          continue;
        }
        const double distance = solid_.distance(sweep_.voxelCenter(i, column, row));
        if (distance < -solid_.sag) {
          ++inside;
          leaks += flood.reached(voxel) ? 1 : 0;
        } else if (distance > 0) {
          walledOff += flood.reached(voxel) ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(inside, 500u);
  EXPECT_EQ(leaks, 0u);
  EXPECT_EQ(walledOff, 0u);
}

/// The frame of a voxel: its centre at 0, its cell's sides as units. They are columnWidth along d_i, rowHeight along y
/// and, across, the arc |r| pi / N.
glm::dvec3 inVoxelFrame(const SweepGeometry& sweep, const Voxel& voxel, const glm::dvec3& p) {
  const glm::dvec2& direction = sweep.sectorDirection(voxel.slice);
  const glm::dvec3 offset = p - sweep.voxelCenter(voxel.slice, voxel.column, voxel.row);
  const double arc = std::abs(sweep.columnRadius(voxel.column)) * sweep.stepRadians();
  return {(offset.x * direction.x + offset.z * direction.y) / sweep.columnWidth(), offset.y / sweep.rowHeight(),
          (offset.z * direction.x - offset.x * direction.y) / arc};
}

double distanceToSegment(const glm::dvec3& a, const glm::dvec3& b) {
  const double t = std::clamp(-glm::dot(a, b - a) / std::max(glm::dot(b - a, b - a), 1e-300), 0.0, 1.0);
  return glm::length(a + (b - a) * t);
}

/// Of the origin from a triangle.
double distanceToTriangle(const std::array<glm::dvec3, 3>& t) {
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  double nearest = 1e300;
  bool within = true;
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec3& a = t[k];
    const glm::dvec3& b = t[(k + 1) % 3];
    nearest = std::min(nearest, distanceToSegment(a, b));
    within = within && glm::dot(glm::cross(b - a, -a), normal) >= 0;
  }
  return within && glm::length(normal) > 0 ? std::abs(glm::dot(t[0], glm::normalize(normal))) : nearest;
}

// A cell that holds a point of the surface has its centre at most (1/2, 1/2, 1/2) sides away, and (1/2, 1/2, 1) in the
// column at the axis, whose outer side is twice as long as its middle: 1.23 voxels. The bound to keep is 1.5.
TEST_P(ClosedSolids, litVoxelsLieWithinOneAndAHalfVoxelsOfTheSurface) {
  const Mesh& mesh = solid_.mesh;
  // 1.5 voxels in space: the longest side is the arc at the rim.
  const double reach = 1.5 * std::max({sweep_.columnWidth(), sweep_.rowHeight(), sweep_.stepRadians()});
  std::vector<Box> bounds;
  for (const glm::uvec3& t : mesh.triangles) {
    Box& box = bounds.emplace_back();
    box.add(mesh.positions[t.x]);
    box.add(mesh.positions[t.y]);
    box.add(mesh.positions[t.z]);
  }
  size_t lit = 0;
  double farthest = 0;
  for (int i = 0; i < profile_.slicesPerHalfTurn; ++i) {
    forEachLit(volume_, i, [&](int column, int row, unsigned) {
      const Voxel voxel{i, column, row};
      const glm::dvec3 center = sweep_.voxelCenter(i, column, row);
      double nearest = 1e300;
      for (size_t k = 0; k < bounds.size() && nearest > 1.23; ++k) {
        const glm::dvec3 past = glm::max(glm::dvec3(bounds[k].lower) - center, center - glm::dvec3(bounds[k].upper));
        if (std::max({past.x, past.y, past.z}) <= reach) {
          const glm::uvec3& t = mesh.triangles[k];
          nearest = std::min(nearest, distanceToTriangle({inVoxelFrame(sweep_, voxel, mesh.positions[t.x]),
                                                          inVoxelFrame(sweep_, voxel, mesh.positions[t.y]),
                                                          inVoxelFrame(sweep_, voxel, mesh.positions[t.z])}));
        }
      }
      ++lit;
      farthest = std::max(farthest, nearest);
    });
  }
  EXPECT_GT(lit, 2000u);
  EXPECT_LE(farthest, 1.5);
}

Voxel voxelOf(const SweepGeometry& sweep, const glm::dvec3& p) {
  const auto steps = std::lround(std::atan2(p.z, p.x) / sweep.stepRadians());
  const int sector = static_cast<int>(steps + sweep.sectors()) % sweep.sectors();
  const glm::dvec2& direction = sweep.sectorDirection(sector);
  const double right = (p.x * direction.x + p.z * direction.y) * sweep.columnsPerRadius() * sweep.sideOfSector(sector);
  return {sweep.sliceOfSector(sector), static_cast<int>(sweep.columnsPerRadius() + right),
          static_cast<int>(sweep.rowOfY(p.y))};
}

// The other direction. A point that lies on the border of cells up to rounding may find its neighbour lit instead,
// whose centre is as near.
TEST_P(ClosedSolids, surfacePointsLieWithinOneAndAHalfVoxelsOfALitOne) {
  const Mesh& mesh = solid_.mesh;
  test::PointSource source(5);
  double farthest = 0;
  size_t points = 0;
  for (size_t k = 0; points < 60000; k = (k + 1) % mesh.triangles.size(), ++points) {
    const glm::dvec3 a(mesh.positions[mesh.triangles[k].x]);
    const glm::dvec3 b(mesh.positions[mesh.triangles[k].y]);
    const glm::dvec3 c(mesh.positions[mesh.triangles[k].z]);
    const double s = source.uniform(0, 1);
    const double t = source.uniform(0, 1);
    const glm::dvec3 p = s + t <= 1 ? a + (b - a) * s + (c - a) * t : a + (b - a) * (1 - s) + (c - a) * (1 - t);
    const Voxel home = voxelOf(sweep_, p);
    double nearest = 1e300;
    for (int next = -1; next <= 1; ++next) {
      // Past the last slice comes the first, mirrored.
      const int slice = (home.slice + next + sweep_.slicesPerHalfTurn()) % sweep_.slicesPerHalfTurn();
      const bool mirrored = slice - home.slice != next;
      const int middle = mirrored ? profile_.width - 1 - home.column : home.column;
      for (int column = std::max(middle - 1, 0); column <= std::min(middle + 1, profile_.width - 1); ++column) {
        for (int row = std::max(home.row - 1, 0); row <= std::min(home.row + 1, profile_.height - 1); ++row) {
          if (volume_.colorBits(slice, column, row) != 0) {
            nearest = std::min(nearest, glm::length(inVoxelFrame(sweep_, {slice, column, row}, p)));
          }
        }
      }
    }
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LE(farthest, 1.5);
}

INSTANTIATE_TEST_SUITE_P(
    Slicer, ClosedSolids,
    ::testing::Combine(::testing::Values(sphereSolid("sphere", 0.9, 40, glm::dvec3(0)),
                                         sphereSolid("sphereBesideTheAxis", 0.4, 30, {0.37, 0.2, -0.11}),
                                         sphereSolid("sphereTouchingTheAxis", 0.4, 30, {-0.4, 0, 0}),
                                         torusSolid("torus", 0.6, 0.3, glm::dvec3(0)),
                                         torusSolid("torusThroughTheAxis", 0.4, 0.2, {0.37, 0.01, 0.1}),
                                         boxSolid("box", {-0.61f, -0.7f, -0.52f}, {0.55f, 0.66f, 0.7f}),
                                         boxSolid("boxOnCellBorders", {-0.5f, -0.75f, -0.25f}, {0.5f, 0.75f, 0.5f}),
                                         boxSolid("boxWithAnEdgeOnTheAxis", {0, -0.5f, 0}, {0.6f, 0.5f, 0.6f})),
                       ::testing::Values(&sliceExactly, &slice)),
    [](const auto& test) {
      return std::string(std::get<0>(test.param).name) + (std::get<1>(test.param) == &slice ? "_fast" : "_exact");
    });

}  // namespace
}  // namespace ocelli
