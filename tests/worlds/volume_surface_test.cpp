// Surfaces of volumes as scenes: where they stand, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "oc_core/base/error.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

constexpr const char* kVolume = "builtin:volume,name=marschner-lobb,size=32";

std::string volumeErrorOf(const std::string& source, const SceneOptions& options) {
  try {
    loadScene(source, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class VolumeSurface : public testing::Test {
 protected:
  void SetUp() override {
    if (!canExtractIsosurfaces()) {
      GTEST_SKIP() << "this build has no isosurfaces";
    }
  }
};

TEST_F(VolumeSurface, LiesInTheVolumeThatIsFittedAlike) {
  for (const bool fit : {true, false}) {
    const GuidedScene scene = loadGuidedScene(kVolume, {.fit = fit, .shading = Shading::kNone, .iso = 0.5});
    const VolumeScene volume = loadVolumeScene(kVolume, {.fit = fit});
    ASSERT_GT(scene.mesh.triangles.size(), 1000u);
    EXPECT_EQ(scene.objectOfTriangle.size(), scene.mesh.triangles.size());
    const glm::dmat4 indexFromWorld = glm::inverse(volume.worldFromIndex);
    const glm::dvec3 last(volume.volume->grid().size - 1);
    size_t inside = 0;
    size_t near = 0;
    for (const glm::vec3& p : scene.mesh.positions) {
      const glm::dvec3 index(indexFromWorld * glm::dvec4(glm::dvec3(p), 1));
      if (glm::all(glm::greaterThan(index, glm::dvec3(1e-3))) && glm::all(glm::lessThan(index, last - 1e-3))) {
        ++inside;
        near += std::abs(volume.volume->fieldAt(index) - 0.5) < 0.01;
      }
    }
    // All but where the field turns over within a cell.
    EXPECT_GT(static_cast<double>(near), 0.98 * static_cast<double>(inside));
  }
}

TEST_F(VolumeSurface, TellsHowItWasFitted) {
  const GuidedScene fitted = loadGuidedScene(kVolume, {.iso = 0.5});
  const Mesh unfitted = loadScene(kVolume, {.fit = false, .iso = 0.5});
  ASSERT_EQ(fitted.mesh.positions.size(), unfitted.positions.size());
  for (size_t i = 0; i < unfitted.positions.size(); i += 101) {
    const glm::vec3 moved(fitted.worldFromScene * glm::vec4(unfitted.positions[i], 1));
    EXPECT_LT(glm::distance(moved, fitted.mesh.positions[i]), 1e-5f);
  }
}

TEST_F(VolumeSurface, IsPackedAsItIs) {
  const TemporaryFolder folder;
  packSource(kVolume, {.iso = 0.5}, folder / "v.opack");
  const PackedScene packed((folder / "v.opack").string());
  const Mesh mesh = loadScene(kVolume, {.iso = 0.5});
  EXPECT_EQ(packed.triangleCount(), mesh.triangles.size());
}

TEST(VolumeScenes, AreNoMeshesWithoutAValue) {
  EXPECT_THAT(volumeErrorOf(kVolume, {}), HasSubstr("--iso VALUE"));
}

TEST(VolumeScenes, MeshesHaveNoValues) {
  EXPECT_THAT(volumeErrorOf("builtin:teapot", {.iso = 0.5}), HasSubstr("this scene is no volume"));
}

}  // namespace
}  // namespace ocelli
