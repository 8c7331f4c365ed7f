#include "oc_core/remote/remote_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"
#include "oc_core/camera/gpc_map.h"
#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {
namespace {

RemoteRequest wideRequest() {
  RemoteRequest request;
  request.view.eye = {0.3f, 0.2f, 2};
  request.view.fovVerticalDegrees = 50;
  return request;
}

RemoteSettings plainSettings() {
  RemoteSettings settings;
  settings.reach = 1.4;
  settings.size = 2;
  settings.zoom = 2;
  settings.middle = 0.5;
  return settings;
}

/// Samples of the image for each pixel of the screen where a direction meets both, in the direction that has fewest.
double samplesPerScreenPixel(const RemotePlan& plan, const RemoteRequest& request, const glm::dvec2& screenShare) {
  const PinholeCamera screen(request.view, request.screen.x, request.screen.y);
  const glm::vec2 pixel(glm::vec2(screenShare) * glm::vec2(request.screen));
  const auto point = screen.unproject({pixel.x, pixel.y, 1});
  const ImagePoint q = *plan.reference.project(*point);
  const GpcMap map(plan.layout, plan.reference.width(), plan.reference.height());
  const double rate = map.rateAt(map.imageFromPinhole({q.u, q.v}));
  return rate * static_cast<double>(plan.reference.focalPixels()) / static_cast<double>(screen.focalPixels());
}

TEST(RemotePlan, LooksTheSameWayAndFartherToEachSide) {
  const RemoteRequest request = wideRequest();
  const RemotePlan plan = planRemoteImage(request, plainSettings());
  EXPECT_EQ(plan.reference.eye(), request.view.eye);
  EXPECT_EQ(plan.reference.view().target, request.view.target);
  // Half of 50 degrees and of what that is across, times 1.4; the focal length is a single float.
  EXPECT_NEAR(plan.reference.view().fovVerticalDegrees, 70, 1e-5);
  const double across = std::atan(std::tan(radiansFromDegrees(25)) * 1280 / 720);
  const double halfWidth = plan.reference.width() / 2.0 / static_cast<double>(plan.reference.focalPixels());
  EXPECT_NEAR(std::atan(halfWidth), 1.4 * across, 1e-3);  // the width is a whole number
}

TEST(RemotePlan, HasAsManySamplesAsItsSizeSays) {
  const RemoteRequest request = wideRequest();
  RemoteSettings settings = plainSettings();
  // size / reach beside the region, the zoom times that in it. Whole pixels: half of one of some 1500.
  EXPECT_NEAR(samplesPerScreenPixel(planRemoteImage(request, settings), request, {0.5, 0.5}), 2 * 2 / 1.4, 3e-3);
  settings.zoom = 1;
  const RemotePlan flat = planRemoteImage(request, settings);
  EXPECT_TRUE(flat.layout.regions.empty());
  EXPECT_NEAR(samplesPerScreenPixel(flat, request, {0.1, 0.9}), 2 / 1.4, 2e-3);
}

TEST(RemotePlan, HoldsTheLimits) {
  RemoteRequest request = wideRequest();
  request.screen = {4096, 4096};
  RemoteSettings settings = plainSettings();
  settings.size = 4;
  const RemotePlan large = planRemoteImage(request, settings);
  EXPECT_LE(int64_t{large.reference.width()} * large.reference.height(), kMaxCodedPixels);
  request.screen = {4096, 16};
  const RemotePlan flat = planRemoteImage(request, settings);
  EXPECT_LE(flat.reference.width(), kMaxCodedSide);
  request.view.fovVerticalDegrees = 178;
  EXPECT_NEAR(planRemoteImage(request, settings).reference.view().fovVerticalDegrees, 178, 1e-6);
}

TEST(RemotePlan, GivesLensesTheDetailThatTheyShow) {
  RemoteRequest request = wideRequest();
  request.lenses = {{.center = {0.25f, 0.3f}, .extent = {0.2f, 0.3f}, .zoom = 5, .transitionWidth = 0.5f},
                    {.center = {0.8f, 0.7f}, .extent = {0.2f, 0.2f}, .zoom = 3, .transitionWidth = 0.5f}};
  const RemotePlan plan = planRemoteImage(request, plainSettings());
  for (const GpcRegion& lens : request.lenses) {
    const glm::dvec2 inner = glm::dvec2(lens.extent) / static_cast<double>(lens.zoom) / 2.0 * 0.99;
    for (const glm::dvec2& corner : {glm::dvec2(0), inner, -inner}) {
      EXPECT_NEAR(samplesPerScreenPixel(plan, request, glm::dvec2(lens.center) + corner), lens.zoom, 0.01);
    }
  }
}

TEST(RemotePlan, ShearedViewsKeepTheirMiddle) {
  RemoteRequest request = wideRequest();
  request.view.centerShift = {0.4f, -0.2f};
  request.lenses = {{.center = {0.7f, 0.4f}, .extent = {0.1f, 0.1f}, .zoom = 6, .transitionWidth = 0.5f}};
  const RemotePlan plan = planRemoteImage(request, plainSettings());
  EXPECT_NEAR(samplesPerScreenPixel(plan, request, {0.7, 0.4}), 6, 0.02);
}

TEST(RemotePlan, AnyValidRequestHasAnImage) {
  RandomNumbers random(23);
  const auto between = [&](double least, double most) { return least + (most - least) * random.uniform(); };
  for (int round = 0; round < 300; ++round) {
    RemoteRequest request;
    request.view.eye = glm::vec3(glm::dvec3(between(-2, 2), between(-2, 2), between(1.1, 5)));
    request.view.fovVerticalDegrees = round % 3 == 0 ? between(0.001, 1) : between(1, 178);
    request.screen = {16 + static_cast<int>(random.below(4081)), 16 + static_cast<int>(random.below(4081))};
    request.lenses.resize(random.below(RemoteRequest::kMaxLenses + 1));
    for (GpcRegion& lens : request.lenses) {
      lens = {.center = {static_cast<float>(random.uniform()), static_cast<float>(random.uniform())},
              .extent = {static_cast<float>(between(0.001, 1)), static_cast<float>(between(0.001, 1))},
              .zoom = static_cast<float>(between(0.1, 64)),
              .transitionWidth = static_cast<float>(between(0.01, 3))};
    }
    RemoteSettings settings;
    settings.reach = between(1, 8);
    settings.size = between(0.1, 4);
    settings.zoom = between(1, 16);
    settings.middle = between(0.1, 0.9);
    EXPECT_NO_THROW(planRemoteImage(request, settings)) << jsonText(request) << jsonText(settings);
  }
}

TEST(RemotePlan, RefusesWhatIsNotValid) {
  RemoteSettings settings = plainSettings();
  settings.reach = 0.5;
  EXPECT_THROW(planRemoteImage(wideRequest(), settings), InputError);
  RemoteRequest request = wideRequest();
  request.view.fovVerticalDegrees = 1e-5;
  EXPECT_THROW(planRemoteImage(request, plainSettings()), InputError);
  request = wideRequest();
  request.screen = {5000, 100};
  EXPECT_THROW(planRemoteImage(request, plainSettings()), InputError);
  request = wideRequest();
  request.lenses.resize(RemoteRequest::kMaxLenses + 1);
  EXPECT_THROW(planRemoteImage(request, plainSettings()), InputError);
}

}  // namespace
}  // namespace ocelli
