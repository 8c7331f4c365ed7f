// Levels of detail of surfaces with rims, in scenes of several parts, and of a scan.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "oc_core/base/parallel.h"
#include "oc_core/pack/open_edges.h"
#include "oc_core/pack/place_bits.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;

/// A wavy sheet over the square of +-1 with an open rim, of 2 n^2 triangles.
Mesh wavySheet(int n) {
  Mesh sheet;
  const auto at = [n](int i) { return i == n ? 1.0f : 2 * static_cast<float>(i) / static_cast<float>(n) - 1; };
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      const float x = at(column);
      const float z = at(row);
      sheet.positions.emplace_back(x, 0.05f * std::sin(5 * x + 1) * std::cos(4 * z), z);
      if (row < n && column < n) {
        const auto a = static_cast<uint32_t>(row * (n + 1) + column);
        const auto below = a + static_cast<uint32_t>(n) + 1;
        sheet.triangles.emplace_back(a, below, below + 1);
        sheet.triangles.emplace_back(a, below + 1, a + 1);
      }
    }
  }
  return sheet;
}

bool isOnRim(const glm::vec3& p) {
  return std::abs(p.x) == 1 || std::abs(p.z) == 1;
}

/// Whether both lie on one side of the square.
bool isOnOneSide(const glm::vec3& a, const glm::vec3& b) {
  return (std::abs(a.x) == 1 && a.x == b.x) || (std::abs(a.z) == 1 && a.z == b.z);
}

struct Segment {
  glm::vec3 a;
  glm::vec3 b;
};

/// The open edges of a cut, whose clusters have vertices of their own at the same places.
std::vector<Segment> openSegments(const Mesh& mesh) {
  std::vector<uint32_t> indices;
  for (const glm::uvec3& t : mesh.triangles) {
    indices.insert(indices.end(), {t.x, t.y, t.z});
  }
  std::vector<Segment> segments;
  for (const OpenEdge& edge : openEdges(indices, placeNumbers(mesh.positions))) {
    segments.push_back({mesh.positions[edge.from], mesh.positions[edge.to]});
  }
  return segments;
}

float distanceTo(const Segment& segment, const glm::vec3& p) {
  const glm::vec3 along = segment.b - segment.a;
  const float t = std::clamp(glm::dot(p - segment.a, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::distance(p, segment.a + t * along);
}

class Levels : public testing::Test {
 protected:
  /// Of four parts and the whole.
  static void SetUpTestSuite() {
    shared_ = std::make_unique<Shared>();
    shared_->sheet = wavySheet(460);
    const int threads = threadCount();
    setThreadCount(1);
    EXPECT_GT(packScene(MeshSource(shared_->sheet), shared_->folder / "sheet.opack").parts, 2U);
    setThreadCount(threads);
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static const Mesh& sheet() { return shared_->sheet; }
  static std::filesystem::path pack() { return shared_->folder / "sheet.opack"; }
  static const TemporaryFolder& folder() { return shared_->folder; }

 private:
  struct Shared {
    TemporaryFolder folder;
    Mesh sheet;
  };
  static std::unique_ptr<Shared> shared_;
};
std::unique_ptr<Levels::Shared> Levels::shared_;

TEST_F(Levels, OfSeveralPartsAreTheSameForAnyNumberOfThreads) {
  packScene(MeshSource(sheet()), folder() / "again.opack");
  EXPECT_EQ(fileBytes(pack()), fileBytes(folder() / "again.opack"));
}

TEST_F(Levels, ASheetBecomesAsCoarseAsItsErrorAllows) {
  const PackedScene scene(pack());
  // Waves of 0.05, each some 1.3 long, bend by 0.05 (2 pi / 1.3)^2 = 1.2 at most. A chord of length s is off by
  // 1.2 s^2 / 8: by 0.001 with s = 0.08. That is 25 by 25 squares. Errors add up from step to step, and the largest of
  // a group counts for all of it: ten times as many triangles are allowed (14,400 where no group waits, 10,800 now).
  EXPECT_LT(meshOf(scene, coarsestClusters(scene, 1e-3f)).triangles.size(), 10 * 2 * 25 * 25U);
  EXPECT_LT(meshOf(scene, coarsestClusters(scene, 1e9f)).triangles.size(), 112U);
}

/// Where clusters meet, of any level and of any part, no edge is open.
TEST_F(Levels, CutsOfASheetAreOpenAlongItsRimAlone) {
  const PackedScene scene(pack());
  for (const float finest : {1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e9f}) {
    for (const glm::vec3& eye : {glm::vec3(0, 0, 0), glm::vec3(0.9f, 0, -0.3f)}) {
      const Mesh mesh = meshOf(scene, chooseClusters(
                                          scene, [](const Sphere&) { return true; },
                                          [&](const Sphere& sphere, float error) {
                                            const float away = glm::distance(sphere.center, eye) - sphere.radius;
                                            return error <= finest * (0.1f + 9 * std::max(0.0f, away));
                                          }));
      size_t cracks = 0;
      float around = 0;
      for (const Segment& segment : openSegments(mesh)) {
        cracks += isOnOneSide(segment.a, segment.b) ? 0 : 1;
        around += std::abs(segment.a.x - segment.b.x) + std::abs(segment.a.z - segment.b.z);
      }
      EXPECT_EQ(cracks, 0U) << finest;
      EXPECT_NEAR(around, 8, 1e-3f) << finest;
    }
  }
}

TEST_F(Levels, RimsStayWithinTheError) {
  const PackedScene scene(pack());
  for (const float error : {1e-4f, 1e-3f, 1e-2f}) {
    const std::vector<Segment> rim = openSegments(meshOf(scene, coarsestClusters(scene, error)));
    float worst = 0;
    for (const glm::vec3& p : sheet().positions) {
      if (isOnRim(p)) {
        float nearest = 1e9f;
        for (const Segment& segment : rim) {
          nearest = std::min(nearest, distanceTo(segment, p));
        }
        worst = std::max(worst, nearest);
      }
    }
    EXPECT_LE(worst, error * 1.001f + 1e-6f);
    // It became coarse, too: of chords as above (310, 100 and 31 of them) three times as many at most.
    EXPECT_LT(static_cast<float>(rim.size()), 3 * 8 / std::sqrt(8 * error / 1.2f)) << error;
  }
}

/// One vertex in three of a small patch stands out. Its groups cannot become coarser without an error as large, and
/// would pass that on to all that is made of them and what is smooth around.
TEST(RoughPatch, DoesNotHoldUpWhatIsSmooth) {
  constexpr float kRoughness = 0.02f;
  const TemporaryFolder folder;
  Mesh sheet = wavySheet(180);
  size_t rough = 0;
  for (size_t i = 0; i < sheet.positions.size(); ++i) {
    glm::vec3& p = sheet.positions[i];
    if (i % 3 == 0 && std::abs(p.x - 0.3f) < 0.12f && std::abs(p.z) < 0.12f) {
      p.y += kRoughness;
      ++rough;
    }
  }
  const PackedScene scene = test::packed(sheet, folder / "rough.opack");
  const Mesh mesh = meshOf(scene, coarsestClusters(scene, kRoughness / 4));
  size_t smooth = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) * (1.0f / 3);
    smooth += std::abs(middle.x - 0.3f) < 0.16f && std::abs(middle.z) < 0.16f ? 0 : 1;
  }
  ASSERT_GT(rough, 100U);
  // 6,000 where no group waits, 2,800 now.
  EXPECT_LT(smooth, 4'000U);
}

float distanceTo(const Mesh& mesh, const std::vector<Sphere>& spheres, const glm::vec3& p) {
  float nearest = 1e9f;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (glm::distance(spheres[i].center, p) - spheres[i].radius >= nearest) {
      continue;
    }
    const glm::uvec3& t = mesh.triangles[i];
    const glm::vec3& a = mesh.positions[t.x];
    const glm::vec3& b = mesh.positions[t.y];
    const glm::vec3& c = mesh.positions[t.z];
    nearest =
        std::min({nearest, distanceTo(Segment{a, b}, p), distanceTo(Segment{b, c}, p), distanceTo(Segment{c, a}, p)});
    // Inside of the three sides the plane is nearer.
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const bool isInside = glm::dot(glm::cross(b - a, p - a), normal) >= 0 &&
                          glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
                          glm::dot(glm::cross(a - c, p - c), normal) >= 0;
    if (isInside && glm::length(normal) > 0) {
      nearest = std::min(nearest, std::abs(glm::dot(p - a, normal)) / glm::length(normal));
    }
  }
  return nearest;
}

std::vector<Sphere> spheresOf(const Mesh& mesh) {
  std::vector<Sphere> spheres;
  for (const glm::uvec3& t : mesh.triangles) {
    spheres.push_back(
        aroundPoints(std::array<glm::vec3, 3>{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]}));
  }
  return spheres;
}

/// The largest distance of some points of a mesh to another: each `step`-th vertex, or the middles of triangles.
float farthestVertex(const Mesh& from, const Mesh& to, size_t step) {
  const std::vector<Sphere> spheres = spheresOf(to);
  float farthest = 0;
  for (size_t i = 0; i < from.positions.size(); i += step) {
    farthest = std::max(farthest, distanceTo(to, spheres, from.positions[i]));
  }
  return farthest;
}
float farthestMiddle(const Mesh& from, const Mesh& to, size_t step) {
  const std::vector<Sphere> spheres = spheresOf(to);
  float farthest = 0;
  for (size_t i = 0; i < from.triangles.size(); i += step) {
    const glm::uvec3& t = from.triangles[i];
    const glm::vec3 middle = (from.positions[t.x] + from.positions[t.y] + from.positions[t.z]) * (1.0f / 3);
    farthest = std::max(farthest, distanceTo(to, spheres, middle));
  }
  return farthest;
}

class Scans : public testing::TestWithParam<const char*> {};

/// Colours do not count here: errors of distance alone.
TEST_P(Scans, AreNoFartherFromTheirLevelsThanErrorsSay) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: this test needs its " << GetParam();
  }
  const Mesh scan = loadScene((std::filesystem::path(folder) / GetParam()).string(), {.shading = Shading::kNone});
  const TemporaryFolder packs;
  const PackedScene scene = test::packed(scan, packs / "scan.opack");
  for (const float error : {1e-3f, 4e-3f, 1.6e-2f}) {
    const Mesh coarse = meshOf(scene, coarsestClusters(scene, error));
    const float vertices = farthestVertex(scan, coarse, 17);
    const float middles = farthestMiddle(scan, coarse, 23);
    const float back = farthestMiddle(coarse, scan, coarse.triangles.size() / 500 + 1);
    // Errors are bounds at the vertices of the scan; what rounding adds is far below a thousandth.
    EXPECT_LE(vertices, error * 1.001f);
    // Between vertices they are not: a scan's triangles are small beside those of its levels, but these may cut a
    // corner.
    EXPECT_LE(middles, error * 1.5f);
    EXPECT_LE(back, error * 3);
  }
}
INSTANTIATE_TEST_SUITE_P(Packs, Scans, testing::Values("bunny.obj", "horse.obj"),
                         [](const auto& each) { return std::string(each.param).substr(0, 5); });

}  // namespace
}  // namespace ocelli
