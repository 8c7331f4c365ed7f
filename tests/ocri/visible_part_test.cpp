#include "oc_core/ocri/visible_part.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/scene/densify.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

/// A box before a wall in triangles smaller than a pixel, so that hidden ones can be dropped.
Mesh fineScene() {
  Mesh mesh = test::boxBeforeWall(0.8f);
  densify(mesh, 60000);
  return mesh;
}

struct Images {
  Mesh mesh = fineScene();
  PinholeCamera pinhole = test::smallCamera();
  DdocCamera ddoc = buildDdocCamera(pinhole, mesh);
  ReferenceImage seen = buildDepthImage(pinhole, mesh);
  ReferenceImage distorted = buildDdocImage(ddoc, mesh);
  Mesh part = visiblePart(mesh, ddoc, seen.z, distorted.z);
};

TEST(VisiblePart, showsTheSameImages) {
  const Images images;
  EXPECT_EQ(buildDepthImage(images.pinhole, images.part).z, images.seen.z);
  EXPECT_EQ(buildDdocImage(images.ddoc, images.part).z, images.distorted.z);
}

TEST(VisiblePart, dropsWhatIsHidden) {
  const Images images;
  EXPECT_LT(images.part.triangles.size(), images.mesh.triangles.size() * 9 / 10) << "the box hides its back";
  validate(images.part, "part");
  const uint32_t vertices = static_cast<uint32_t>(images.part.positions.size());
  std::vector<bool> used(vertices);
  for (const glm::uvec3& t : images.part.triangles) {
    used[t.x] = used[t.y] = used[t.z] = true;
  }
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
}

TEST(VisiblePart, keepsTrianglesLargerThanAPixel) {
  const Mesh mesh = test::boxBeforeWall();
  const PinholeCamera pinhole = test::smallCamera();
  const DdocCamera ddoc = buildDdocCamera(pinhole, mesh);
  const Mesh part = visiblePart(mesh, ddoc, buildDepthImage(pinhole, mesh).z, buildDdocImage(ddoc, mesh).z);
  EXPECT_EQ(part.triangles.size(), mesh.triangles.size());
}

}  // namespace
}  // namespace ocelli
