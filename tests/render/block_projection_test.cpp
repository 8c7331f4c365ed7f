// The vertices of a block are projected together to what they are projected to one by one, bit by bit, and triangles
// that are passed over change no pixel.
#include "oc_core/render/block_projection.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"
#include "oc_core/render/bend_projection.h"
#include "oc_core/render/region_buffer.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/camera/test_curved_cameras.h"

namespace ocelli {
namespace {

TEST(BlockProjection, collectsTheCornersOfTriangles) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const MeshBlocks blocks(mesh, MeshBlocks::Order::kInSpace);
  BlockVertices points;
  size_t triangles = 0;
  for (uint32_t block = 0; block < blocks.size(); ++block) {
    points.collect(mesh, blocks, block);
    for (const BlockVertices::Triangle& triangle : points.triangles()) {
      for (int k = 0; k < 3; ++k) {
        const size_t corner = triangle.corners[static_cast<size_t>(k)];
        ASSERT_LT(corner, points.size());
        EXPECT_EQ(points.position(corner), mesh.positions[mesh.triangles[triangle.index][k]]);
      }
      ++triangles;
    }
  }
  EXPECT_EQ(triangles, mesh.triangles.size());
}

TEST(BlockProjection, projectsAsTheBendDoesOneByOne) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const MeshBlocks blocks(mesh);
  BlockVertices points;
  BendImages images;
  size_t imaged = 0;
  for (const CurvedRayCamera& camera : {test::bendingRight(), test::bendingTwice()}) {
    for (size_t bend = 0; bend < camera.bends().size(); ++bend) {
      const BendProjection projection(camera, bend);
      for (uint32_t block = 0; block < blocks.size(); ++block) {
        points.collect(mesh, blocks, block);
        projection.project(points, images);
        for (size_t i = 0; i < points.size(); ++i) {
          const BendImage image = projection.project(glm::dvec3(points.position(i)));
          ASSERT_EQ(images.imaged[i] != 0, image.imaged);
          EXPECT_EQ(images.behindFirst[i], image.behindFirst);
          EXPECT_EQ(images.beforeLast[i], image.beforeLast);
          EXPECT_EQ(images.share[i], image.share());
          if (image.imaged) {
            EXPECT_EQ(glm::dvec2(images.u[i], images.v[i]), image.pixel);
            EXPECT_EQ(images.weight[i], image.weight);
            ++imaged;
          }
        }
      }
    }
  }
  EXPECT_GT(imaged, 1000u);
}

TEST(RegionBuffer, trianglesThatMissAllChangeNoPixel) {
  const PixelLeaves leaves(40, 30, 0);
  RegionBuffer region;
  region.reset({8, 8, 32, 24}, leaves);
  const std::array<int16_t, 1> kinds{0};
  region.open(region.rect(), 0, kinds);
  Random random(3);
  size_t missed = 0;
  size_t hit = 0;
  for (uint32_t triangle = 0; triangle < 20'000; ++triangle) {
    const float size = random.inRange(0.1f, 3);
    const glm::vec2 middle(random.inRange(6, 34), random.inRange(6, 26));
    const auto corner = [&] {
      return RasterVertex{middle.x + random.inRange(-size, size), middle.y + random.inRange(-size, size),
                          1 / random.inRange(1, 2), 0, 0};
    };
    const RasterVertex a = corner();
    const RasterVertex b = corner();
    const RasterVertex c = corner();
    const float nearest = 0.9999f / std::max({a.inverseZ, b.inverseZ, c.inverseZ});
    const bool misses = region.missesAll(region.rect(), a, b, c, nearest);
    size_t changes = 0;
    region.scan(region.rect(), a, b, c, [&](size_t pixel, float depth, const PixelWeights& weights) {
      if (region.isNearest(pixel, depth, triangle)) {
        region.put(pixel, depth, triangle, weights());
        ++changes;
      }
    });
    if (misses) {
      ASSERT_EQ(changes, 0u) << triangle;
      ++missed;
    }
    hit += changes > 0 ? 1 : 0;
  }
  EXPECT_GT(missed, 5000u);
  EXPECT_GT(hit, 500u);
}

}  // namespace
}  // namespace ocelli
