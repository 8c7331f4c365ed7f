#include "study/task/object_picker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"
#include "study/task/eye_camera.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

Maze mazeWith(const std::vector<Landmark>& objects) {
  Maze maze = test::studyMaze();
  maze.landmarks = objects;
  return maze;
}

TEST(ObjectPicker, findsWhatIsBeforeTheEyeAndNothingBesideIt) {
  // A sphere of 0.39 m, two cells to the east of the eye.
  const StudyScene scene(mazeWith({{{2, 3}, LandmarkShape::kSphere, LandmarkColor::kOrange}}));
  const ObjectPicker picker(scene);
  const EyeCamera eye(scene.maze(), {}, {});
  const PinholeCamera camera = eye.pinhole({4.5, 7.5, kPi / 2}, {400, 300});
  const auto at = [&](const glm::vec3& point) {
    return glm::dvec2(glm::vec2(camera.project(point)->u, camera.project(point)->v));
  };
  const glm::dvec2 middle = at({10.5f, 0.39f, 7.5f});
  EXPECT_TRUE(picker.isUnder(camera, middle, 0, 0, {}));
  // Its edge is at most 0.39 m aside: 0.6 m are not on it.
  const glm::dvec2 beside = at({10.5f, 0.39f, 8.1f});
  EXPECT_FALSE(picker.isUnder(camera, beside, 0, 0, {}));
  EXPECT_TRUE(picker.isUnder(camera, beside, beside.x - middle.x, 0, {}));
  EXPECT_FALSE(picker.isUnder(camera, {-3, 5}, 0, 0, {}));
  // Moved to the right, it is there and no more here.
  EXPECT_TRUE(picker.isUnder(camera, beside, 0, 0, {0, 0, 0.6f}));
  EXPECT_FALSE(picker.isUnder(camera, middle, 0, 0, {0, 0, 0.6f}));
}

TEST(ObjectPicker, isAsGenerousToASliverAsToAnyOtherPixel) {
  // Small as it is, the object is one pixel wide here and there.
  const StudyScene scene(mazeWith({{{2, 5}, LandmarkShape::kCone, LandmarkColor::kOrange}}));
  const ObjectPicker picker(scene);
  const PinholeCamera camera = EyeCamera(scene.maze(), {}, {}).pinhole({4.5, 7.5, kPi / 2}, {60, 45});
  constexpr double kTolerance = 3.5;
  std::vector<glm::dvec2> shown;
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 60; ++x) {
      if (picker.isUnder(camera, {x + 0.5, y + 0.5}, 0, 0, {})) {
        shown.emplace_back(x + 0.5, y + 0.5);
      }
    }
  }
  ASSERT_GT(shown.size(), 2u);
  ASSERT_LT(shown.size(), 30u);
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 60; ++x) {
      const glm::dvec2 pointer(x + 0.2, y + 0.9);
      const bool isNear = std::any_of(shown.begin(), shown.end(), [&](const glm::dvec2& each) {
        return glm::distance(each, pointer) <= kTolerance;
      });
      EXPECT_EQ(picker.isUnder(camera, pointer, kTolerance, 0, {}), isNear || picker.isUnder(camera, pointer, 0, 0, {}))
          << x << " " << y;
    }
  }
}

TEST(ObjectPicker, wallsHideObjects) {
  const StudyScene scene(mazeWith({{{1, 2}, LandmarkShape::kSphere, LandmarkColor::kOrange}}));
  const ObjectPicker picker(scene);
  // Straight at it, with a wall between the cells.
  ASSERT_FALSE(scene.maze().isOpen({1, 1}, Direction::kEast));
  View view;
  view.eye = scene.maze().centerOf({1, 1}) + glm::vec3(0, 0.4f, 0);
  view.target = scene.maze().centerOf({1, 2}) + glm::vec3(0, 0.4f, 0);
  view.fovVerticalDegrees = 60;
  const PinholeCamera camera(view, 100, 100);
  EXPECT_FALSE(picker.isUnder(camera, {50, 50}, 20, 0, {}));
}

/// Pixels where picking and drawing differ although neighbours of the pixel do not.
void expectAsDrawn(const ObjectPicker& picker, const StudyScene& scene, const StudyCamera& camera,
                   const std::vector<glm::vec3>& offsets, size_t& seen) {
  Mesh mesh = scene.mesh();
  scene.moveObjects(mesh, offsets);
  const Image<uint32_t> drawn = std::visit(
      [&](const auto& model) { return identityImage(rasterize(model, mesh), scene.objectOfTriangle()); }, camera);
  for (int y = 1; y + 1 < drawn.height(); ++y) {
    for (int x = 1; x + 1 < drawn.width(); ++x) {
      bool isInside = true;
      for (int k = 0; k < 9; ++k) {
        isInside = isInside && drawn(x - 1 + k % 3, y - 1 + k / 3) == drawn(x, y);
      }
      if (!isInside) {
        continue;  // at an edge, where rounding decides
      }
      for (size_t object = 0; object < scene.objectCount(); ++object) {
        const bool isDrawn = drawn(x, y) == object + 1;
        const bool isPicked = picker.isUnder(camera, {x + 0.5, y + 0.5}, 0, object, offsets[object]);
        // Another object may hide it, which picking does not ask.
        EXPECT_TRUE(isDrawn ? isPicked : !isPicked || drawn(x, y) != kStructure) << x << " " << y;
        seen += isDrawn ? 1 : 0;
      }
    }
  }
}

TEST(ObjectPicker, agreesWithWhatIsDrawnForBothCameras) {
  const StudyScene scene(mazeWith({{{2, 4}, LandmarkShape::kSphere, LandmarkColor::kOrange},
                                   {{1, 3}, LandmarkShape::kCube, LandmarkColor::kBlue},
                                   {{0, 2}, LandmarkShape::kColumn, LandmarkColor::kGreen}}));
  const ObjectPicker picker(scene);
  const EyeCamera eye(scene.maze(), {}, {});
  size_t seen = 0;
  Random random(5);
  for (const WalkerPose& pose : {WalkerPose{2.5, 7.5, kPi / 2}, WalkerPose{7.2, 7.9, 1.2}, WalkerPose{7.5, 1.2, 1.9},
                                 WalkerPose{10.4, 7.3, -0.1}, WalkerPose{16.5, 7.5, -kPi / 2}}) {
    for (const TrialView view : kViews) {
      std::vector<glm::vec3> offsets(3);
      for (glm::vec3& offset : offsets) {
        offset = {random.inRange(-0.3f, 0.3f), 0, random.inRange(-0.3f, 0.3f)};
      }
      expectAsDrawn(picker, scene, eye.views(pose, view, {0, 0, 90, 60}).front().camera, offsets, seen);
    }
  }
  EXPECT_GT(seen, 150u);
}

}  // namespace
}  // namespace ocelli
