// The fast slicer's guarantee, checked as it is claimed (triangle_strips.h): each point of a sampled triangle has a
// sample less than half a voxel away in each direction of the sweep, and nothing leaks through closed surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/slicer.h"
#include "display_sim/slicing/triangle_strips.h"
#include "oc_core/base/conventions.h"
#include "tests/display_sim_slicing/flood_fill.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/display_sim_slicing/triangle_samples.h"

namespace ocelli {
namespace {

using test::addTriangle;
using test::samplesOf;
using test::smallProfile;
using test::TriangleSamples;

/// Sectors, columns from the axis, rows.
using SweepPosition = std::array<double, 3>;

SweepPosition sweepPosition(const SweepGeometry& sweep, const glm::dvec3& p) {
  return {std::atan2(p.z, p.x) / sweep.stepRadians(), std::hypot(p.x, p.z) * sweep.columnsPerRadius(),
          sweep.rowOfY(p.y)};
}

glm::vec3 positionAt(const SweepGeometry& sweep, const SweepPosition& at) {
  const double angle = at[0] * sweep.stepRadians();
  const double radius = at[1] / sweep.columnsPerRadius();
  return glm::vec3(glm::dvec3(radius * std::cos(angle), sweep.halfHeight() * (1 - at[2] / (sweep.height() / 2.0)),
                              radius * std::sin(angle)));
}

/// The distance of a surface point to the nearest sample, in voxels, in the direction in which it is the largest.
class SampleDistance {
 public:
  SampleDistance(const SweepGeometry& sweep, const std::vector<glm::vec3>& samples) : sweep_(sweep) {
    for (const glm::vec3& p : samples) {
      samples_.push_back(sweepPosition(sweep, p));
    }
  }

  double of(const glm::dvec3& p) const {
    const SweepPosition at = sweepPosition(sweep_, p);
    double nearest = std::numeric_limits<double>::infinity();
    for (const SweepPosition& sample : samples_) {
      const double turns = std::abs(at[0] - sample[0]);
      nearest = std::min(nearest, std::max({std::min(turns, sweep_.sectors() - turns), std::abs(at[1] - sample[1]),
                                            std::abs(at[2] - sample[2])}));
    }
    return nearest;
  }

  /// The largest one of a triangle: on a lattice of `parts`, and uphill from its three farthest points.
  double largestOn(const std::array<glm::dvec3, 3>& corners, int parts) const {
    struct Candidate {
      double distance;
      double b;
      double c;
    };
    const auto distanceAt = [&](double b, double c) {
      return of(corners[0] + (corners[1] - corners[0]) * b + (corners[2] - corners[0]) * c);
    };
    std::vector<Candidate> candidates;
    for (int j = 0; j <= parts; ++j) {
      for (int i = 0; i + j <= parts; ++i) {
        const double b = static_cast<double>(i) / parts;
        const double c = static_cast<double>(j) / parts;
        candidates.push_back({distanceAt(b, c), b, c});
      }
    }
    std::partial_sort(candidates.begin(), candidates.begin() + 3, candidates.end(),
                      [](const Candidate& x, const Candidate& y) { return x.distance > y.distance; });
    double largest = 0;
    for (size_t k = 0; k < 3; ++k) {
      Candidate best = candidates[k];
      for (double step = 0.5 / parts; step > 1e-4 / parts;) {
        const Candidate before = best;
        for (const auto& [db, dc] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}) {
          const double b = before.b + db * step;
          const double c = before.c + dc * step;
          if (b >= 0 && c >= 0 && b + c <= 1 && distanceAt(b, c) > best.distance) {
            best = {distanceAt(b, c), b, c};
          }
        }
        step = best.distance > before.distance ? step : step / 2;
      }
      largest = std::max(largest, best.distance);
    }
    return largest;
  }

 private:
  const SweepGeometry& sweep_;
  std::vector<SweepPosition> samples_;
};

struct Coverage {
  double farthest = 0;
  size_t triangles = 0;  ///< that are sampled
  size_t samples = 0;
};

/// Every triangle by all samples of the mesh, or by its own alone.
Coverage coverageOf(const Mesh& mesh, const DisplayProfile& profile, bool byAll = false) {
  const SweepGeometry sweep(profile);
  const std::vector<TriangleSamples> samples = samplesOf(mesh, profile);
  std::vector<glm::vec3> all;
  for (const TriangleSamples& each : samples) {
    all.insert(all.end(), each.points.begin(), each.points.end());
  }
  Coverage coverage;
  for (size_t t = 0; t < samples.size(); ++t) {
    if (samples[t].foundExactly) {
      continue;
    }
    std::array<glm::dvec3, 3> corners;
    double span = 0;
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<size_t>(k)] = mesh.positions[mesh.triangles[t][k]];
    }
    const SweepPosition first = sweepPosition(sweep, corners[0]);
    for (const glm::dvec3& corner : corners) {
      const SweepPosition at = sweepPosition(sweep, corner);
      const double turns = std::abs(at[0] - first[0]);
      span = std::max(
          {span, std::min(turns, sweep.sectors() - turns), std::abs(at[1] - first[1]), std::abs(at[2] - first[2])});
    }
    const int parts = std::clamp(static_cast<int>(6 * span), 12, 90);
    const SampleDistance distance(sweep, byAll ? all : samples[t].points);
    coverage.farthest = std::max(coverage.farthest, distance.largestOn(corners, parts));
    coverage.samples += samples[t].points.size() - 3;
    ++coverage.triangles;
  }
  return coverage;
}

void expectCovered(const Mesh& mesh, const DisplayProfile& profile, double sampledShare) {
  const Coverage coverage = coverageOf(mesh, profile);
  ::testing::Test::RecordProperty("farthest", std::to_string(coverage.farthest));
  EXPECT_LT(coverage.farthest, 0.5);
  EXPECT_GE(static_cast<double>(coverage.triangles), sampledShare * static_cast<double>(mesh.triangles.size()));
  EXPECT_GT(coverage.samples, 0u);
}

std::vector<DisplayProfile> profiles() {
  return {loadProfile("perspecta"), smallProfile(48, 96, 80), smallProfile(9, 65, 50), smallProfile(360, 1024, 700)};
}

class SlicerSamples : public ::testing::TestWithParam<size_t> {
 protected:
  const DisplayProfile profile_ = profiles()[GetParam()];
  const SweepGeometry sweep_{profile_};

  /// A triangle given in the sweep, in sectors, columns and rows; left out where it leaves the display.
  void add(Mesh& mesh, const SweepPosition& a, const SweepPosition& b, const SweepPosition& c) const {
    for (const SweepPosition& p : {a, b, c}) {
      if (p[1] < 2.1 || p[1] > profile_.width / 2.0 - 0.1 || p[2] < 0.1 || p[2] > profile_.height - 0.1) {
        return;
      }
    }
    addTriangle(mesh, positionAt(sweep_, a), positionAt(sweep_, b), positionAt(sweep_, c));
  }
};

SweepPosition moved(const SweepPosition& from, const SweepPosition& by, double times) {
  return {from[0] + times * by[0], from[1] + times * by[1], from[2] + times * by[2]};
}

TEST_P(SlicerSamples, coverNeedlesAndSlivers) {
  const double rim = profile_.width / 2.0;
  const std::vector<SweepPosition> directions{{1, 0, 0},    {0, 1, 0},     {0, 0, 1},     {1, 1, 0},    {1, 0, -1},
                                              {0, 1, 1},    {1, 1, 1},     {-1, 1, 0.5},  {1, 1e-3, 0}, {1e-3, 1, 0},
                                              {0, 1e-3, 1}, {0.3, 1, 0.7}, {0.9, -0.2, 1}};
  Mesh mesh;
  for (const double radius : {3.0, 9.0, 17.0, 0.6 * rim, 0.95 * rim}) {
    for (size_t i = 0; i < directions.size(); ++i) {
      const SweepPosition from{17.3, radius, profile_.height / 2.0};
      const SweepPosition& across = directions[(i + 4) % directions.size()];
      for (const double length : {0.9, 1.02, 1.9, 3.3, 7.7, 21.0}) {
        for (const double width : {1e-4, 0.3, 0.74, 0.99, 1.4}) {
          for (const double foot : {0.0, 0.3, 0.5, 1.0}) {
            const SweepPosition to = moved(from, directions[i], length);
            add(mesh, from, to, moved(moved(from, directions[i], length * foot), across, width));
          }
        }
      }
    }
  }
  expectCovered(mesh, profile_, 0.4);
}

TEST_P(SlicerSamples, coverTrianglesThatSpanFewVoxels) {
  const double rim = profile_.width / 2.0;
  const double spans[] = {0.1, 0.5, 0.67, 0.69, 0.735, 0.745, 0.8, 0.99, 1.01, 1.3};
  Mesh mesh;
  for (const double radius : {2.2, 5.0, 16.2, 17.0, 0.9 * rim}) {
    for (const double x : spans) {
      for (const double y : spans) {
        for (const double z : spans) {
          // Each corner is the farthest in one direction; and one that is so in two.
          const SweepPosition at{3.7, radius, profile_.height / 2.0 + 0.31};
          add(mesh, moved(at, {x, 0, 0}, 1), moved(at, {0, y, 0}, 1), moved(at, {0, 0, z}, 1));
          add(mesh, at, moved(at, {x, y, 0}, 1), moved(at, {0, y, z}, 1));
        }
      }
    }
  }
  expectCovered(mesh, profile_, 0.5);
}

TEST_P(SlicerSamples, coverRandomTriangles) {
  test::PointSource source(11);
  Mesh mesh;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 a = source.point(0.7f);
    const float size = std::pow(10.0f, source.uniform(-3, -0.7f));
    const float narrowness = std::pow(10.0f, source.uniform(-3, 0));
    const glm::vec3 b = a + source.point(size);
    addTriangle(mesh, a, b, glm::mix(a, b, source.uniform(-0.5f, 1.5f)) + source.point(size * narrowness));
  }
  expectCovered(mesh, profile_, 0.3);
}

TEST_P(SlicerSamples, coverTrianglesNearTheAxis) {
  test::PointSource source(12);
  Mesh mesh;
  for (int i = 0; i < 2500; ++i) {
    const SweepPosition a{source.uniform(0, 400), 2.1 + 20 * std::pow(source.uniform(0, 1), 2.0f),
                          profile_.height / 2.0};
    const float size = std::pow(10.0f, source.uniform(-0.5f, 1));
    const auto near = [&]() -> SweepPosition {
      return {a[0] + source.uniform(-size, size), a[1] + source.uniform(-size, size),
              a[2] + source.uniform(-size, size)};
    };
    add(mesh, a, near(), near());
  }
  expectCovered(mesh, profile_, 0.2);
}

// Two triangles that share a side, one of them small or narrow: the points beside the side have a sample, too.
TEST_P(SlicerSamples, coverBothTrianglesOfASharedSide) {
  test::PointSource source(13);
  double farthest = 0;
  size_t sampled = 0;
  for (int i = 0; i < 8000; ++i) {
    const SweepPosition a{source.uniform(-5, 5), profile_.width / 2.0 * source.uniform(0.2f, 0.8f),
                          profile_.height * 0.5};
    const SweepPosition along{source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)};
    const float length = source.uniform(0.5f, i % 2 == 0 ? 2.5f : 6.0f);
    Mesh mesh;
    mesh.positions = {positionAt(sweep_, a), positionAt(sweep_, moved(a, along, length))};
    for (const float size : {source.uniform(-2.5f, -0.01f), source.uniform(0.1f, i % 2 == 0 ? 2.5f : 8.0f)}) {
      const SweepPosition foot = moved(a, along, length * source.uniform(0, 1));
      mesh.positions.push_back(
          positionAt(sweep_, moved(foot, {source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)}, size)));
    }
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    const Coverage coverage = coverageOf(mesh, profile_, true);
    farthest = std::max(farthest, coverage.farthest);
    sampled += coverage.triangles;
  }
  RecordProperty("farthest", std::to_string(farthest));
  EXPECT_LT(farthest, 0.5);
  EXPECT_GT(sampled, 5000u);
}

INSTANTIATE_TEST_SUITE_P(Displays, SlicerSamples, ::testing::Range(size_t{0}, profiles().size()), [](const auto& test) {
  const DisplayProfile profile = profiles()[test.param];
  return std::to_string(profile.slicesPerHalfTurn) + "_slices_" + std::to_string(profile.width) + "_columns";
});

TEST(TriangleStrips, samplesLieWithinTheTriangle) {
  const TriangleStrips strips;
  const uint32_t corners[3] = {0, 1, 2};
  for (int foot = 0; foot <= TriangleStrips::kFootSteps / 2; ++foot) {
    for (const int strip : {1, 2, 3, 7, 16}) {
      for (const int pieces : {1, 2, 3, 10, 32}) {
        const SampledTriangle triangle = strips.sampled(corners, TriangleStrips::pattern(strip, pieces, foot), 0);
        EXPECT_GE(triangle.samples, static_cast<uint32_t>(std::max(strip, pieces)));
        for (size_t i = triangle.firstWeight; i < triangle.firstWeight + triangle.samples; ++i) {
          const float b = strips.weightsOfB()[i];
          const float c = strips.weightsOfC()[i];
          EXPECT_GE(b, -1e-6f);
          EXPECT_GE(c, 0.0f);
          EXPECT_LE(b + c, 1 + 1e-6f);
        }
      }
    }
  }
}

/// A tetrahedron whose sides are divided where `source` says, so that triangles of all sizes share sides.
Mesh dividedTetrahedron(const std::array<glm::vec3, 4>& corners, test::PointSource& source) {
  Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  std::array<std::array<uint32_t, 4>, 4> middle{};
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = i + 1; j < 4; ++j) {
      middle[i][j] = middle[j][i] = static_cast<uint32_t>(mesh.positions.size());
      mesh.positions.push_back(glm::mix(corners[i], corners[j], source.uniform(0.02f, 0.98f)));
    }
  }
  for (const std::array<uint32_t, 3>& face : {std::array<uint32_t, 3>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
    const auto [a, b, c] = face;
    mesh.triangles.insert(mesh.triangles.end(), {{a, middle[a][b], middle[a][c]},
                                                 {middle[a][b], b, middle[b][c]},
                                                 {middle[a][c], middle[b][c], c},
                                                 {middle[a][b], middle[b][c], middle[a][c]}});
  }
  return mesh;
}

bool liesInside(const std::array<glm::vec3, 4>& corners, const glm::dvec3& p) {
  for (size_t k = 0; k < 4; ++k) {
    const glm::dvec3 a(corners[(k + 1) % 4]);
    const glm::dvec3 normal =
        glm::normalize(glm::cross(glm::dvec3(corners[(k + 2) % 4]) - a, glm::dvec3(corners[(k + 3) % 4]) - a));
    const double own = glm::dot(glm::dvec3(corners[k]) - a, normal);
    const double distance = glm::dot(p - a, normal) * (own > 0 ? 1 : -1);
    if (distance < 1e-6) {  // the rounding of positions
      return false;
    }
  }
  return true;
}

// The flood passes between voxels that share a face, from outside: it comes to no centre of a voxel within.
TEST(ClosedTetrahedra, doNotLeakFromFaceToFace) {
  test::PointSource source(14);
  size_t inside = 0;
  size_t leaks = 0;
  for (int i = 0; i < 150; ++i) {
    const DisplayProfile profile = smallProfile(20 + i % 30, 40 + i % 25, 44);
    const SweepGeometry sweep(profile);
    const float flatness = i % 3 == 0 ? 0.08f : 0.9f;
    std::array<glm::vec3, 4> corners;
    for (glm::vec3& corner : corners) {
      corner = source.point(0.66f);
    }
    corners[3] = glm::mix((corners[0] + corners[1] + corners[2]) / 3.0f, corners[3], flatness);
    const Mesh mesh = dividedTetrahedron(corners, source);
    const Volume volume = slice(mesh, profile, {ColorReduction::kOccupancy});
    const test::FloodFill flood(volume);
    for (int slice = 0; slice < profile.slicesPerHalfTurn; ++slice) {
      for (int row = 0; row < profile.height; ++row) {
        for (int column = 0; column < profile.width; ++column) {
          if (liesInside(corners, sweep.voxelCenter(slice, column, row))) {
            ++inside;
            leaks += flood.reached({slice, column, row}) ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(inside, 50000u);
  EXPECT_EQ(leaks, 0u);
}

}  // namespace
}  // namespace ocelli
