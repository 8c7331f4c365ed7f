#include "oc_core/volume_camera/volume_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/volume_render/volume_target.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

class VolumeCameras : public testing::Test {
 protected:
  VolumeCamera cameraOf(const std::string& nameOrFile, const View& view = {}) const {
    return volumeCamera(nameOrFile, PinholeCamera(view, 90, 60), renderer_.scene(),
                        [&]() -> const RayTarget& { return target_; });
  }
  VolumePixel middleOf(const VolumeCamera& camera) const {
    return renderer_.pixel(camera.ray(glm::vec2(camera.size) / 2.0f));
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
  const PinholeCamera pinhole(View{}, 90, 60);
  const VolumeCamera di = cameraOf("di");
  EXPECT_EQ(di.size, glm::ivec2(90, 60));
  EXPECT_EQ(di.ray({10.5f, 20.5f}), pinhole.rayPath({10.5f, 20.5f}));
  EXPECT_EQ(cameraOf("panorama").ray({10.5f, 20.5f}), PanoramaCamera(pinhole).rayPath({10.5f, 20.5f}));
}

/// Of every row: a camera whose middle ray meets the ball, or an error that says why not.
TEST_F(VolumeCameras, EveryNameIsACameraOrAnError) {
  size_t cameras = 0;
  for (const RepresentationKind& kind : representationKinds()) {
    SCOPED_TRACE(kind.name);
    const std::string error = errorOf(kind.name);
    if (error.empty()) {
      ++cameras;
      const VolumeCamera camera = cameraOf(kind.name);
      EXPECT_GT(camera.size.x, 0);
      // The middle of the image looks at the middle of the ball: of panoramas too, along the view.
      EXPECT_GT(middleOf(camera).color.w, 0.99f);
    } else {
      EXPECT_THAT(error, testing::AnyOf(HasSubstr("is a union of"), HasSubstr("is a mesh, which has no rays")));
    }
  }
  // di, di-wide, rppc, gpc, spoc, three DDOCs, four EOCs, cell, two panoramas.
  EXPECT_EQ(cameras, 15u);
}

TEST_F(VolumeCameras, BendAsTheirFileSays) {
  const std::string file = folder_
                               .write("bent.json", R"({"camera": "curved", "turns": [
      {"from": {"point": [4, 0, 3], "normal": [-0.25, 0, -1]}, "middle": {"point": [4, 0, 3], "normal": [0, 0, -1]},
       "to": {"point": [4, 0, 3], "normal": [0.25, 0, -1]}, "viewpoint": [-2, 0, 8]}]})")
                               .string();
  const VolumeCamera camera = cameraOf(file);
  const RayPath ray = camera.ray({45, 30});
  EXPECT_GT(ray.size(), 4u);
  EXPECT_EQ(nlohmann::json::parse(camera.description)["camera"], "curved");
  EXPECT_EQ(nlohmann::json::parse(camera.description)["turns"].size(), 1u);
}

TEST_F(VolumeCameras, OcclusionCamerasAreBuiltFromWhatIsOpaque) {
  // Without anything opaque an occlusion camera would be a pinhole, and say nothing of it.
  const VolumeCamera ddoc = cameraOf("ddoc");
  const PinholeCamera pinhole(View{}, 90, 60);
  size_t displaced = 0;
  for (int x = 0; x < 90; ++x) {
    const glm::vec2 pixel(static_cast<float>(x) + 0.5f, 30.5f);
    displaced += ddoc.ray(pixel) == pinhole.rayPath(pixel) ? 0 : 1;
  }
  EXPECT_GT(displaced, 4u);   // along both edges of the ball
  EXPECT_LT(displaced, 60u);  // and not far from them
}

TEST_F(VolumeCameras, RefuseWhatAVolumeDoesNotKnow) {
  EXPECT_THAT(errorOf("comprehensive"), HasSubstr("maze"));
  EXPECT_THAT(errorOf("target"), HasSubstr("no target"));
  EXPECT_THAT(errorOf("path"), HasSubstr("path"));
  EXPECT_THAT(errorOf("nonsense"), HasSubstr("there is no camera"));
  EXPECT_THAT(errorOf((folder_ / "missing.json").string()), HasSubstr("missing.json"));
  EXPECT_THAT(errorOf("ddoc", View{.target = {0, 0, 20}, .fovVerticalDegrees = 30}), HasSubstr("opaque"));
}

}  // namespace
}  // namespace ocelli::test
