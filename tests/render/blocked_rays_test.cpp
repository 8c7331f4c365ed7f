#include "oc_core/render/blocked_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "oc_core/base/random.h"
#include "oc_core/render/triangle_tree.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

// Any number of lines, also such as fill no packet: as the tree of triangles finds.
TEST(BlockedRays, areThoseThatMeetATriangle) {
  const Mesh mesh = makeTorus(0.3f, 24);
  const TriangleTree tree(mesh);
  for (const bool fast : {false, true}) {
    const BlockedRays rays(mesh, fast);
    Random random(1);
    for (const size_t count : {0u, 1u, 7u, 8u, 9u, 400u}) {
      std::vector<SightLine> lines;
      for (size_t i = 0; i < count; ++i) {
        SightLine line;
        for (int axis = 0; axis < 3; ++axis) {
          line.from[axis] = random.inRange(-1.2f, 1.2f);
          line.to[axis] = random.inRange(-1.2f, 1.2f);
        }
        lines.push_back(line);
      }
      std::vector<uint8_t> blocked(count, 7);
      rays.find(lines, blocked);
      for (size_t i = 0; i < count; ++i) {
        EXPECT_EQ(blocked[i], tree.meet(lines[i].from, lines[i].to - lines[i].from, 1) ? 1 : 0) << i;
      }
    }
  }
}

TEST(BlockedRays, endWhereTheyEnd) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const BlockedRays rays(mesh);
  const float nan = std::nanf("");
  const std::vector<SightLine> lines{{{0, 0, 1}, {0, 0, -1}},
                                     {{0, 0, 1}, {0, 0, 0.01f}},
                                     {{0, 0, -0.01f}, {0, 0, -1}},
                                     {{0, 0, nan}, {0, 0, 1}},
                                     {{0, 0, 1}, {0, 0, 1e19f}}};
  std::vector<uint8_t> blocked(lines.size());
  rays.find(lines, blocked);
  EXPECT_EQ(blocked, (std::vector<uint8_t>{1, 0, 0, 0, 0}));
  std::vector<uint8_t> none(1, 7);
  BlockedRays(Mesh{}).find(std::vector<SightLine>{lines[0]}, none);
  EXPECT_EQ(none[0], 0);
}

}  // namespace
}  // namespace ocelli
