// --labels of scenes that stand still, move, or take none.
#include "oc_core/worlds/labelled_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/scene/mesh_series.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/scene_motion.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

class LabelledSceneTest : public testing::Test {
 protected:
  LabelledSceneTest() {
    options_.labels.file = folder_.write("labels.csv", "x,y,z,text,size,color\n0,2,0,HE,0.5,#00ff00\n").string();
    options_.fit = false;
  }

  TemporaryFolder folder_;
  SceneOptions options_;
};

size_t greenVertices(const Mesh& mesh) {
  size_t count = 0;
  for (const glm::vec3& color : mesh.colors) {
    count += color == glm::vec3(0, 1, 0) ? 1 : 0;
  }
  return count;
}

TEST_F(LabelledSceneTest, HasLabelsThatNoLightChanges) {
  const GuidedScene labelled = loadGuidedScene("builtin:box", options_);
  EXPECT_GT(greenVertices(labelled.mesh), 8u);
  EXPECT_EQ(labelled.objectOfTriangle.size(), labelled.mesh.triangles.size());
  EXPECT_NEAR(boundsOf(labelled.mesh).upper.y, 2.25f, 1e-4f);
  // What was there is there still, as it was.
  options_.shading = Shading::kNone;
  const Mesh unlit = loadScene("builtin:box", options_);
  const Mesh plain = loadScene("builtin:box", {.fit = false, .shading = Shading::kNone});
  ASSERT_GT(unlit.positions.size(), plain.positions.size());
  for (uint32_t i = 0; i < plain.positions.size(); ++i) {
    EXPECT_EQ(unlit.positions[i], plain.positions[i]);
    EXPECT_EQ(unlit.color(i), plain.color(i));
  }
}

TEST_F(LabelledSceneTest, IsFittedWithItsLabels) {
  options_.fit = true;
  const GuidedScene labelled = loadGuidedScene("builtin:box", options_);
  const float scale = labelled.worldFromScene[0][0];
  float reach = 0;
  for (const glm::vec3& p : labelled.mesh.positions) {
    reach = std::max(reach, glm::length(p));
  }
  EXPECT_NEAR(reach, 1, 1e-5f);
  EXPECT_GT(scale, 0);
}

// Without a size a label is as high as a share of the scene's diagonal.
TEST_F(LabelledSceneTest, HasASizeThatFitsIt) {
  options_.labels.file = folder_.write("b.csv", "x,y,z,text\n0,50,0,H\n").string();
  const Box scene = boundsOf(loadScene("builtin:box", {.fit = false}));
  const Box box = boundsOf(loadScene("builtin:box", options_));
  const auto height = static_cast<float>(kLabelShare) * glm::length(scene.size());
  EXPECT_NEAR(box.upper.y, 50 + height / 2, 1e-4f);
  options_.labels.facing = {1, 0, 0};
  options_.labels.file = folder_.write("c.csv", "x,y,z,text\n50,0,0,H\n").string();
  EXPECT_NEAR(boundsOf(loadScene("builtin:box", options_)).upper.x, 50, 1e-4f) << "flat, seen from x";
}

TEST_F(LabelledSceneTest, KeepsItsLabelsWhereItMoves) {
  const std::unique_ptr<SceneMotion> motion = loadMotion("builtin:waving", options_);
  ASSERT_NE(motion, nullptr);
  const size_t green = greenVertices(motion->at(0));
  EXPECT_GT(green, 8u);
  const std::vector<glm::vec3> before = motion->mesh().positions;
  const Mesh& later = motion->at(motion->durationSeconds() / 3);
  EXPECT_EQ(greenVertices(later), green);
  EXPECT_NE(before, later.positions);
  // As fresh as if it were asked for first.
  const std::unique_ptr<SceneMotion> again = loadMotion("builtin:waving", options_);
  EXPECT_EQ(again->at(motion->durationSeconds() / 3).positions, later.positions);
}

/// Two meshes of different topologies, the second without colours.
TEST_F(LabelledSceneTest, KeepsItsLabelsWhereTheTopologyChanges) {
  const auto series = [] {
    Mesh one;
    one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.triangles = {{0, 1, 2}};
    one.colors.assign(3, {1, 0, 0});
    Mesh two;
    two.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    two.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_unique<MeshSeries>(std::vector<Mesh>{one, two, one}, SeriesOptions{.meshesPerSecond = 1});
  };
  const std::unique_ptr<MovingScene> labelled = withLabels(series(), options_.labels);
  MovedMesh moved;
  labelled->moveTo(0, moved);
  const size_t letters = moved.mesh.positions.size() - 3;
  for (const auto& [seconds, vertices] : {std::pair<double, size_t>{0, 3}, {1, 4}, {2, 3}, {1, 4}}) {
    labelled->moveTo(seconds, moved);
    MovedMesh fresh;
    labelled->moveTo(seconds, fresh);
    ASSERT_EQ(moved.mesh.positions.size(), vertices + letters);
    EXPECT_EQ(moved.mesh.positions, fresh.mesh.positions);
    EXPECT_EQ(moved.mesh.colors, fresh.mesh.colors);
    EXPECT_EQ(moved.mesh.triangles, fresh.mesh.triangles);
    EXPECT_EQ(moved.unlit, fresh.unlit);
    EXPECT_EQ(moved.unlit[vertices - 1], 0);
    EXPECT_EQ(moved.unlit[vertices], 1);
    EXPECT_EQ(moved.mesh.colors[0], vertices == 3 ? glm::vec3(1, 0, 0) : glm::vec3(1));
  }
  EXPECT_NE(withLabels(series(), {}), nullptr);
  EXPECT_EQ(withLabels(nullptr, options_.labels), nullptr);
}

TEST_F(LabelledSceneTest, IsPackedWithItsLabels) {
  const std::filesystem::path path = folder_ / "box.opack";
  packSource("builtin:box", options_, path);
  EXPECT_GT(greenVertices(loadScene(path.string(), {.fit = false})), 8u);
  EXPECT_THAT([&] { loadScene(path.string(), options_); },
              ThrowsMessage<InputError>(HasSubstr("pack it with --labels")));
}

TEST_F(LabelledSceneTest, MayBeNoVolume) {
  options_.iso = 0.5;
  EXPECT_THAT([&] { loadScene("builtin:volume,name=skull", options_); },
              ThrowsMessage<InputError>(HasSubstr("a volume takes no labels")));
}

}  // namespace
}  // namespace ocelli
