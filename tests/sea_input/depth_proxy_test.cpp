// Proxies from images with depth.
#include "oc_core/sea_input/depth_proxy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/raycast.h"
#include "oc_core/sea_input/sea_proxies.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The walls of a room of 4 x 3 x 5 metres around the origin.
const glm::vec3 kHalfRoom{2, 1.5f, 2.5f};

Mesh room() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(kHalfRoom *
                             glm::vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh.isPart = true;
  return mesh;
}

/// Panoramas with depth, from several places.
std::vector<DepthView> views() {
  std::vector<DepthView> views;
  for (const glm::vec3 eye : {glm::vec3{0, 0, 0}, {0.8f, 0.2f, 1}, {-0.7f, 0, -1.2f}}) {
    View view;
    view.eye = eye;
    view.target = eye + glm::vec3(0, 0, -1);
    view.fovVerticalDegrees = 90;
    ReferenceImages images = buildReferenceImages(cameraChoice("panorama"), PinholeCamera(view, 128, 64), room());
    views.push_back({"place" + std::to_string(views.size()), std::move(images.at(0))});
  }
  return views;
}

/// How far a point of the room's surface, or near it, is from the walls.
float fromWalls(const glm::vec3& point) {
  const glm::vec3 inside = kHalfRoom - glm::abs(point);
  return std::min({std::abs(inside.x), std::abs(inside.y), std::abs(inside.z)});
}

TEST(DepthProxy, LiesOnTheWallsThatDepthImagesShow) {
  const TemporaryFolder folder;
  writeDepthViews(folder / "depth", views(), depthViewsFormats()[0]);
  const Mesh proxy = makeSeaProxy("depth", {.positions = {}, .points = {}, .triangles = 300, .folder = folder.path()});
  EXPECT_LE(proxy.triangles.size(), 300u);
  EXPECT_GE(proxy.triangles.size(), 12u);
  const RayScene rays(proxy);
  size_t seen = 0;
  double sum = 0;
  constexpr int kRays = 2000;
  for (int i = 0; i < kRays; ++i) {
    // Spread evenly over all directions (Fibonacci's sphere).
    const double height = 1 - (2 * i + 1.0) / kRays;
    const double angle = 2.399963 * i;
    const double level = std::sqrt(1 - height * height);
    const glm::vec3 way(level * std::cos(angle), height, level * std::sin(angle));
    const SightLine line{{0.1f, 0.1f, 0.1f}, glm::vec3(0.1f) + way * 20.0f};
    float share = 0;
    rays.meet({&line, 1}, {&share, 1});
    if (!std::isinf(share)) {
      ++seen;
      sum += fromWalls(line.from + (line.to - line.from) * share);
    }
  }
  // Panoramas of 128 columns say little of the corners; of the walls a few per cent of their distance.
  EXPECT_GT(seen, 0.97 * kRays);
  EXPECT_LT(sum / static_cast<double>(seen), 0.03 * kHalfRoom.x);
}

TEST(DepthProxy, ViewsAreSpread) {
  const std::vector<glm::vec3> eyes{{0, 0, 0}, {0.1f, 0, 0}, {5, 0, 0}, {2.4f, 0, 0}, {4.9f, 0, 0}};
  EXPECT_THAT(spreadPositions(eyes, 3), ElementsAre(0, 2, 3));
  EXPECT_EQ(spreadPositions(eyes, 9).size(), eyes.size());
  EXPECT_TRUE(spreadPositions({}, 3).empty());
}

TEST(DepthProxy, FoldersWithoutDepthAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { proxyOfDepths(folder / "depth", 100); }, ThrowsMessage<InputError>(HasSubstr("no depth images")));
  EXPECT_THAT([] { makeSeaProxy("depth", {.positions = {}, .points = {}}); },
              ThrowsMessage<InputError>(HasSubstr("rendered")));
}

}  // namespace
}  // namespace ocelli
