// Volumes whose images have closed forms, by the reference and by the renderer.
#include <gtest/gtest.h>

#include "oc_core/scene/box.h"
#include "oc_core/volume_render/volume_reference.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

/// What issue and documentation promise of analytic cases.
constexpr double kAnalytic = 1e-4;

const glm::dvec3 kColor{0.8, 0.4, 0.2};

VolumeRenderOptions toTheEnd(double step = 0.5) {
  return {.step = step, .endTransmittance = 0};
}

void expectColor(const VolumePixel& pixel, const glm::dvec3& color, double transmittance, const char* what) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(static_cast<double>(pixel.color[c]), color[c], kAnalytic) << what << ", channel " << c;
  }
  EXPECT_NEAR(static_cast<double>(pixel.color.w), 1 - transmittance, kAnalytic) << what;
}

/// Both ways.
void expectBoth(const VolumeScene& scene, const RayPath& ray, const glm::dvec3& color, double transmittance,
                double step = 0.5) {
  expectColor(VolumeReference(scene, 1.0 / 64).pixel(ray), color, transmittance, "reference");
  expectColor(VolumeRenderer(scene, toTheEnd(step)).pixel(ray), color, transmittance, "renderer");
}

TEST(AnalyticVolume, slabLosesLightByLength) {
  // 20 voxels of 0.1: from -1 to 1. A length of 0.5 keeps a half.
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  const double straight = std::pow(0.5, 2 / 0.5);
  expectBoth(scene, {{0, 0, 10}, {0, 0, -10}}, kColor * (1 - straight), straight);
  // Oblique, through the faces z = 1 and z = -1: longer by the ratio of length to depth.
  const double oblique = std::pow(0.5, 2 / 0.5 * std::hypot(0.6, 0.2, 4.0) / 4);
  expectBoth(scene, {{0.3, 0.1, 2}, {-0.3, -0.1, -2}}, kColor * (1 - oblique), oblique);
  // From within, and ending within.
  const double within = std::pow(0.5, 0.7 / 0.5);
  expectBoth(scene, {{0.1, 0, 0.4}, {0.1, 0, -0.3}}, kColor * (1 - within), within);
  // Shorter than a step.
  const double thin = std::pow(0.5, 0.003 / 0.5);
  expectBoth(scene, {{0.1, 0, 0.001}, {0.1, 0, -0.002}}, kColor * (1 - thin), thin);
  // Beside it.
  expectBoth(scene, {{1.01, 0, 10}, {1.01, 0, -10}}, glm::dvec3(0), 1);
}

TEST(AnalyticVolume, aLargerSceneLosesLightByTheGridsUnit) {
  VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  scene.worldFromIndex = glm::scale(glm::dmat4(1), glm::dvec3(30)) * scene.worldFromIndex;
  const double kept = std::pow(0.5, 2 / 0.5);
  expectBoth(scene, {{0, 0, 100}, {0, 0, -100}}, kColor * (1 - kept), kept);
}

TEST(AnalyticVolume, brightnessIsThatOfTheLengthOfABentRay) {
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  // In at z = 1, a corner of right angles at the middle, out at x = 1: as long as straight through.
  const double kept = std::pow(0.5, 2 / 0.5);
  expectBoth(scene, {{0, 0, 3}, {0, 0, 0}, {3, 0, 0}}, kColor * (1 - kept), kept);
  // Many corners within a step, along a zigzag of known length.
  RayPath zigzag{{0, 0, 0.5}};
  double length = 0;
  for (int i = 0; i < 60; ++i) {
    zigzag.push_back({i % 2 == 0 ? 0.02f : 0.0f, 0, 0.5f - 0.01f * static_cast<float>(i + 1)});
    length += std::hypot(0.02, 0.01);
  }
  const double keptByZigzag = std::pow(0.5, length / 0.5);
  expectBoth(scene, zigzag, kColor * (1 - keptByZigzag), keptByZigzag);
  // Out of the box and in again.
  const double twice = std::pow(0.5, (0.5 + 0.25) / 0.5);
  expectBoth(scene, {{0, 0.5, 0}, {0, 1.5, 0}, {0.5, 1.5, 0}, {0.5, 0.75, 0}}, kColor * (1 - twice), twice);
}

TEST(AnalyticVolume, sphereLosesLightByItsChord) {
  // Distances from the middle, in voxels; all that is nearer than 40 has a transmittance of 0.99 a voxel. Trilinear
  // interpolation of a distance r is off by 2 / (8 r) at most, 0.006 voxels at the surface, which two passes of make a
  // transmittance of exp(-0.01 * 0.012), and the ray is not far from perpendicular to the surface.
  constexpr double kRadius = 40;
  const TransferFunction ball({{0, kColor, 0.01}, {kRadius, kColor, 0.01}, {kRadius, kColor, 0}}, 1);
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(96), 1, [](const glm::dvec3& p) { return glm::distance(p, glm::dvec3(47.5)); }, ball);
  for (const double offset : {0.0, 7.3, 20.0, 30.0}) {
    const double kept = std::pow(0.99, 2 * std::sqrt(kRadius * kRadius - offset * offset));
    expectBoth(scene, {{offset, 0, 200}, {offset, 0, -200}}, kColor * (1 - kept), kept);
  }
  expectBoth(scene, {{41, 0, 200}, {41, 0, -200}}, glm::dvec3(0), 1);
}

/// The integral of -ln(1 - o) from 0 to `opacity`.
double lossUpTo(double opacity) {
  return (1 - opacity) * std::log1p(-opacity) + opacity;
}

TEST(AnalyticVolume, rampOfOpacityHasAClosedForm) {
  // The value is the index i, 0 to 31, and the opacity of a length of 2 voxels grows with it up to 0.4. The half voxels
  // at the faces have the value of the outermost centres.
  constexpr double kLast = 31;
  const TransferFunction ramp({{0, kColor, 0}, {kLast, kColor, 0.4}}, 2);
  const VolumeScene scene = test::floatVolume(
      {32, 8, 8}, 1, [](const glm::dvec3& p) { return p.x; }, ramp);
  const double depth = (kLast / 0.4 * lossUpTo(0.4) - 0.5 * std::log1p(-0.4)) / 2;
  const double kept = std::exp(-depth);
  expectBoth(scene, {{-40, 0.3, 0.2}, {40, 0.3, 0.2}}, kColor * (1 - kept), kept);
  expectBoth(scene, {{40, 0.3, 0.2}, {-40, 0.3, 0.2}}, kColor * (1 - kept), kept);
  // Large steps take no harm, as the field is linear: that is what the table is for.
  expectBoth(scene, {{-40, 0.3, 0.2}, {40, 0.3, 0.2}}, kColor * (1 - kept), kept, 5);
}

TEST(AnalyticVolume, rampOfColorHasAClosedForm) {
  // Red grows from 0 to 1 over 31 voxels of one extinction e. Before the light that comes from x: exp(-e x). With
  // E = exp(-31 e), the integral of e (x / 31) exp(-e x) is (1 - E (1 + 31 e)) / (31 e); half voxels at both ends.
  const double e = 0.1;
  const TransferFunction ramp({{0, {0, 0, 1}, 1 - std::exp(-e)}, {31, {1, 0, 1}, 1 - std::exp(-e)}}, 1);
  const VolumeScene scene = test::floatVolume(
      {32, 8, 8}, 1, [](const glm::dvec3& p) { return p.x; }, ramp);
  const double through = std::exp(-31 * e);
  const double half = std::exp(-0.5 * e);
  const double red = half * (1 - through * (1 + 31 * e)) / (31 * e) + half * through * (1 - half);
  const double kept = std::exp(-32 * e);
  expectBoth(scene, {{-40, 0.3, 0.2}, {40, 0.3, 0.2}}, {red, 0, 1 - kept}, kept);
}

TEST(AnalyticVolume, aThinPeakIsNotMissedBetweenSamples) {
  // Opaque from 15.2 to 15.3 alone, which a step of two voxels jumps over. The peak has the same optical depth for any
  // step: its width is 0.1 voxels.
  const TransferFunction peak({{15.2, kColor, 0}, {15.2, kColor, 0.9}, {15.3, kColor, 0.9}, {15.3, kColor, 0}}, 0.1);
  const VolumeScene scene = test::floatVolume(
      {32, 8, 8}, 1, [](const glm::dvec3& p) { return p.x; }, peak);
  for (const double step : {0.25, 0.5, 1.0, 2.0}) {
    const VolumePixel pixel = VolumeRenderer(scene, toTheEnd(step)).pixel({{-40, 0.3, 0.2}, {40, 0.3, 0.2}});
    // The table spans 0.1 of values here, so its entries are fine.
    expectColor(pixel, kColor * 0.9, 0.1, "peak");
  }
}

TEST(AnalyticVolume, aPeakThinnerThanAnEntryKeepsItsOpacity) {
  // The table spans 31 values here, so its 2043 distances are 0.0152 wide: the peak has a thirtieth of one, at places
  // that are not the same between entries.
  constexpr double kWidth = 0.0005;
  for (int i = 0; i < 16; ++i) {
    const double first = 15.1 + 0.00173 * i;
    const TransferFunction peak({{0, kColor, 0},
                                 {first, kColor, 0},
                                 {first, kColor, 0.9},
                                 {first + kWidth, kColor, 0.9},
                                 {first + kWidth, kColor, 0},
                                 {31, kColor, 0}},
                                kWidth);
    const VolumeScene scene = test::floatVolume(
        {32, 8, 8}, 1, [](const glm::dvec3& p) { return p.x; }, peak);
    for (const double step : {0.25, 1.0}) {
      const VolumePixel pixel = VolumeRenderer(scene, toTheEnd(step)).pixel({{-40, 0.3, 0.2}, {40, 0.3, 0.2}});
      expectColor(pixel, kColor * 0.9, 0.1, "peak");
    }
  }
}

TEST(AnalyticVolume, theSurfaceOfWhatIsDenseHasItsColorForAnySteps) {
  // Red where it begins, at a value of 10.3, blue 20 voxels behind, and 92 optical depths a voxel, or more than a
  // square of single precision holds: what is seen is red, but for the share of the change that lies within the first
  // optical depths.
  for (const double length : {0.1, 1e-3, 1e-9, 1e-20}) {
    const TransferFunction dense({{10.3, {1, 0, 0}, 0}, {10.3, {1, 0, 0}, 0.9999}, {30.3, {0, 0, 1}, 0.9999}}, length);
    const VolumeScene scene = test::floatVolume(
        {32, 8, 8}, 1, [](const glm::dvec3& p) { return p.x; }, dense);
    const double blue = length / -std::log(1e-4) / 20;
    for (const double step : {0.0625, 0.25, 1.0, 4.0}) {
      const VolumePixel pixel = VolumeRenderer(scene, toTheEnd(step)).pixel({{-40, 0.3, 0.2}, {40, 0.3, 0.2}});
      // An entry of the table, of 0.01 values, mixes what is before 10.3 with what is behind it: up to 0.0005 of blue.
      for (const auto& [channel, expected] : {std::pair(0, 1 - blue), std::pair(1, 0.0), std::pair(2, blue)}) {
        EXPECT_NEAR(static_cast<double>(pixel.color[channel]), expected, 1e-3) << length << ", " << step;
      }
      EXPECT_NEAR(static_cast<double>(pixel.color.w), 1, kAnalytic) << length << ", " << step;
    }
  }
}

TEST(AnalyticVolume, depthIsWhereTheOpacityReachesItsThreshold) {
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  const RayPath ray{{0, 0, 10}, {0, 0, 0.2}, {5, 0, 0.2}};
  for (const double opacity : {0.1, 0.5, 0.8}) {
    // From z = 1 on, at t = 9.
    const double t = 9 + 0.5 * std::log(1 - opacity) / std::log(0.5);
    VolumeRenderOptions options = toTheEnd();
    options.depthOpacity = opacity;
    const VolumePixel pixel = VolumeRenderer(scene, options).pixel(ray);
    EXPECT_NEAR(static_cast<double>(pixel.t), t, kAnalytic);
    EXPECT_NEAR(static_cast<double>(VolumeReference(scene, 1.0 / 64, opacity).pixel(ray).t), t, kAnalytic);
  }
}

/// The length of a ray within the box of a volume, by other code than the renderers'.
double lengthWithin(const Box& box, const RayPath& ray) {
  double length = 0;
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    if (const auto part = partWithin(box, glm::dvec3(ray[i]), glm::dvec3(ray[i + 1]))) {
      length += (part->last - part->first) * glm::distance(glm::dvec3(ray[i]), glm::dvec3(ray[i + 1]));
    }
  }
  return length;
}

template <class C>
void expectEvenMedium(const C& camera, const char* name) {
  // A fog that all rays bend in.
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(40, 40, 60), 0.25, [](auto) { return 1; }, test::everywhere(0.1, 1));
  const VolumeImage image = renderVolume(camera, scene, toTheEnd());
  const Box box = scene.bounds();
  double worst = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const RayPath ray = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      const double opacity = 1 - std::pow(0.9, lengthWithin(box, ray));
      worst = std::max(worst, std::abs(static_cast<double>(image(x, y).color.w) - opacity));
    }
  }
  EXPECT_LT(worst, kAnalytic) << name;
}

TEST(AnalyticVolume, anEvenMediumIsEvenWhereRaysBend) {
  expectEvenMedium(test::smallCamera(), "pinhole");
  expectEvenMedium(test::crossroads(), "graph");
  expectEvenMedium(test::bendingTwice(), "curved");
  expectEvenMedium(test::bendingTwice(test::smallCamera(), ArcModel::kBezier), "curved, Bezier");
}

TEST(AnalyticVolume, neighboursDoNotBandWhereRaysBend) {
  // In a slope of fog, brightness changes smoothly from pixel to pixel along a row: where samples fall does not show.
  VolumeScene scene = test::floatVolume(
      glm::ivec3(40, 40, 60), 0.25, [](const glm::dvec3& p) { return p.z; },
      TransferFunction({{0, kColor, 0.02}, {59, kColor, 0.2}}, 1));
  const VolumeImage image = renderVolume(test::bendingTwice(), scene, toTheEnd(1.7));
  for (int x = 2; x + 2 < image.width(); ++x) {
    const auto at = [&](int i) { return static_cast<double>(image(i, 30).color.w); };
    // Third differences of a smooth curve that changes by less than 1 over 90 pixels; a band of one part in a
    // thousand would be 3e-3.
    const double third = at(x + 1) - 3 * at(x) + 3 * at(x - 1) - at(x - 2);
    EXPECT_LT(std::abs(third), 1e-3) << x;
  }
}

}  // namespace
}  // namespace ocelli
