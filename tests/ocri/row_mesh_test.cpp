#include "oc_core/ocri/row_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/union_mesh.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr size_t kRowSamples = static_cast<size_t>(kWidth) * kHeight;
constexpr size_t kRowsJoined = 2 * static_cast<size_t>(kWidth - 1) * (kHeight - 1);

/// Triangles between samples, not of squares: samples come first among the vertices.
std::vector<glm::uvec3> trianglesAcrossRows(const Mesh& mesh, size_t samples) {
  std::vector<glm::uvec3> joined;
  for (const glm::uvec3& t : mesh.triangles) {
    if (t.x < samples && t.y < samples && t.z < samples) {
      joined.push_back(t);
    }
  }
  return joined;
}

/// The depth image with each row moved to the right by itself, as the rows of an EOC are.
ReferenceImage shifted(const ReferenceImage& image, const std::function<int(int x, int y)>& shift, int surplus) {
  ReferenceImage moved = blankReferenceImage("eoc", image.view, image.width() + surplus, image.height());
  moved.pinholeSize = {image.width(), image.height()};
  moved.rows = ImageRows::kShifted;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int column = x + shift(x, y);
      if (image.holds(x, y)) {
        moved.set(column, y, image.t(x, y), image.color(x, y));
      }
      moved.displacement(column, y) = glm::vec2(static_cast<float>(shift(x, y)), 0);
    }
  }
  return moved;
}

ViewSegment rowSegmentAlong(const glm::vec3& direction) {
  return segmentAround(View{}, direction, 1.6f);
}

TEST(RowMesh, joinsAPlaneWhollyHoweverItsRowsAreShifted) {
  for (const Mesh& plane : {test::wall(0), test::tiltedPlane(3, 30), test::tiltedPlane(9, 60)}) {
    const ReferenceImage depth = buildDepthImage(smallCamera(), plane);
    const Mesh mesh = rowMesh(shifted(
        depth, [](int, int y) { return (7 * y) % 13; }, 13));
    EXPECT_EQ(trianglesAcrossRows(mesh, kRowSamples).size(), kRowsJoined);
    EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  }
}

TEST(RowMesh, ofAlignedRowsIsTheImagesMeshButForDiagonals) {
  for (const Mesh& scene : {test::boxBeforeWall(), test::ballBeforePlane()}) {
    const ReferenceImage depth = buildDepthImage(smallCamera(), scene);
    const size_t image = trianglesAcrossRows(imageMesh(depth), kRowSamples).size();
    const size_t rows = trianglesAcrossRows(rowMesh(depth), kRowSamples).size();
    // Around silhouettes, some 90 pixels, the two may close one corner more or less.
    EXPECT_NEAR(static_cast<double>(rows), static_cast<double>(image), 90);
  }
}

TEST(RowMesh, everySampleIsAVertexWithItsColour) {
  const Mesh scene = test::boxBeforeWall();
  const ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(kHorizontalSegment), scene);
  const Mesh mesh = rowMesh(image);
  size_t vertex = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.holds(x, y)) {
        EXPECT_EQ(mesh.colors[vertex], image.color(x, y));
        EXPECT_EQ(mesh.positions[vertex], *image.reference().unproject(image.undistorted(x, y)));
        ++vertex;
      }
    }
  }
  EXPECT_EQ(vertex, image.sampleCount());
}

// A false skin would span the space between box and wall, 1.2 units or 40 pixel footprints wide.
TEST(RowMesh, hasNoSkinsAcrossDiscontinuities) {
  const Mesh scene = test::boxBeforeWall();
  for (const glm::vec3& direction : {kHorizontalSegment, kVerticalSegment, kForwardSegment, glm::vec3(1, 1, -0.5f)}) {
    const ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(direction), scene);
    const Mesh mesh = rowMesh(image);
    size_t onBox = 0;
    for (const glm::uvec3& t : trianglesAcrossRows(mesh, image.sampleCount())) {
      int wall = 0;
      for (int i = 0; i < 3; ++i) {
        wall += mesh.positions[t[i]].z < -0.5f;
      }
      EXPECT_TRUE(wall == 0 || wall == 3);
      onBox += wall == 0;
    }
    EXPECT_GT(onBox, 2 * 18 * 18u) << "the front of the box is 19 pixels wide";
  }
}

/// Two triangles at most share an edge, and they run along it in opposite directions.
void expectManifold(const std::vector<glm::uvec3>& triangles) {
  std::set<std::pair<uint32_t, uint32_t>> edges;
  size_t repeated = 0;
  for (const glm::uvec3& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      repeated += !edges.insert({t[i], t[(i + 1) % 3]}).second;
    }
  }
  EXPECT_EQ(repeated, 0u);
}

TEST(RowMesh, isAnOrientedManifold) {
  for (const Mesh& scene : {test::boxBeforeWall(), test::ballBeforePlane(), test::randomTriangles(40, 2)}) {
    for (const glm::vec3& direction :
         {kHorizontalSegment, kVerticalSegment, kForwardSegment, -kForwardSegment, glm::vec3(1, 1, -0.5f)}) {
      const ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(direction), scene);
      expectManifold(trianglesAcrossRows(rowMesh(image), image.sampleCount()));
    }
  }
}

TEST(RowMesh, trianglesFaceTheEye) {
  const Mesh scene = test::wall(0, 30);
  for (const glm::vec3& direction :
       {kHorizontalSegment, kVerticalSegment, kForwardSegment, -kForwardSegment, glm::vec3(-1, 1, -0.5f)}) {
    const Mesh mesh = rowMesh(buildEocImage(smallCamera(), rowSegmentAlong(direction), scene));
    ASSERT_FALSE(mesh.triangles.empty());
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 normal =
          glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
      EXPECT_GE(normal.z, 0) << direction.x << " " << direction.y << " " << direction.z;
    }
  }
}

TEST(RowMesh, closesTheRing) {
  const Mesh scene = test::wall(0, 30);
  ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(kForwardSegment), scene);
  ASSERT_EQ(image.rows, ImageRows::kShiftedRing);
  const size_t closed = trianglesAcrossRows(rowMesh(image), image.sampleCount()).size();
  image.rows = ImageRows::kShifted;
  const size_t open = trianglesAcrossRows(rowMesh(image), image.sampleCount()).size();
  // Two rows of half the image's width or so have two triangles for each of their samples.
  EXPECT_GT(closed, open + 60);
}

// The box's right side, hidden from L, is seen along rays of R; the wall behind it partly along rays of L.
TEST(RowMesh, joinsWhatIsHiddenToWhatIsSeen) {
  const Mesh scene = test::boxBeforeWall();
  const ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(kHorizontalSegment), scene);
  const Mesh mesh = rowMesh(image);
  std::vector<int> triangles(image.sampleCount(), 0);
  for (const glm::uvec3& t : trianglesAcrossRows(mesh, image.sampleCount())) {
    for (int i = 0; i < 3; ++i) {
      ++triangles[t[i]];
    }
  }
  size_t onSide = 0;
  size_t alone = 0;
  for (size_t i = 0; i < triangles.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    onSide += std::abs(p.x - test::kBoxHalf) < 1e-3f && p.z < test::kBoxFrontZ - 0.01f && p.z > 0.11f;
    alone += triangles[i] == 0;
  }
  // f 0.8 ... : R, 0.5 to the right of the side's plane, sees it f 0.5 (1/9.3 - 1/9.9) = 1 pixel wide, on 18 rows.
  EXPECT_GE(onSide, 10u);
  EXPECT_LE(alone, 30u);
}

TEST(RowMesh, unionMeshTakesItForShiftedRows) {
  const Mesh scene = test::boxBeforeWall();
  const ReferenceImage eoc = buildEocImage(smallCamera(), rowSegmentAlong(kHorizontalSegment), scene);
  const ReferenceImage depth = buildDepthImage(smallCamera(), scene);
  Mesh both = imageMesh(depth);
  append(both, rowMesh(eoc));
  const Mesh mesh = unionMesh({depth, eoc});
  EXPECT_EQ(mesh.triangles, both.triangles);
  EXPECT_EQ(mesh.positions, both.positions);
}

TEST(RowMesh, sameBytesWithAnyNumberOfThreads) {
  const ReferenceImage image = buildEocImage(smallCamera(), rowSegmentAlong(kForwardSegment), test::ballBeforePlane());
  setThreadCount(1);
  const Mesh mesh = rowMesh(image);
  for (const int threads : {2, 8}) {
    setThreadCount(threads);
    const Mesh other = rowMesh(image);
    EXPECT_TRUE(test::sameBytes(other.positions, mesh.positions));
    EXPECT_TRUE(test::sameBytes(other.colors, mesh.colors));
    EXPECT_TRUE(test::sameBytes(other.triangles, mesh.triangles));
  }
  setThreadCount(0);
}

TEST(RowMesh, ofFewSamples) {
  ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0));
  image.rows = ImageRows::kShiftedRing;
  for (size_t i = 0; i < image.t.size(); ++i) {
    image.clear(i);
  }
  EXPECT_TRUE(rowMesh(image).positions.empty());
  EXPECT_TRUE(rowMesh(image).triangles.empty());
  image.set(10, 20, 9, glm::vec3(0));
  const Mesh square = rowMesh(image);
  EXPECT_EQ(square.positions.size(), 5u);
  EXPECT_EQ(square.triangles.size(), 2u);
  // It is a pixel of side 9 / f, and faces the eye.
  EXPECT_NEAR(glm::distance(square.positions[1], square.positions[2]), 9 / smallCamera().focalPixels(), 1e-5f);
  EXPECT_NEAR(glm::distance(square.positions[2], square.positions[3]), 9 / smallCamera().focalPixels(), 1e-5f);
  image.t(10, 20) = std::numeric_limits<float>::quiet_NaN();
  image.set(11, 20, std::numeric_limits<float>::infinity(), glm::vec3(0));
  EXPECT_TRUE(rowMesh(image).positions.empty());
}

}  // namespace
}  // namespace ocelli
