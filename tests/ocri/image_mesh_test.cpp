#include "oc_core/ocri/image_mesh.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/grid_cell.h"
#include "oc_core/ocri/sample_join.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr size_t kSamples = static_cast<size_t>(kWidth) * kHeight;
constexpr size_t kJoined = 2 * static_cast<size_t>(kWidth - 1) * (kHeight - 1);
/// A sample at the border of the image has at most three or four of eight triangles around it: it gets a square.
constexpr size_t kBorderSamples = 2 * static_cast<size_t>(kWidth + kHeight) - 4;

/// Triangles between samples, not of squares: samples come first among the vertices.
size_t joinedTriangles(const Mesh& mesh, size_t samples) {
  size_t count = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    count += t.x < samples && t.y < samples && t.z < samples;
  }
  return count;
}

ReferenceImage emptyImage() {
  return blankReferenceImage("di", View{}, kWidth, kHeight);
}

TEST(ImageMesh, planesAreJoinedWholly) {
  // The last one grazes: its depth grows from 5 to 100 over the image, by 30 footprints a pixel and more far away.
  for (const Mesh& plane : {test::wall(0), test::tiltedPlane(3, 30), test::tiltedPlane(9, 60)}) {
    const Mesh mesh = imageMesh(buildDepthImage(smallCamera(), plane));
    EXPECT_EQ(joinedTriangles(mesh, kSamples), kJoined);
    EXPECT_EQ(mesh.triangles.size(), kJoined + 2 * kBorderSamples);
    EXPECT_EQ(mesh.positions.size(), kSamples + 4 * kBorderSamples);
    EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  }
}

TEST(ImageMesh, liesOnThePlaneThatItSamples) {
  constexpr float kSteepness = 3;
  const Mesh mesh = imageMesh(buildDepthImage(smallCamera(), test::tiltedPlane(kSteepness, 30)));
  for (const glm::vec3& p : mesh.positions) {
    // Snapping by 0.003 pixels of 0.03 units, times the steepness; squares end half a pixel beyond.
    EXPECT_NEAR(p.z, -kSteepness * p.y, 2e-3f);
  }
}

TEST(ImageMesh, noTriangleSpansTwoDepths) {
  for (const bool distorted : {false, true}) {
    const Mesh scene = test::boxBeforeWall();
    const ReferenceImage image = distorted ? buildDdocImage(buildDdocCamera(smallCamera(), scene), scene)
                                           : buildDepthImage(smallCamera(), scene);
    const Mesh mesh = imageMesh(image);
    size_t onBox = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      int wall = 0;
      for (int i = 0; i < 3; ++i) {
        wall += mesh.positions[t[i]].z < -0.5f;
      }
      EXPECT_TRUE(wall == 0 || wall == 3);
      onBox += wall == 0;
    }
    EXPECT_GT(onBox, 2 * 18 * 18u) << "the front of the box is 19 pixels wide";
    EXPECT_GT(mesh.triangles.size() - onBox, kJoined / 2);
  }
}

TEST(ImageMesh, everySampleIsAVertexWithItsColour) {
  const ReferenceImage image = buildDepthImage(smallCamera(), test::boxBeforeWall());
  const Mesh mesh = imageMesh(image);
  size_t vertex = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x, ++vertex) {
      EXPECT_EQ(mesh.colors[vertex], image.color(x, y));
      EXPECT_EQ(mesh.positions[vertex], *smallCamera().unproject(image.undistorted(x, y)));
    }
  }
}

TEST(ImageMesh, isolatedSampleKeepsASquareOfAPixel) {
  ReferenceImage image = emptyImage();
  image.set(20, 30, 8, glm::vec3(0.25f));
  image.displacement(20, 30) = {4, -2};
  const Mesh mesh = imageMesh(image);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  ASSERT_EQ(mesh.positions.size(), 5u);
  // The pinhole sees it at (20.5 - 4, 30.5 + 2).
  for (size_t i = 1; i < 5; ++i) {
    const std::optional<ImagePoint> q = smallCamera().project(mesh.positions[i]);
    ASSERT_TRUE(q);
    EXPECT_NEAR(std::abs(q->u - 16.5f), 0.5f, 1e-3f);
    EXPECT_NEAR(std::abs(q->v - 32.5f), 0.5f, 1e-3f);
    EXPECT_NEAR(q->t, 8, 1e-5f);
    EXPECT_EQ(mesh.colors[i], glm::vec3(0.25f));
  }
}

TEST(ImageMesh, emptyImageGivesAnEmptyMesh) {
  EXPECT_TRUE(imageMesh(emptyImage()).empty());
}

TEST(ImageMesh, neighboursFarApartInSpaceAreNotJoined) {
  ReferenceImage image = emptyImage();
  std::fill(image.t.begin(), image.t.end(), 10.0f);
  std::fill(image.held.begin(), image.held.end(), uint8_t{1});
  // Two halves at the same depth, seen 13 pixels apart: more than the longest step of 12.
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kWidth / 2; x < kWidth; ++x) {
      image.displacement(x, y) = {-12, 0};
    }
  }
  const Mesh mesh = imageMesh(image);
  EXPECT_EQ(joinedTriangles(mesh, kSamples), kJoined - 2 * (kHeight - 1));
}

TEST(ImageMesh, trianglesAreCountedWithoutTheMesh) {
  for (const Mesh& scene : {test::wall(0), test::boxBeforeWall(), test::randomTriangles(40, 3)}) {
    const ReferenceImage image = buildDepthImage(smallCamera(), scene);
    EXPECT_EQ(imageMeshTriangles(image), imageMesh(image).triangles.size());
  }
  EXPECT_EQ(imageMeshTriangles(emptyImage()), 0u);
}

TEST(ImageMesh, squaresKeepToTheTriangleBound) {
  ReferenceImage image = buildDepthImage(smallCamera(), test::boxBeforeWall());
  const Mesh free = imageMesh(image);
  const size_t joined = joinedTriangles(free, kSamples);
  const size_t rims = (free.triangles.size() - joined) / 2;
  ASSERT_GT(rims, 50u);
  for (const size_t affordable : {size_t{0}, size_t{21}, rims, rims + 7, 2 * rims}) {
    image.triangleBound = joined + affordable;
    const Mesh bound = imageMesh(image);
    EXPECT_EQ(bound.triangles.size(), joined + affordable);
    EXPECT_EQ(joinedTriangles(bound, kSamples), joined);
    // As many rims as can be get at least one triangle, of three corners of its own; squares have a fourth.
    const size_t covered = std::min(rims, affordable);
    const size_t squares = affordable - covered;
    EXPECT_EQ(bound.positions.size(), kSamples + 3 * covered + squares);
  }
  image.triangleBound = joined - 1;
  EXPECT_EQ(imageMesh(image).triangles.size(), joined) << "only squares are left out";
}

// The wall's last column, x = 89.5, ends in an opening to the right: the half square reaches as far as the whole one.
TEST(ImageMesh, halfSquaresPointToTheOpening) {
  ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0));
  const size_t joined = joinedTriangles(imageMesh(image), kSamples);
  image.triangleBound = joined + kBorderSamples;
  const Mesh mesh = imageMesh(image);
  const PinholeCamera camera = smallCamera();
  glm::vec2 lower(1e30f);
  glm::vec2 upper(-1e30f);
  for (const glm::vec3& point : mesh.positions) {
    const std::optional<ImagePoint> q = camera.project(point);
    ASSERT_TRUE(q);
    lower = glm::min(lower, glm::vec2(q->u, q->v));
    upper = glm::max(upper, glm::vec2(q->u, q->v));
  }
  // Single precision at a distance of 10 units: a micrometre, 1e-4 pixels.
  EXPECT_NEAR(lower.x, 0, 1e-3f);
  EXPECT_NEAR(lower.y, 0, 1e-3f);
  EXPECT_NEAR(upper.x, kWidth, 1e-3f);
  EXPECT_NEAR(upper.y, kHeight, 1e-3f);
}

// Samples squeezed by a factor stand for so much more of their surface: half a step beyond the outermost ones. The
// longest square has 4 pixels.
TEST(ImageMesh, squaresGrowWithTheSqueeze) {
  for (const float squeeze : {1.0f, 2.5f, 6.0f}) {
    ReferenceImage image = emptyImage();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 40; x < 50; ++x) {
        image.set(x, y, 10, glm::vec3(0));
        image.displacement(x, y) = {(1 - squeeze) * static_cast<float>(x - 45), 0};
      }
    }
    const PinholeCamera camera = smallCamera();
    float upper = 0;
    for (const glm::vec3& point : imageMesh(image).positions) {
      upper = std::max(upper, camera.project(point)->u);
    }
    EXPECT_NEAR(upper, image.undistorted(49, 0).u + std::min(squeeze, 4.0f) / 2, 1e-3f) << squeeze;
    // Rows of their own each: what is next to them says nothing about the squeeze.
    image.rows = ImageRows::kShifted;
    upper = 0;
    for (const glm::vec3& point : imageMesh(image).positions) {
      upper = std::max(upper, camera.project(point)->u);
    }
    EXPECT_NEAR(upper, image.undistorted(49, 0).u + 0.5f, 1e-3f) << squeeze;
  }
}

// A file may hold depths that its own view does not see.
TEST(ImageMesh, samplesOutOfTheDepthRangeAreLeftOut) {
  ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0));
  for (int y = 10; y < 20; ++y) {
    for (int x = 10; x < 20; ++x) {
      image.t(x, y) = x < 15 ? 1e9f : 1e-9f;
    }
  }
  const Mesh mesh = imageMesh(image);
  EXPECT_GT(mesh.triangles.size(), kSamples);
  for (const glm::uvec3& t : mesh.triangles) {
    ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
  }
}

/// The slow reference: the triangles of all cells, one pair of samples at a time.
std::vector<glm::uvec3> cellTrianglesOneByOne(const ReferenceImage& image) {
  const PinholeCamera camera = image.reference();
  Image<uint32_t> vertexOf(image.width(), image.height(), 0xffffffffu);
  uint32_t vertices = 0;
  for (size_t i = 0; i < vertexOf.size(); ++i) {
    const int x = static_cast<int>(i) % image.width();
    const int y = static_cast<int>(i) / image.width();
    vertexOf[i] = image.pointOf(x, y, camera) ? vertices++ : vertexOf[i];
  }
  const auto sample = [&](const glm::ivec2& p) {
    return vertexOf.contains(p.x, p.y) && vertexOf(p.x, p.y) != 0xffffffffu ? image.undistorted(p.x, p.y)
                                                                            : ImagePoint{};
  };
  const auto joins = [&](const glm::ivec2& p, const glm::ivec2& q) {
    const glm::ivec2 step = q - p;
    return samplesJoin(sample(p - step), sample(p), sample(q), sample(q + step), false, camera.focalPixels(), 1, {});
  };
  std::vector<glm::uvec3> triangles;
  for (int y = 0; y + 1 < image.height(); ++y) {
    for (int x = 0; x + 1 < image.width(); ++x) {
      const glm::ivec2 a(x, y);
      const glm::ivec2 b(x, y + 1);
      const glm::ivec2 c(x + 1, y + 1);
      const glm::ivec2 d(x + 1, y);
      closeCell(
          a, b, c, d, {joins(a, b), joins(b, c), joins(d, c), joins(a, d)}, joins,
          [&](const glm::ivec2& p) { return 1 / image.t(p.x, p.y); },
          [&](const glm::ivec2& p, const glm::ivec2& q, const glm::ivec2& r) {
            triangles.emplace_back(vertexOf(p.x, p.y), vertexOf(q.x, q.y), vertexOf(r.x, r.y));
          });
    }
  }
  return triangles;
}

TEST(ImageMesh, joinsManyPairsAsItJoinsOne) {
  const Mesh steep = test::tiltedPlane(9, 60);
  std::vector<ReferenceImage> images;
  for (const Mesh& scene : {test::boxBeforeWall(), test::ballBeforePlane(), steep, test::randomTriangles(200, 3)}) {
    images.push_back(buildDepthImage(smallCamera(), scene));
    images.push_back(buildDdocImage(buildDdocCamera(smallCamera(), scene), scene));
    images.push_back(buildDdocImage(DdocCamera(smallCamera(), test::wavyMap(kWidth, kHeight, 9, 25)), scene));
  }
  for (ReferenceImage& image : images) {
    // Samples that no point belongs to, and one whose place is none.
    for (size_t i = 7; i < image.t.size(); i += 97) {
      image.clear(i);
    }
    image.displacement[1000].x = NAN;
    const std::vector<glm::uvec3> expected = cellTrianglesOneByOne(image);
    Mesh mesh = imageMesh(image);
    ASSERT_GE(mesh.triangles.size(), expected.size());
    mesh.triangles.resize(expected.size());
    EXPECT_TRUE(test::sameBytes(mesh.triangles, expected));
  }
}

TEST(ImageMesh, hasNoColorsWhereTheImageHasNone) {
  ReferenceImage image = buildDepthImage(smallCamera(), test::boxBeforeWall());
  const Mesh colored = imageMesh(image);
  image.color = {};
  const Mesh mesh = imageMesh(image);
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_TRUE(test::sameBytes(mesh.positions, colored.positions));
  EXPECT_TRUE(test::sameBytes(mesh.triangles, colored.triangles));
}

}  // namespace
}  // namespace ocelli
