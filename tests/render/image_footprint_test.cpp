#include "oc_core/render/image_footprint.h"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;

using Corners = std::array<glm::vec3, 3>;

Corners inCameraSpace(const PinholeCamera& reference, const Mesh& mesh, size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return {reference.cameraFromWorld(mesh.positions[t.x]), reference.cameraFromWorld(mesh.positions[t.y]),
          reference.cameraFromWorld(mesh.positions[t.z])};
}

/// Large triangles, small ones, some of them partly behind the eye.
Mesh triangles() {
  Mesh mesh = test::randomTriangles(400, 17);
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
    const float scale = i % 4 == 0 ? 1.0f : i % 4 == 1 ? 0.1f : i % 4 == 2 ? 0.02f : 15.0f;
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions[t[corner]] = middle + (mesh.positions[t[corner]] - middle) * scale;
    }
  }
  return mesh;
}

// Brute force: many points of each triangle, and none has its image out of the box.
TEST(Footprint, holdsTheImageOfEveryPoint) {
  const Mesh mesh = triangles();
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    const PinholeCamera& reference = referenceOf(camera);
    size_t images = 0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const PixelBox box = footprint(camera, inCameraSpace(reference, mesh, i));
      constexpr int kSteps = 60;
      for (int j = 0; j <= kSteps; ++j) {
        for (int k = 0; j + k <= kSteps; ++k) {
          const float b1 = static_cast<float>(j) / kSteps;
          const float b2 = static_cast<float>(k) / kSteps;
          const auto q =
              camera.project(mesh.positions[t.x] * (1 - b1 - b2) + mesh.positions[t.y] * b1 + mesh.positions[t.z] * b2);
          if (!q || !(q->u > 0) || !(q->v > 0) || !(q->u < kWidth) || !(q->v < kHeight)) {
            continue;
          }
          // A pixel centre within the slack of the image point.
          const float u = std::round(q->u - 0.5f) + 0.5f;
          const float v = std::round(q->v - 0.5f) + 0.5f;
          if (std::abs(q->u - u) < 0.5f * kFootprintSlackPixels && std::abs(q->v - v) < 0.5f * kFootprintSlackPixels &&
              u > 0 && v > 0 && u < kWidth && v < kHeight) {
            ++images;
            ASSERT_TRUE(box.contains(static_cast<int>(u), static_cast<int>(v))) << name << " " << i;
          }
        }
      }
    }
    EXPECT_GT(images, 1000u) << name;
  });
}

// Where nothing is displaced a box is that of the corners, with the slack.
TEST(Footprint, isThatOfThePinholeWhereNothingIsDisplaced) {
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kBilinear);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < 20; ++x) {
      map.samples()(x, y) = {{12, 3}, 1 / 8.0f, 1 / 12.0f};
    }
  }
  const DdocCamera camera(test::smallCamera(), map);
  size_t away = 0;
  const Mesh mesh = triangles();
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners corners = inCameraSpace(test::smallCamera(), mesh, i);
    float left = 1e9f;
    for (const glm::vec3& p : corners) {
      left = std::min(left, p.z > 0.1f ? test::smallCamera().imageFromCamera(p).u : -1e9f);
    }
    const PixelBox pinhole = footprint(test::smallCamera(), corners);
    // Cells of the bounds of a size with the triangle may reach over the border of the displaced part.
    if (left < 20 + 4 || pinhole.empty() || pinhole.x1 - pinhole.x0 > 2) {
      continue;
    }
    ++away;
    const PixelBox box = footprint(camera, corners);
    EXPECT_TRUE(box.x0 == pinhole.x0 && box.x1 == pinhole.x1 && box.y0 == pinhole.y0 && box.y1 == pinhole.y1) << i;
  }
  EXPECT_GT(away, 20u);
}

// How much larger boxes are than the image needs, over triangles of a few pixels. A pinhole's triangle fills half of
// its box. A displacement that varies over the box, or over the depths of the triangle, makes it wider by that at most.
TEST(Footprint, isTight) {
  Mesh mesh;
  for (int i = 0; i < 200; ++i) {
    const float x = -1 + 0.01f * static_cast<float>(i);
    const float y = -0.8f + 0.06f * static_cast<float>(i % 27);
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::vec3 corner : {glm::vec3(0), glm::vec3(0.1f, 0, 0), glm::vec3(0, 0.1f, 0)}) {
      mesh.positions.push_back(glm::vec3(x, y, 0.2f) + corner);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    if constexpr (std::is_same_v<std::decay_t<decltype(camera)>, GpcCamera>) {
      return;  // what it magnifies by varies over a box, by 3 pixels more here; its own renderer has
               // GpcRasterZone::imageBox
    }
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const PixelBox box = footprint(camera, inCameraSpace(referenceOf(camera), mesh, i));
      glm::vec2 lower(1e9f);
      glm::vec2 upper(-1e9f);
      for (int corner = 0; corner < 3; ++corner) {
        const auto q = camera.project(mesh.positions[mesh.triangles[i][corner]]);
        ASSERT_TRUE(q);
        lower = glm::min(lower, glm::vec2(q->u, q->v));
        upper = glm::max(upper, glm::vec2(q->u, q->v));
      }
      // Their legs are 3 pixels long. Twice the whole displacement of 6 pixels is what a bound may cost around the
      // pole; elsewhere the distance to it (the pole) says how much its direction turns.
      const float fromPole = glm::distance((lower + upper) * 0.5f, glm::vec2(40.3f, 28.7f));
      const float turn = 2 * std::min(6.0f, 6 * 8 / fromPole) + 2;
      EXPECT_LE(static_cast<float>(box.x1 - box.x0), upper.x - lower.x + turn) << name << " " << i;
      EXPECT_LE(static_cast<float>(box.y1 - box.y0), upper.y - lower.y + turn) << name << " " << i;
    }
  });
}

TEST(Footprint, ofWhatHasNoImageIsEmpty) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    for (const Corners& corners : {Corners{glm::vec3(0, 0, -1), glm::vec3(1, 0, -1), glm::vec3(0, 1, -2)},
                                   Corners{glm::vec3(0, 0, 2000), glm::vec3(1, 0, 2000), glm::vec3(0, 1, 3000)},
                                   Corners{glm::vec3(30, 0, 10), glm::vec3(31, 0, 10), glm::vec3(30, 1, 10)},
                                   Corners{glm::vec3(kNan, 0, 10), glm::vec3(1, 0, 10), glm::vec3(0, 1, 10)},
                                   Corners{glm::vec3(0, 0, 1e38f * 10), glm::vec3(1, 0, 10), glm::vec3(0, 1, 10)}}) {
      EXPECT_TRUE(footprint(camera, corners).empty()) << name;
    }
  });
}

}  // namespace
}  // namespace ocelli
