#include "oc_core/volume_camera/volume_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/volume_render/volume_target.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

class VolumeCameras : public testing::Test {
 protected:
  VolumeCamera cameraOf(const std::string& nameOrFile, const View& view = {}) const {
    return volumeCamera(nameOrFile, PinholeCamera(view, 60, 40), renderer_.scene(),
                        [&]() -> const RayTarget& { return target_; });
  }
  /// Of pixels on a grid.
  bool showsTheBall(const VolumeCamera& camera) const {
    constexpr int kGrid = 128;  // panoramas show the ball within 6 of 360 degrees
    for (int i = 0; i < kGrid * kGrid; ++i) {
      const glm::vec2 share = (glm::vec2(i % kGrid, i / kGrid) + 0.5f) / static_cast<float>(kGrid);
      if (renderer_.pixel(camera.ray(share * glm::vec2(camera.size))).color.w > 0.99f) {
        return true;
      }
    }
    return false;
  }
  std::string errorOf(const std::string& nameOrFile, const View& view = {}) const {
    try {
      cameraOf(nameOrFile, view);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  VolumeRenderer renderer_{ballVolume()};
  VolumeTarget target_{renderer_};
};

TEST_F(VolumeCameras, AreThoseOfMeshes) {
  const PinholeCamera pinhole(View{}, 60, 40);
  const VolumeCamera di = cameraOf("di");
  EXPECT_EQ(di.size, glm::ivec2(60, 40));
  EXPECT_EQ(di.ray({10.5f, 20.5f}), pinhole.rayPath({10.5f, 20.5f}));
  EXPECT_EQ(cameraOf("panorama").ray({10.5f, 20.5f}), PanoramaCamera(pinhole).rayPath({10.5f, 20.5f}));
}

/// Of every row: a camera that sees the ball, or an error that says why there is none.
TEST_F(VolumeCameras, EveryNameIsACameraOrAnError) {
  size_t cameras = 0;
  for (const RepresentationKind& kind : representationKinds()) {
    SCOPED_TRACE(kind.name);
    const std::string error = errorOf(kind.name);
    if (error.empty()) {
      ++cameras;
      const VolumeCamera camera = cameraOf(kind.name);
      EXPECT_GT(camera.size.x, 0);
      EXPECT_TRUE(showsTheBall(camera));
    } else {
      EXPECT_THAT(error, testing::AnyOf(HasSubstr("is a union of"), HasSubstr("is a mesh, which has no rays")));
    }
  }
  // di, di-wide, rppc, gpc, spoc, three DDOCs, four EOCs, cell, two panoramas, and ldi-4, which has one layer here.
  EXPECT_EQ(cameras, 16u);
}

TEST_F(VolumeCameras, BendAsTheirFileSays) {
  const std::string file = folder_
                               .write("bent.json", R"({"camera": "curved", "turns": [
      {"from": {"point": [4, 0, 3], "normal": [-0.25, 0, -1]}, "middle": {"point": [4, 0, 3], "normal": [0, 0, -1]},
       "to": {"point": [4, 0, 3], "normal": [0.25, 0, -1]}, "viewpoint": [-2, 0, 8]}]})")
                               .string();
  const VolumeCamera camera = cameraOf(file);
  const RayPath ray = camera.ray({30, 20});
  EXPECT_GT(ray.size(), 4u);
  EXPECT_EQ(nlohmann::json::parse(camera.description)["camera"], "curved");
  EXPECT_EQ(nlohmann::json::parse(camera.description)["turns"].size(), 1u);
}

TEST(VolumeCamera, OcclusionCamerasAreBuiltFromWhatIsOpaque) {
  // Before a wall, which the ball hides a part of. Without anything opaque a DDOC would be a pinhole.
  VolumeScene scene = ballVolume(0.4);
  append(scene.surfaces, makeBox({0.9f, 0.9f, 0.02f}), glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.9f)));
  const VolumeRenderer renderer(std::move(scene));
  const VolumeTarget target(renderer);
  const PinholeCamera pinhole(View{}, 180, 120);
  const VolumeCamera ddoc =
      volumeCamera("ddoc", pinhole, renderer.scene(), [&]() -> const RayTarget& { return target; });
  size_t displaced = 0;
  for (int x = 0; x < 180; ++x) {
    const glm::vec2 pixel(static_cast<float>(x) + 0.5f, 60.5f);
    displaced += ddoc.ray(pixel) == pinhole.rayPath(pixel) ? 0 : 1;
  }
  // Along both edges of the ball, which is 48 pixels wide, and of the wall; not in the middle of either.
  EXPECT_GT(displaced, 4u);
  EXPECT_LT(displaced, 90u);
  EXPECT_EQ(ddoc.ray({90.5f, 60.5f}), pinhole.rayPath({90.5f, 60.5f}));
}

TEST_F(VolumeCameras, RefuseWhatAVolumeDoesNotKnow) {
  EXPECT_THAT(errorOf("comprehensive"), HasSubstr("no floor to walk on"));
  EXPECT_THAT(errorOf("target"), HasSubstr("no target"));
  EXPECT_THAT(errorOf("path"), HasSubstr("path"));
  EXPECT_THAT(errorOf("nonsense"), HasSubstr("there is no camera"));
  EXPECT_THAT(errorOf((folder_ / "missing.json").string()), HasSubstr("missing.json"));
}

}  // namespace
}  // namespace ocelli::test
