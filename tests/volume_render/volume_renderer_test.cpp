// The renderer against the slow reference, over types of cameras and of voxels, and what it promises besides.
#include "oc_core/volume_render/volume_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/cylinder_camera.h"
#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/volume_render/march_kernel.h"
#include "oc_core/volume_render/volume_reference.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/render/camera_cases.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

/// The greatest difference of a channel of a pixel.
double differenceOf(const VolumeImage& a, const VolumeImage& b) {
  double greatest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      greatest = std::max(greatest, std::abs(static_cast<double>(a[i].color[c]) - static_cast<double>(b[i].color[c])));
    }
  }
  return greatest;
}

double greatestOpacity(const VolumeImage& image) {
  double greatest = 0;
  for (const VolumePixel& pixel : image) {
    greatest = std::max(greatest, static_cast<double>(pixel.color.w));
  }
  return greatest;
}

/// With small steps both approach the same image. What is left at an eighth of a voxel: the field's curvature between
/// samples, and colours within a step, whose order it leaves out.
constexpr double kFine = 1.0 / 8;
constexpr double kFineTolerance = 2e-3;

template <class C>
void expectReference(const C& camera, const char* name, const VolumeScene& scene, double step = kFine) {
  const VolumeImage reference = renderReference(camera, scene, step / 2);
  const VolumeImage image = renderVolume(camera, scene, {.step = step, .endTransmittance = 0});
  const double difference = differenceOf(image, reference);
  EXPECT_LT(difference, kFineTolerance) << name << (scene.appearance.shading.isOn ? ", shaded" : "");
  EXPECT_GT(greatestOpacity(reference), 0.5) << name << ": there is something to compare";
}

TEST(VolumeRenderer, isTheReferenceAlongTheRaysOfAnyCamera) {
  for (const bool isShaded : {false, true}) {
    const VolumeScene scene = test::waves(isShaded);
    test::forEachSmallCamera([&](const char* name, const auto& camera) { expectReference(camera, name, scene); });
    expectReference(test::crossroads(), "graph", scene);
    expectReference(test::bendingTwice(), "curved", scene);
    expectReference(test::bendingTwice(test::smallCamera(), ArcModel::kBezier), "curved, Bezier", scene);
    View within;
    within.eye = {0.1f, 0.2f, 0.3f};
    within.fovVerticalDegrees = 60;
    const PinholeCamera inside(within, test::kWidth, test::kHeight);
    expectReference(inside, "pinhole within", scene);
    expectReference(PanoramaCamera(inside), "panorama within", scene);
    expectReference(CylinderCamera(inside), "cylinder within", scene);
    expectReference(buildEpipolarCamera(test::smallCamera(), segmentAround(View{}, kHorizontalSegment, 1.6f),
                                        test::boxBeforeWall()),
                    "eoc", scene);
  }
}

TEST(VolumeRenderer, isTheReferenceForAnyTypeOfVoxels) {
  const PinholeCamera camera(View{}, 30, 20);
  const auto expect = [&]<class Voxel>(Voxel, VoxelType type, double steps, double middle, double scale) {
    const auto number = [&](const glm::dvec3& p) { return std::round(test::wavesAt(p) * steps) + middle; };
    // Sizes at which words reach over the ends of rows, slices and the volume.
    for (const glm::ivec3& size : {glm::ivec3(48, 44, 40), glm::ivec3(31, 33, 37)}) {
      VolumeScene scene = test::volumeOf<Voxel>(size, 1.0 / 24, type, number, test::layers(1.0 / 12), scale / steps,
                                                -middle * scale / steps);
      scene.appearance.shading.isOn = true;
      expectReference(camera, std::string(nameOf(type)).c_str(), scene);
    }
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

TEST(VolumeRenderer, isTheReferenceForGridsOfAnyAxes) {
  for (const bool isShaded : {false, true}) {
    const VolumeScene scene = test::slantedWaves(isShaded);
    // Steps are counted in mean distances of voxels, and some are shorter.
    const VolumeGrid& grid = scene.volume->grid();
    const glm::dvec3 spacing = grid.spacing();
    const double step = kFine * std::min({spacing.x, spacing.y, spacing.z}) / grid.meanSpacing();
    expectReference(test::smallCamera(), "slanted", scene, step);
    expectReference(test::bendingTwice(), "slanted, curved", scene, step);
  }
}

TEST(VolumeRenderer, isTheReferenceForThinVolumes) {
  const PinholeCamera camera(View{}, 30, 20);
  for (const glm::ivec3& size : {glm::ivec3(1, 1, 1), glm::ivec3(1, 9, 9), glm::ivec3(9, 1, 9), glm::ivec3(9, 9, 1),
                                 glm::ivec3(2, 2, 2), glm::ivec3(2, 1, 1), glm::ivec3(5, 1, 1)}) {
    const auto number = [](const glm::dvec3& p) { return 100 + 15 * p.x + 3 * p.y - 8 * p.z; };
    const TransferFunction transfer({{80, {1, 0, 0}, 0.1}, {150, {0, 1, 0}, 0.6}}, 0.5);
    for (const bool isShaded : {false, true}) {
      VolumeScene bytes = test::volumeOf<uint8_t>(size, 0.2, VoxelType::kUint8, number, transfer);
      VolumeScene floats = test::floatVolume(size, 0.2, number, transfer);
      for (VolumeScene* scene : {&bytes, &floats}) {
        scene->appearance.shading.isOn = isShaded;
        const VolumeImage reference = renderReference(camera, *scene, 1.0 / 16);
        const VolumeImage image = renderVolume(camera, *scene, {.step = kFine, .endTransmittance = 0});
        EXPECT_LT(differenceOf(image, reference), kFineTolerance) << size.x << " x " << size.y << " x " << size.z;
        EXPECT_GT(greatestOpacity(reference), 0.01);
      }
    }
  }
}

TEST(VolumeRenderer, halfOfTheDefaultStepChangesAtMostOneLevel) {
  const double step = VolumeRenderOptions{}.step;
  for (const bool isShaded : {false, true}) {
    const VolumeScene scene = test::waves(isShaded);
    const VolumeImage image = renderVolume(test::smallCamera(), scene, {.step = step});
    const VolumeImage half = renderVolume(test::smallCamera(), scene, {.step = step / 2});
    EXPECT_LT(differenceOf(image, half), 1.0 / 255) << isShaded;
  }
}

TEST(VolumeRenderer, skippingWhatIsEmptyChangesNothing) {
  // Small things far from each other: most bricks are empty.
  VolumeScene scene = test::floatVolume(
      glm::ivec3(96), 1.0 / 48,
      [](const glm::dvec3& p) {
        const double toBalls =
            std::min(glm::distance(p, glm::dvec3(20, 30, 70)), glm::distance(p, glm::dvec3(66.5, 50, 21)));
        return 1 - toBalls / 8;
      },
      TransferFunction({{0, {1, 0, 0}, 0}, {0.5, {1, 1, 0}, 0.4}, {1, {1, 1, 1}, 0.9}}, 1.0 / 24));
  scene.appearance.shading.isOn = true;
  const auto compare = [&](const auto& camera, const char* name) {
    const VolumeImage all = renderVolume(camera, scene, {.skipEmpty = false});
    const VolumeImage some = renderVolume(camera, scene, {.skipEmpty = true});
    // Sums are formed of other groups of samples: some roundings of numbers below 1.
    EXPECT_LT(differenceOf(all, some), 4e-6) << name;
    size_t allSamples = 0;
    size_t someSamples = 0;
    for (size_t i = 0; i < all.size(); ++i) {
      allSamples += all[i].samples;
      someSamples += some[i].samples;
    }
    EXPECT_GT(greatestOpacity(all), 0.5) << name;
    EXPECT_LT(someSamples * 3, allSamples) << name;
  };
  compare(test::smallCamera(), "pinhole");
  compare(test::crossroads(), "graph");
  compare(test::bendingTwice(), "curved");
}

TEST(VolumeRenderer, MakesNoRaysOfTilesThatSeeNothing) {
  // A ball in the middle of a volume that fills the image.
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(96), 1.0 / 24, [](const glm::dvec3& p) { return 1 - glm::distance(p, glm::dvec3(47.5)) / 10; },
      TransferFunction({{0, {1, 0, 0}, 0}, {1, {1, 1, 1}, 0.9}}, 1.0 / 24));
  const VolumeRenderer renderer(scene);
  const CurvedRayCamera camera = test::bendingRight(PinholeCamera(View{}, 160, 120));
  const auto countRays = [&](const RayHull& hull, VolumeImage& image) {
    std::atomic<size_t> rays = 0;
    image = renderer.render(
        camera.width(), camera.height(),
        [&](const glm::vec2& pixel) {
          ++rays;
          return camera.rayPath(pixel);
        },
        {}, hull);
    return rays.load();
  };
  VolumeImage all;
  VolumeImage some;
  EXPECT_EQ(countRays({}, all), 160u * 120u);
  EXPECT_LT(countRays(rayHullOf(std::make_shared<const CurvedRayCamera>(camera)), some), 160u * 120u * 3 / 4)
      << "the ball takes a part of the image";
  EXPECT_EQ(differenceOf(all, some), 0);
  EXPECT_GT(greatestOpacity(all), 0.5);
}

TEST(VolumeRenderer, PlacesSmoothRaysBetweenThoseOfTheirTiles) {
  // Small balls, each within a brick, far between.
  constexpr double kPeriod = 32;
  constexpr double kOffset = 28;
  constexpr double kRadius = 3;
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(96), 1.0 / 24,
      [&](const glm::dvec3& p) {
        return 1 - glm::distance(p, (glm::floor((p - kOffset) / kPeriod) + 0.5) * kPeriod + kOffset) / kRadius;
      },
      TransferFunction({{0, {1, 0, 0}, 0}, {1, {1, 1, 1}, 0.9}}, 1.0 / 24));
  const VolumeRenderer renderer(scene);
  const auto compare = [&](const auto& camera, const std::string& name) {
    std::atomic<size_t> rays = 0;
    const auto render = [&](bool isSmooth) {
      rays = 0;
      return renderer.render(
          camera.width(), camera.height(),
          [&](const glm::vec2& pixel) {
            ++rays;
            return camera.rayPath(pixel);
          },
          {}, {}, isSmooth);
    };
    const VolumeImage one = render(false);
    const auto pixels = static_cast<size_t>(camera.width()) * static_cast<size_t>(camera.height());
    EXPECT_EQ(rays.load(), pixels) << name;
    const VolumeImage between = render(true);
    EXPECT_LT(rays.load(), pixels / 8) << name << ": 7 rays of a tile, not 64";
    // Rays are a thousandth of a voxel off, where the field changes by 1 in kRadius voxels; colour and opacity change
    // at most as much as it, and by roundings of numbers below 1.
    EXPECT_LT(differenceOf(one, between), 2 * 0.001 / kRadius + 1e-5) << name;
    EXPECT_GT(greatestOpacity(one), 0.5) << name;
    const auto empty = [](const VolumeImage& image) {
      return std::count_if(image.begin(), image.end(), [](const VolumePixel& each) { return each.samples == 0; });
    };
    EXPECT_GT(empty(one), static_cast<std::ptrdiff_t>(pixels / 4)) << name << ": some tiles see nothing";
    EXPECT_NEAR(static_cast<double>(empty(one)), static_cast<double>(empty(between)), static_cast<double>(pixels) / 500)
        << name;
  };
  View near;  // where neighbours are a tenth of a voxel apart
  near.fovVerticalDegrees = 3;
  compare(PinholeCamera(near, 320, 240), "pinhole");
  compare(test::bendingRight(PinholeCamera(near, 320, 240)), "curved");
}

TEST(VolumeRenderer, endsEarlyWithinItsBound) {
  const VolumeScene scene = test::waves();
  const VolumeImage whole = renderVolume(test::smallCamera(), scene, {.endTransmittance = 0});
  const double bound = 1.0 / 50;
  const VolumeImage ended = renderVolume(test::smallCamera(), scene, {.endTransmittance = bound});
  const double difference = differenceOf(whole, ended);
  // Colours are at most 1, and highlights add up to 0.2.
  EXPECT_LT(difference, bound * 1.2);
  EXPECT_GT(difference, 0) << "some ray ends early";
}

TEST(VolumeRenderer, sameBytesWithAnyNumberOfThreads) {
  const VolumeRenderer renderer(test::waves());
  const int before = threadCount();
  setThreadCount(1);
  const VolumeImage one = renderVolume(test::bendingTwice(), renderer);
  setThreadCount(4);
  const VolumeImage four = renderVolume(test::bendingTwice(), renderer);
  const VolumeImage withProgress = renderVolume(test::bendingTwice(), renderer, [](std::string_view, double) {});
  setThreadCount(before);
  EXPECT_EQ(one, four);
  EXPECT_EQ(one, withProgress);
}

TEST(VolumeRenderer, progressGrowsAndMayEndTheWork) {
  const VolumeRenderer renderer(test::waves());
  const PinholeCamera camera(View{}, 20, 300);
  double last = -1;
  renderVolume(camera, renderer, [&](std::string_view, double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
  });
  EXPECT_EQ(last, 1);
  EXPECT_THROW(renderVolume(camera, renderer,
                            [](std::string_view, double fraction) {
                              if (fraction > 0.3) {
                                throw std::runtime_error("enough");
                              }
                            }),
               std::runtime_error);
}

TEST(VolumeRenderer, clipsShowTheirHalfSpaceAlone) {
  VolumeScene scene = test::waves();
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0.5, 0.2));
  scene.clips = {{normal, 0.1}, {glm::dvec3(0, 0, -1), -0.4}};
  for (const bool isShaded : {false, true}) {
    scene.appearance.shading.isOn = isShaded;
    expectReference(test::smallCamera(), "pinhole", scene);
    expectReference(test::bendingTwice(), "curved", scene);
  }
  // A ray in the clipped part sees nothing.
  const VolumeRenderer renderer(scene);
  EXPECT_EQ(renderer.pixel({{-0.5f, 0, 5}, {-0.5f, 0, -5}}), VolumePixel());
  EXPECT_GT(greatestOpacity(renderVolume(test::smallCamera(), renderer)), 0.5);
  // Where a clip lies in the middle of a homogeneous slab, half is left.
  VolumeScene slab = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  slab.clips = {{{0, 0, 1}, 0.25}};
  EXPECT_NEAR(static_cast<double>(VolumeRenderer(slab).pixel({{0, 0, 5}, {0, 0, -5}}).color.w),
              1 - std::pow(0.5, 0.75 / 0.5), 1e-5);
}

TEST(VolumeRenderer, raysEndAtSurfaces) {
  VolumeScene scene = test::waves();
  scene.surfaces = test::boxBeforeWall();
  expectReference(test::smallCamera(), "pinhole", scene);
  expectReference(test::crossroads(), "graph", scene);
  expectReference(test::bendingTwice(), "curved", scene);
  // A slab with a wall in its middle: half of the slab before the wall's colour.
  VolumeScene slab = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5, {1, 0, 0}));
  slab.surfaces = test::wall(0);
  for (const VolumePixel& pixel : {VolumeRenderer(slab).pixel({{0.1f, 0, 5}, {0.1f, 0, -5}}),
                                   VolumeReference(slab).pixel({{0.1f, 0, 5}, {0.1f, 0, -5}})}) {
    EXPECT_NEAR(pixel.color.r, 0.75f + 0.25f * 0.5f, 1e-5f);
    EXPECT_NEAR(pixel.color.g, 0.25f * 0.5f, 1e-5f);
    EXPECT_NEAR(pixel.color.w, 1, 1e-6f);
    EXPECT_NEAR(pixel.surfaceT, 5, 1e-5f);
    // The reference takes steps of a sixteenth of a voxel, within which it follows the exponential; floats of 5 do the
    // rest.
    EXPECT_NEAR(pixel.t, 4.5f, 1e-4f);
  }
  // Before the volume, and where there is no volume.
  slab.surfaces = test::wall(2);
  const VolumePixel before = VolumeRenderer(slab).pixel({{0.1f, 0, 5}, {0.1f, 0, -5}});
  EXPECT_EQ(before.samples, 0u);
  EXPECT_NEAR(before.surfaceT, 3, 1e-5f);
}

TEST(VolumeRenderer, raysOfOtherKindsMeetNothing) {
  const VolumeRenderer renderer(test::waves());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(renderer.pixel({}), VolumePixel());
  EXPECT_EQ(renderer.pixel({{0, 0, 0}}), VolumePixel());
  EXPECT_EQ(renderer.pixel({{0, 0, 0}, {0, 0, 0}}), VolumePixel());
  RayPath broken;
  broken.add({0, nan, 3}, 0);
  broken.add({0, 0, -3}, 1);
  EXPECT_EQ(renderer.pixel(broken), VolumePixel());
  RayPath endless;
  endless.add({0, 0, 3}, 0);
  endless.add({0, 0, -infinity}, 1);
  EXPECT_EQ(renderer.pixel(endless), VolumePixel());
}

TEST(VolumeRenderer, setsWhatEditorsChange) {
  VolumeScene scene = test::waves();
  VolumeRenderer renderer(scene);
  const RayPath ray{{0.2f, 0.1f, 5}, {0.2f, 0.1f, -5}};
  scene.appearance.transfer = test::everywhere(0.3, 0.5);
  scene.appearance.shading.isOn = false;
  renderer.setAppearance(scene.appearance);
  EXPECT_EQ(renderer.pixel(ray), VolumeRenderer(scene).pixel(ray));
  scene.clips = {{{1, 0, 0}, 0.3}};
  renderer.setClips(scene.clips);
  EXPECT_EQ(renderer.pixel(ray), VolumePixel());
  renderer.setClips({});
  renderer.setOptions({.step = 2});
  scene.clips.clear();
  EXPECT_EQ(renderer.pixel(ray), VolumeRenderer(scene, {.step = 2}).pixel(ray));
}

TEST(VolumeRenderer, aTransferFunctionOfOneValueAndAFlatVolumeWork) {
  const auto flat = [](double value, const TransferFunction& transfer) {
    VolumeScene scene = test::floatVolume(
        glm::ivec3(8), 0.25, [&](auto) { return value; }, transfer);
    scene.appearance.shading.isOn = true;
    const RayPath ray{{0.1f, 0.1f, 5}, {0.1f, 0.1f, -5}};
    const VolumePixel reference = VolumeReference(scene).pixel(ray);
    const VolumePixel pixel = VolumeRenderer(scene, {.endTransmittance = 0}).pixel(ray);
    for (int c = 0; c < 4; ++c) {
      // Lengths are sums of up to 32 steps in single precision, and a flat volume's table has one entry: roundings
      // alone.
      EXPECT_NEAR(pixel.color[c], reference.color[c], 1e-4f) << value << ", channel " << c;
    }
    return pixel.color.w;
  };
  const TransferFunction step({{10, {1, 0, 0}, 0.1}, {10, {0, 1, 0}, 0.8}}, 1);
  EXPECT_NEAR(flat(5, step), 1 - 0.9f * 0.9f, 1e-4f);
  EXPECT_NEAR(flat(20, step), 1 - 0.2f * 0.2f, 1e-4f);
  EXPECT_NEAR(flat(-1e6, step), 1 - 0.9f * 0.9f, 1e-4f);
  EXPECT_NEAR(flat(1e6, step), 1 - 0.2f * 0.2f, 1e-4f);
  const TransferFunction ramp({{0, {1, 0, 0}, 0}, {10, {0, 1, 0}, 0.5}}, 1);
  EXPECT_NEAR(flat(5, ramp), 1 - 0.75f * 0.75f, 1e-4f);
  EXPECT_EQ(flat(-5, ramp), 0);
}

}  // namespace
}  // namespace ocelli
