// Volumes with OpenGL against the same on the CPU: cameras, voxels, light, clips, surfaces, passes.
#include "oc_core/volume_gl/gl_volume_renderer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/camera/cylinder_camera.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/volume_render/ray_pieces.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/gl/gl_test_context.h"
#include "tests/render/camera_cases.h"
#include "tests/volume_gl/volume_agreement.h"
#include "tests/volume_render/place_lights.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

/// The ways in which rays come to the shader: it makes those of a pinhole and of a general one, and gets those of graph
/// and curved ray cameras as pieces, straight ones and many that continue each other. Calls `visit(name, camera)`.
template <class Visit>
void forEachWayOfRays(const PinholeCamera& pinhole, const Visit& visit) {
  visit("pinhole", pinhole);
  visit("general pinhole", GpcCamera(pinhole, test::twoRegions("cubic")));
  visit("graph", test::crossroads(pinhole));
  visit("curved", test::bendingTwice(pinhole));
}

class GlVolumeRendererTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlVolumeRendererTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  template <class C>
  void expectCpu(const C& camera, const VolumeScene& scene, const std::string& name,
                 const VolumeRenderOptions& options = {}, double tolerance = test::kColorTolerance) {
    const GlVolumeRenderer renderer(*context_, scene, options);
    test::expectAgreement(renderVolume(camera, scene, options), renderVolumeOnGpu(camera, renderer), name, tolerance);
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlVolumeRendererTest, kOffscreenProviders, providerName);

TEST_P(GlVolumeRendererTest, seesWhatTheCpuSeesAlongTheRaysOfAnyCamera) {
  for (const bool isShaded : {false, true}) {
    const VolumeScene scene = test::waves(isShaded);
    test::forEachSmallCamera([&](const char* name, const auto& camera) { expectCpu(camera, scene, name); });
    expectCpu(test::crossroads(), scene, "graph");
    expectCpu(test::bendingTwice(), scene, "curved");
    expectCpu(test::bendingTwice(test::smallCamera(), ArcModel::kBezier), scene, "curved, Bezier");
    View within;
    within.eye = {0.1f, 0.2f, 0.3f};
    within.fovVerticalDegrees = 60;
    const PinholeCamera inside(within, test::kWidth, test::kHeight);
    expectCpu(inside, scene, "pinhole within");
    expectCpu(PanoramaCamera(inside), scene, "panorama within");
    expectCpu(CylinderCamera(inside), scene, "cylinder within");
    expectCpu(buildEpipolarCamera(test::smallCamera(), segmentAround(View{}, kHorizontalSegment, 1.6f),
                                  test::boxBeforeWall()),
              scene, "eoc");
  }
}

TEST_P(GlVolumeRendererTest, takesVoxelsOfAnyType) {
  const PinholeCamera camera(View{}, 30, 20);
  const auto expect = [&]<class Voxel>(Voxel, VoxelType type, double steps, double middle, double scale) {
    const auto number = [&](const glm::dvec3& p) { return std::round(test::wavesAt(p) * steps) + middle; };
    // Rows that are no multiples of 4 bytes, too.
    VolumeScene scene = test::volumeOf<Voxel>(glm::ivec3(31, 33, 37), 1.0 / 18, type, number, test::layers(1.0 / 9),
                                              scale / steps, -middle * scale / steps);
    scene.appearance.shading.isOn = true;
    forEachWayOfRays(camera, [&](const std::string& name, const auto& of) {
      expectCpu(of, scene, name + ", " + std::string(nameOf(type)));
    });
  };
  expect(uint8_t(), VoxelType::kUint8, 127, 128, 1);
  expect(int8_t(), VoxelType::kInt8, 127, 0, 1);
  expect(uint16_t(), VoxelType::kUint16, 30000, 32768, 1);
  expect(int16_t(), VoxelType::kInt16, 30000, 0, 1);
  expect(uint32_t(), VoxelType::kUint32, 2e9, 2147483648.0, 1);
  expect(int32_t(), VoxelType::kInt32, 2e9, 0, 1);
  expect(double(), VoxelType::kFloat64, 1e6, 0, 1);
  expect(float(), VoxelType::kFloat32, 1e6, 0, 1);
  // Values that fall where numbers rise.
  expect(int16_t(), VoxelType::kInt16, 30000, 0, -1);
}

TEST_P(GlVolumeRendererTest, isFiniteAndTheSameHoweverDense) {
  const auto number = [](const glm::dvec3& p) { return p.x; };
  for (const double length : {1e-2, 1e-9, 1e-20}) {
    const TransferFunction dense({{10.3, {1, 0, 0}, 0}, {10.3, {1, 0, 0}, 0.9999}, {30.3, {0, 0, 1}, 0.9999}}, length);
    const VolumeScene scene = test::floatVolume({32, 8, 8}, 0.05, number, dense);
    forEachWayOfRays(PinholeCamera(View{}, 30, 20), [&](const std::string& name, const auto& camera) {
      expectCpu(camera, scene, name + ", dense " + std::to_string(length));
    });
  }
}

// The shader's copy of the lighting rule, for rays that it makes and for those that are uploaded.
TEST_P(GlVolumeRendererTest, lightsPlacesByTheRule) {
  for (const test::LightCase& each : test::lightCases()) {
    const GlVolumeRenderer renderer(*context_, each.scene, test::placeOptions());
    const PinholeCamera camera = test::placeCamera();
    test::expectPlaceLights(renderer.render(camera), each);
    test::expectPlaceLights(
        renderer.render(camera.width(), camera.height(), [&](const glm::vec2& p) { return camera.rayPath(p); }), each);
  }
}

TEST_P(GlVolumeRendererTest, takesGridsOfAnyAxes) {
  for (const bool isShaded : {false, true}) {
    const VolumeScene scene = test::slantedWaves(isShaded);
    forEachWayOfRays(test::smallCamera(), [&](const std::string& name, const auto& camera) {
      expectCpu(camera, scene, "slanted, " + name);
    });
  }
}

// The lowest number of a type with a sign has no positive counterpart.
TEST_P(GlVolumeRendererTest, theLowestNumberIsItself) {
  const auto number = [](const glm::dvec3& p) { return p.x < 8 ? -32768 : -32767; };
  VolumeScene scene =
      test::volumeOf<int16_t>(glm::ivec3(16), 0.1, VoxelType::kInt16, number,
                              TransferFunction({{-32768, {1, 0, 0}, 0.9}, {-32767, {0, 1, 0}, 0.9}}, 0.3));
  // Numbers of this size are 1/256 apart in the CPU's single precision, of a transfer function that is one wide.
  expectCpu(PinholeCamera(View{}, 30, 20), scene, "lowest", {}, 1.0 / 256);
}

TEST_P(GlVolumeRendererTest, takesThinVolumes) {
  // Near enough that a volume of one voxel fills a hundredth of every image, also of the graph camera's.
  View view;
  view.fovVerticalDegrees = 6;
  const PinholeCamera camera(view, 30, 20);
  for (const glm::ivec3& size : {glm::ivec3(1, 1, 1), glm::ivec3(1, 9, 9), glm::ivec3(9, 1, 9), glm::ivec3(9, 9, 1),
                                 glm::ivec3(2, 2, 2), glm::ivec3(5, 1, 1)}) {
    const auto number = [](const glm::dvec3& p) { return 100 + 15 * p.x + 3 * p.y - 8 * p.z; };
    VolumeScene scene = test::volumeOf<uint8_t>(size, 0.4, VoxelType::kUint8, number,
                                                TransferFunction({{80, {1, 0, 0}, 0.1}, {150, {0, 1, 0}, 0.6}}, 0.2));
    for (const bool isShaded : {false, true}) {
      scene.appearance.shading.isOn = isShaded;
      forEachWayOfRays(camera, [&](const std::string& name, const auto& of) {
        expectCpu(of, scene, fmt::format("{}, {}x{}x{}", name, size.x, size.y, size.z));
      });
    }
  }
}

// exp(-extinction length) of light passes a slab, however its rays run.
TEST_P(GlVolumeRendererTest, aHomogeneousBoxIsAsOpaqueAsItIsThick) {
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](const glm::dvec3&) { return 0.0; }, test::everywhere(0.4, 0.5));
  const double extinction = -std::log(1 - 0.4) / 0.5;
  View view;
  view.eye = {0, 0, 3};
  const PinholeCamera camera(view, 41, 41);
  const GlVolumeRenderer renderer(*context_, scene);
  const VolumeImage image = renderer.render(camera);
  const glm::vec3 way = camera.rayPath({20.5f, 20.5f})[1] - camera.rayPath({20.5f, 20.5f})[0];
  ASSERT_NEAR(glm::normalize(way).z, -1, 1e-6);
  const double opacity = 1 - std::exp(-extinction * 2);
  EXPECT_NEAR(image(20, 20).color.w, opacity, 1e-5);
  EXPECT_NEAR(image(20, 20).color.x, 0.8 * opacity, 1e-5);
  EXPECT_NEAR(image(20, 20).t, 2 + std::log(2) / extinction, 1e-5) << "half of the light is lost there";
}

TEST_P(GlVolumeRendererTest, clipsAsTheCpu) {
  VolumeScene scene = test::waves();
  const auto plane = [](const glm::dvec3& normal, double distance) {
    return ClipPlane{glm::normalize(normal), distance};
  };
  // One, one that is parallel to rays, and more than the shader takes.
  const std::vector<std::vector<ClipPlane>> all{
      {plane({1, 0, 0}, 0.2)},
      {plane({0, 0, -1}, -0.3), plane({1, 2, 3}, -0.1)},
      {plane({1, 0, 0}, -0.5), plane({-1, 0, 0}, -0.5), plane({0, 1, 0}, -0.5), plane({0, -1, 0}, -0.5),
       plane({0, 0, 1}, -0.5), plane({0, 0, -1}, -0.5), plane({1, 1, 0}, -0.5), plane({1, -1, 0}, -0.5),
       plane({-1, 1, 0}, -0.5), plane({-1, -1, 0}, -0.5)}};
  GlVolumeRenderer renderer(*context_, scene);
  for (const std::vector<ClipPlane>& clips : all) {
    scene.clips = clips;
    renderer.setClips(clips);
    const std::string name = std::to_string(clips.size()) + " clips";
    forEachWayOfRays(test::smallCamera(), [&](const std::string& way, const auto& camera) {
      test::expectAgreement(renderVolume(camera, scene), renderVolumeOnGpu(camera, renderer), name + ", " + way);
    });
  }
}

TEST_P(GlVolumeRendererTest, surfacesEndRaysAsOnTheCpu) {
  VolumeScene scene = test::waves();
  scene.surfaces = test::boxBeforeWall();
  for (const bool isShaded : {true, false}) {
    scene.appearance.shading.isOn = isShaded;
    forEachWayOfRays(test::smallCamera(),
                     [&](const std::string& name, const auto& camera) { expectCpu(camera, scene, name); });
  }
}

// The same pixels, from fewer samples.
TEST_P(GlVolumeRendererTest, skipsWhatIsEmpty) {
  VolumeScene scene = test::floatVolume(
      glm::ivec3(96), 1.0 / 48,
      [](const glm::dvec3& p) {
        return 1 - std::min(glm::distance(p, glm::dvec3(20, 30, 70)), glm::distance(p, glm::dvec3(66.5, 50, 21))) / 8;
      },
      TransferFunction({{0, {1, 0, 0}, 0}, {0.5, {1, 1, 0}, 0.4}, {1, {1, 1, 1}, 0.9}}, 1.0 / 24));
  scene.appearance.shading.isOn = true;
  GlVolumeRenderer renderer(*context_, scene);
  const auto compare = [&](const auto& camera) {
    const auto samplesOf = [](const VolumeImage& image) {
      size_t sum = 0;
      for (const VolumePixel& pixel : image) {
        sum += pixel.samples;
      }
      return sum;
    };
    renderer.setOptions({.skipEmpty = false});
    const VolumeImage all = renderVolumeOnGpu(camera, renderer);
    renderer.setOptions({.skipEmpty = true});
    const VolumeImage some = renderVolumeOnGpu(camera, renderer);
    EXPECT_LT(test::agreementOf(all, some).color, 1e-6);
    EXPECT_LT(samplesOf(some), samplesOf(all) / 2);
    EXPECT_GT(samplesOf(some), 0);
  };
  forEachWayOfRays(test::smallCamera(), [&](const std::string&, const auto& camera) { compare(camera); });
  compare(PanoramaCamera(test::smallCamera()));
}

// Rows of pinholes are drawn in bands where progress is told, and listed ones some at a time: the image is the same.
TEST_P(GlVolumeRendererTest, bandsOfRowsMeet) {
  const VolumeScene scene = test::waves();
  const GlVolumeRenderer renderer(*context_, scene);
  size_t told = 0;
  const Progress progress = [&](std::string_view, double) { ++told; };
  forEachWayOfRays(PinholeCamera(View{}, 12, 300), [&](const std::string& name, const auto& camera) {
    told = 0;
    test::expectAgreement(renderVolume(camera, scene), renderVolumeOnGpu(camera, renderer, progress), name);
    EXPECT_GT(told, 3u) << name << ": several bands";
  });
}

// More steps than a software renderer does in one pass: pixels stop, and go on.
TEST_P(GlVolumeRendererTest, longRaysTakeSeveralPasses) {
  const VolumeScene scene = test::waves(false);
  const VolumeRenderOptions options{.step = 1.0 / 500, .endTransmittance = 0, .skipEmpty = false};
  View view;
  view.fovVerticalDegrees = 20;
  const PinholeCamera camera(view, 24, 16);
  forEachWayOfRays(camera, [&](const std::string& name, const auto& of) {
    expectCpu(of, scene, name, options, test::kRoundingTolerance);
  });
  // Where neighbours skip and look in turn, the turns of all of them count.
  expectCpu(camera, scene, "skipping", {.step = 1.0 / 300, .endTransmittance = 0}, test::kRoundingTolerance);
}

TEST_P(GlVolumeRendererTest, stepsAndTheEndOfRaysAreThoseOfTheOptions) {
  const VolumeScene scene = test::waves();
  for (const VolumeRenderOptions& options :
       {VolumeRenderOptions{.step = 0.25, .endTransmittance = 0},
        VolumeRenderOptions{.step = 1.7, .endTransmittance = 0, .depthOpacity = 0.2},
        VolumeRenderOptions{.step = 3, .endTransmittance = 0, .depthOpacity = 0.9}}) {
    forEachWayOfRays(test::smallCamera(), [&](const std::string& name, const auto& camera) {
      expectCpu(camera, scene, name + ", step " + std::to_string(options.step), options, test::kRoundingTolerance);
    });
  }
}

/// Pieces of 1.2 voxels of the waves, around their middle and along the view.
RayPath windingPath(const glm::vec2& pixel) {
  RayPath path;
  for (int i = 0; i < 50; ++i) {
    const float angle = 0.12f * static_cast<float>(i) + 0.1f * pixel.y;
    const float radius = 0.3f + 0.02f * pixel.x;
    // t grows by another factor in each piece.
    const auto t = static_cast<float>(i + (i % 3) * 0.4);
    path.add({radius * std::cos(angle), radius * std::sin(angle), 1.1f - 0.044f * static_cast<float>(i)}, t);
  }
  return path;
}

// A step is lit in its middle, and has its depth where the threshold is reached, in whichever piece of the ray that is.
TEST_P(GlVolumeRendererTest, stepsOverSeveralPiecesAreThoseOfTheCpu) {
  constexpr int kSide = 24;
  VolumeScene scene = test::waves();
  scene.appearance.transfer = test::everywhere(0.05, 1.0 / 24);
  for (const double step : {0.5, 3.0, 9.0}) {
    const VolumeRenderOptions options{.step = step, .endTransmittance = 0};
    const VolumeImage expected = VolumeRenderer(scene, options).render(kSide, kSide, windingPath);
    const VolumeImage got = GlVolumeRenderer(*context_, scene, options).render(kSide, kSide, windingPath);
    test::expectAgreement(expected, got, "winding, step " + std::to_string(step), test::kRoundingTolerance);
    for (size_t i = 0; i < expected.size(); ++i) {
      // At t half of the light is left, of which single precision loses 5e-5, and 1.2 of it are lost by length: t grows
      // by up to 24 there.
      EXPECT_NEAR(expected[i].t, got[i].t, 5e-5f / (0.5f * 1.2f) * 24) << "step " << step << ", pixel " << i;
    }
  }
}

// A ray may leave the volume and enter it again, and each time begins another sample.
TEST_P(GlVolumeRendererTest, raysThatEnterOftenTakeSeveralPasses) {
  VolumeScene scene = test::waves(false);
  scene.appearance.transfer = test::everywhere(0.001, 1.0 / 24);
  const auto path = [](const glm::vec2& pixel) {
    RayPath ray;
    for (int i = 0; i < 100; ++i) {
      ray.push_back(
          {i % 2 == 0 ? 1.1f : 0.9f, 0.1f * pixel.y, -0.5f + 0.01f * static_cast<float>(i) + 0.002f * pixel.x});
    }
    return ray;
  };
  // A software renderer takes 3500 turns in a pass, two a step. A ray of 1700 steps takes some more, as its 50 parts
  // are no multiples of a step.
  for (const double steps : {1600.0, 1700.0, 1745.0, 1800.0}) {
    VolumeExtent::Pieces pieces;
    double length = 0;
    const size_t count = VolumeExtent(scene).cut(path({0.5f, 0.5f}), std::numeric_limits<double>::infinity(), pieces);
    for (size_t i = 0; i < count; ++i) {
      length += pieces[i].length;
    }
    const VolumeRenderOptions options{
        .step = length / steps / scene.volume->grid().meanSpacing(), .endTransmittance = 0, .skipEmpty = false};
    const VolumeImage expected = VolumeRenderer(scene, options).render(4, 4, path);
    const VolumeImage got = GlVolumeRenderer(*context_, scene, options).render(4, 4, path);
    test::expectAgreement(expected, got, fmt::format("{} steps", steps), test::kRoundingTolerance);
  }
}

TEST_P(GlVolumeRendererTest, anotherAppearanceTakesThePlaceOfTheFirst) {
  VolumeScene scene = test::waves(false);
  GlVolumeRenderer renderer(*context_, scene);
  forEachWayOfRays(test::smallCamera(), [&](const std::string& name, const auto& camera) {
    const VolumeImage before = renderVolumeOnGpu(camera, renderer);
    scene.appearance = {TransferFunction({{-1, {0, 1, 0}, 0.3}, {1, {0, 0, 1}, 0.1}}, 0.3), {.isOn = true}};
    renderer.setAppearance(scene.appearance);
    test::expectAgreement(renderVolume(camera, scene), renderVolumeOnGpu(camera, renderer), "another, " + name);
    renderer.setAppearance(test::waves(false).appearance);
    EXPECT_TRUE(std::ranges::equal(before, renderVolumeOnGpu(camera, renderer))) << name;
  });
}

// Weights of at least 8 bits: a value is off by 1/256 of the difference of neighbours, along each axis.
TEST_P(GlVolumeRendererTest, theFilterOfTheHardwareIsClose) {
  const VolumeScene scene = test::waves(false);
  const GlVolumeRenderer exact(*context_, scene);
  const GlVolumeRenderer hardware(*context_, scene, {}, GlVolumeFilter::kHardware);
  forEachWayOfRays(test::smallCamera(), [&](const std::string& name, const auto& camera) {
    EXPECT_LT(test::agreementOf(renderVolumeOnGpu(camera, exact), renderVolumeOnGpu(camera, hardware)).color, 0.02)
        << name;
  });
}

TEST_P(GlVolumeRendererTest, raysWithoutPointsSeeNothing) {
  const GlVolumeRenderer renderer(*context_, test::waves());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const VolumeImage image = renderer.render(3, 1, [&](const glm::vec2& pixel) {
    return pixel.x < 1 ? RayPath() : pixel.x < 2 ? RayPath{{nan, 0, 0}, {0, 0, 1}} : RayPath{{0, 0, 3}, {0, 0, -3}};
  });
  EXPECT_EQ(image(0, 0), VolumePixel());
  EXPECT_EQ(image(1, 0), VolumePixel());
  EXPECT_GT(image(2, 0).color.w, 0.1f);
}

TEST_P(GlVolumeRendererTest, progressMayEndTheWork) {
  const GlVolumeRenderer renderer(*context_, test::waves());
  const auto stop = [](std::string_view, double fraction) {
    if (fraction > 0.4) {
      throw std::runtime_error("enough");
    }
  };
  forEachWayOfRays(PinholeCamera(View{}, 16, 300), [&](const std::string& name, const auto& camera) {
    EXPECT_THROW(renderVolumeOnGpu(camera, renderer, stop), std::runtime_error) << name;
  });
  EXPECT_THROW(GlVolumeRenderer(*context_, test::waves(), {}, GlVolumeFilter::kExact,
                                [](std::string_view, double) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace ocelli
