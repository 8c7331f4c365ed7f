#include "oc_core/volume_camera/volume_image_file.h"

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume_render/volume_target.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

VolumePixel pixelOf(const glm::vec4& color, float t, uint32_t samples) {
  VolumePixel pixel;
  pixel.color = color;
  pixel.t = t;
  pixel.samples = samples;
  return pixel;
}

VolumeImage threePixels() {
  VolumeImage image(3, 1);
  image[0] = pixelOf({0.25f, 0, 0, 0.5f}, 9.5f, 7);
  image[1] = pixelOf({0, 0.125f, 0, 0.25f}, VolumePixel::kNowhere, 3);
  return image;
}

TEST(VolumeImageFile, ShowsTheBackgroundThroughWhatIsTransparent) {
  const Image<glm::vec3> picture = imageBefore({1, 0.5f, 0}, threePixels());
  EXPECT_EQ(picture[0], glm::vec3(0.75f, 0.25f, 0));
  EXPECT_EQ(picture[1], glm::vec3(0.75f, 0.5f, 0));
  EXPECT_EQ(picture[2], glm::vec3(1, 0.5f, 0));
}

TEST(VolumeImageFile, CountsWhatItTook) {
  const VolumeImageFacts facts = factsOf(threePixels());
  EXPECT_EQ(facts.samples, 10u);
  EXPECT_EQ(facts.touched, 2u);
  EXPECT_EQ(facts.opaque, 1u);
  EXPECT_DOUBLE_EQ(facts.meanOpacity, 0.25);
}

TEST(VolumeImageFile, SurfacesEndRaysAsOpaqueMatterDoes) {
  VolumeImage image = threePixels();
  image[1].surfaceT = 12;
  EXPECT_EQ(factsOf(image).opaque, 2u);
  image[0].surfaceT = 20;
  EXPECT_EQ(factsOf(image).opaque, 2u) << "each ray once";
}

/// The channels of an EXR of 9 x 7 pixels.
std::map<std::string, std::vector<float>> channelsOf(Imf::InputFile& file) {
  std::map<std::string, std::vector<float>> channels;
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B", "A", "Z", "P.X", "P.Y", "P.Z"}) {
    channels[name].resize(63);
    buffer.insert(
        name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(channels[name].data()), sizeof(float), 9 * sizeof(float)));
  }
  const Imath::Box2i window = file.header().dataWindow();
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return channels;
}

TEST(VolumeImageFile, DepthsAreThoseOfSurfacesWhereTheyComeFirst) {
  const TemporaryFolder folder;
  const PinholeCamera pinhole(View{}, 9, 7);
  VolumeScene scene = ballVolume();
  // As wide as the view, behind the middle of the ball, which hides it there, and then before the ball.
  for (const auto& [z, middleZ] : {std::pair(-0.5f, 9.5), std::pair(0.75f, 9.25)}) {
    scene.surfaces.positions = {{-50, -50, z}, {50, -50, z}, {0, 50, z}};
    scene.surfaces.triangles = {{0, 1, 2}};
    const VolumeRenderer renderer(scene);
    const VolumeTarget target(renderer);
    const VolumeCamera camera =
        volumeCamera("di", pinhole, renderer.scene(), [&]() -> const RayTarget& { return target; });
    const VolumeImage image = renderer.render(9, 7, camera.ray);
    EXPECT_EQ(factsOf(image).opaque, 63u);
    const std::filesystem::path path = folder / "ball.exr";
    writeVolumeImage(path, image, camera, 0.5);
    Imf::InputFile file(path.c_str());
    const auto channels = channelsOf(file);
    const size_t middle = 3 * 9 + 4;
    // Half of the light is lost within a hundredth of the ball's edge, and interpolation moves that by half a voxel.
    EXPECT_NEAR(channels.at("Z")[middle], middleZ, 1.0 / 32 + 0.01);
    EXPECT_NEAR(channels.at("P.Z")[middle], 10 - middleZ, 1.0 / 32 + 0.01);
    EXPECT_NEAR(channels.at("Z")[0], 10 - z, 1e-5) << "beside the ball";
    EXPECT_NEAR(channels.at("P.Z")[0], z, 1e-5);
  }
}

TEST(VolumeImageFile, KeepsOpacityDepthAndPlacesInAFile) {
  const TemporaryFolder folder;
  const VolumeRenderer renderer(ballVolume());
  const VolumeTarget target(renderer);
  const PinholeCamera pinhole(View{}, 9, 7);
  const VolumeCamera camera =
      volumeCamera("di", pinhole, renderer.scene(), [&]() -> const RayTarget& { return target; });
  const VolumeImage image = renderer.render(9, 7, camera.ray);
  const std::filesystem::path path = folder / "ball.exr";
  writeVolumeImage(path, image, camera, 0.5);

  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  ASSERT_EQ(window.max.x - window.min.x + 1, 9);
  auto channels = channelsOf(file);
  const size_t middle = 3 * 9 + 4;
  EXPECT_EQ(channels["A"][middle], image[middle].color.w);
  EXPECT_EQ(channels["R"][middle], image[middle].color.x);
  EXPECT_EQ(channels["Z"][middle], image[middle].t);
  // The ball of radius 0.5 before an eye at 10; rays stop within half a step of 1/32 and the slab that hides.
  EXPECT_NEAR(channels["Z"][middle], 9.5, 1.0 / 32 + 0.01);
  EXPECT_NEAR(channels["P.Z"][middle], 0.5, 1.0 / 32 + 0.01);
  EXPECT_NEAR(channels["P.X"][middle], 0, 1e-5);
  EXPECT_EQ(channels["A"][0], 0);
  EXPECT_EQ(channels["Z"][0], 0);
  const auto* text = file.header().findTypedAttribute<Imf::StringAttribute>("ocelli");
  ASSERT_NE(text, nullptr);
  const auto json = nlohmann::json::parse(text->value());
  EXPECT_EQ(json["camera"], "di");
  EXPECT_EQ(json["depth_opacity"], 0.5);
  EXPECT_EQ(json["view"]["eye"][2], 10);
}

TEST(VolumeImageFile, SaysWhyItShowsNothing) {
  const VolumeScene scene = ballVolume();
  const auto errorFor = [&](const View& view) -> std::string {
    const PinholeCamera pinhole(view, 30, 20);
    const VolumeCamera camera{"di", "{}", {30, 20}, [&](const glm::vec2& pixel) { return pinhole.rayPath(pixel); }};
    try {
      failShowingNothing(camera, scene);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(errorFor({}), HasSubstr("transparent"));
  EXPECT_THAT(errorFor({.target = {0, 0, 20}, .fovVerticalDegrees = 30}), HasSubstr("outside of the view"));
}

}  // namespace
}  // namespace ocelli::test
