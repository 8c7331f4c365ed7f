#include "oc_core/ocri/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/image/color.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

constexpr int kSourceWidth = 360;
constexpr int kSourceHeight = 240;

const Mesh& statues() {
  static const Mesh mesh = loadScene("builtin:statues");
  return mesh;
}

View usualView() {
  View view;
  view.fovVerticalDegrees = 12;
  return view;
}

CameraChoice gpcChoice(const GpcLayout& layout) {
  CameraChoice choice = cameraChoice("gpc");
  choice.gpc = layout;
  return choice;
}
GpcLayout centred(float zoom) {
  return {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.5f, 0.5f}, zoom, 1}}};
}
ReferenceImages imagesOf(const CameraChoice& choice, const View& view, const Mesh& mesh) {
  return buildReferenceImages(choice, PinholeCamera(view, kSourceWidth, kSourceHeight), mesh);
}

View zoomed(View view, double factor) {
  view.fovVerticalDegrees =
      degreesFromRadians(2 * std::atan(std::tan(radiansFromDegrees(view.fovVerticalDegrees / 2)) / factor));
  return view;
}

/// Averages of 16 samples a pixel, as a picture should be.
Image<glm::vec3> directly(const PinholeCamera& camera, const Mesh& mesh) {
  constexpr int kSide = 4;
  const PinholeCamera fine(camera.view(), camera.width() * kSide, camera.height() * kSide);
  const Image<glm::vec3> all = colorImage(rasterize(fine, mesh), mesh, glm::vec3(0));
  Image<glm::vec3> color(camera.width(), camera.height(), glm::vec3(0));
  for (int y = 0; y < all.height(); ++y) {
    for (int x = 0; x < all.width(); ++x) {
      color(x / kSide, y / kSide) += all(x, y) / float(kSide * kSide);
    }
  }
  return color;
}

/// Of sRGB values, over the pixels that are no holes.
double psnr(const ResampledView& view, const Image<glm::vec3>& expected) {
  const auto encoded = [](const glm::vec3& c) {
    return glm::vec3(srgbFromLinear(c.x), srgbFromLinear(c.y), srgbFromLinear(c.z));
  };
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (view.hole[i] == 0) {
      const glm::vec3 d = encoded(view.color[i]) - encoded(expected[i]);
      sum += double(glm::dot(d, d)) / 3;
      ++count;
    }
  }
  return -10 * std::log10(sum / double(count));
}

TEST(Resample, theSameViewGivesTheSamePixels) {
  const ReferenceImages images = imagesOf(cameraChoice("di"), usualView(), statues());
  const ResampledView view = resample(images, images[0].reference());
  EXPECT_FALSE(view.isWarped);
  EXPECT_EQ(view.color, images[0].color);
  EXPECT_EQ(view.holes(), 0);
  EXPECT_EQ(view.coarse, 0);
  EXPECT_NEAR(view.leastRate, 1, 1e-9);
}

// As far into the region as it zooms, pixels are its samples again.
TEST(Resample, aZoomIntoARegionGivesItsSamples) {
  const ReferenceImages images = imagesOf(gpcChoice(centred(4)), usualView(), statues());
  const ResampledView view = resample(images, PinholeCamera(zoomed(usualView(), 4), kSourceWidth, kSourceHeight));
  size_t compared = 0;
  for (int y = kSourceHeight / 4 + 1; y < kSourceHeight * 3 / 4 - 1; ++y) {
    for (int x = kSourceWidth / 4 + 1; x < kSourceWidth * 3 / 4 - 1; ++x) {
      // Fields of view are rounded: between neighbours of the greatest contrast by a thousandth of a pixel.
      ASSERT_LT(glm::distance(view.color(x, y), images[0].color(x, y)), 2e-3f) << x << ", " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20000u);
  EXPECT_EQ(view.holes(), 0);
}

// The reason for the camera: with as many samples, a zoom shows what is there.
TEST(Resample, zoomingIntoAGeneralPinholeBeatsAPinhole) {
  // Within the region, whose middle it looks beside, and a little rolled.
  View turned = zoomed(usualView(), 8);
  turned.target = {0.03f, -0.04f, 0};
  turned.up = {0.1f, 1, 0};
  const PinholeCamera output(turned, kSourceWidth, kSourceHeight);
  const Image<glm::vec3> expected = directly(output, statues());
  const double ofPinhole = psnr(resample(imagesOf(cameraChoice("di"), usualView(), statues()), output), expected);
  const ResampledView view = resample(imagesOf(gpcChoice(centred(8)), usualView(), statues()), output);
  const double ofGpc = psnr(view, expected);
  EXPECT_EQ(view.holes(), 0);
  EXPECT_GT(ofGpc, ofPinhole + 2) << ofPinhole;
  RecordProperty("psnr", testing::PrintToString(std::pair(ofPinhole, ofGpc)));
}

// Turned and out of the image at one side. The colours of samples are those of points, so edges differ.
TEST(Resample, aRotationAgainstADirectRendering) {
  View wide = usualView();
  wide.fovVerticalDegrees = 25;
  const ReferenceImages images = imagesOf(cameraChoice("di"), wide, statues());
  View turned = usualView();
  turned.target = {0.3f, 0.2f, 0};
  turned.up = {0.2f, 1, 0};
  const PinholeCamera output(turned, 180, 120);
  const ResampledView view = resample(images, output);
  EXPECT_FALSE(view.isWarped);
  EXPECT_EQ(view.holes(), 0);
  EXPECT_GT(psnr(view, directly(output, statues())), 24);
  turned.target = {4, 0, 0};
  EXPECT_GT(resample(images, PinholeCamera(turned, 180, 120)).holes(), 0.2) << "beyond the border";
}

TEST(Resample, manySamplesForAPixelAreAveraged) {
  const ReferenceImages images = imagesOf(cameraChoice("di"), usualView(), statues());
  const PinholeCamera small(usualView(), kSourceWidth / 4, kSourceHeight / 4);
  const ResampledView view = resample(images, small);
  EXPECT_NEAR(view.leastRate, 4, 1e-9);
  // Four by four pixels of the image are each of these.
  for (int y = 0; y < small.height(); y += 7) {
    for (int x = 0; x < small.width(); x += 7) {
      glm::vec3 sum(0);
      for (int i = 0; i < 16; ++i) {
        sum += images[0].color(4 * x + i % 4, 4 * y + i / 4) / 16.0f;
      }
      ASSERT_LT(glm::distance(view.color(x, y), sum), 1e-5f);
    }
  }
}

// Holes are what the image has not seen, as rays tell, and the rest is what is there.
TEST(Resample, aTranslationWarpsByDepth) {
  for (const bool isGpc : {false, true}) {
    const View from = usualView();
    const ReferenceImages images = imagesOf(isGpc ? gpcChoice(centred(2)) : cameraChoice("di"), from, statues());
    const PinholeCamera output(movedEye(from, {0.5f, 0.2f, 0}), kSourceWidth, kSourceHeight);
    ResampledView view = resample(images, output);
    EXPECT_TRUE(view.isWarped);
    const FragmentImage seen = rasterize(output, statues());
    const RayScene rays(statues());
    size_t covered = 0;
    size_t hidden = 0;  ///< from the image's eye, of what the output sees
    size_t found = 0;
    size_t wrong = 0;
    for (int y = 0; y < output.height(); ++y) {
      for (int x = 0; x < output.width(); ++x) {
        const Fragment& f = seen(x, y);
        if (!f.covered()) {
          continue;  // what is hidden of the surroundings of the scene is unknown too
        }
        const glm::vec3 p = positionOf(f, statues());
        const Fragment first = rays.intersect({from.eye, p + (p - from.eye) * 0.001f});
        const bool isHidden =
            first.covered() && glm::distance(positionOf(first, statues()), p) > 0.01f * glm::distance(p, from.eye);
        ++covered;
        hidden += isHidden;
        found += isHidden && view.hole(x, y) != 0;
        wrong += !isHidden && view.hole(x, y) != 0;
      }
    }
    EXPECT_GT(hidden, 200u) << isGpc;
    EXPECT_GT(double(found), 0.5 * double(hidden)) << isGpc << ": the rest is less than a sample wide";
    // At rims and on grazing surfaces samples are farther apart than pixels.
    EXPECT_LT(double(wrong), 0.01 * double(covered)) << isGpc;
    EXPECT_GT(psnr(view, directly(output, statues())), 20) << isGpc;
  }
}

TEST(Resample, otherReferenceImagesAreWarped) {
  for (const char* name : {"ddoc", "di+spoc", "eoc-h"}) {
    const ReferenceImages images = imagesOf(cameraChoice(name), usualView(), statues());
    const ResampledView view = resample(images, PinholeCamera(usualView(), 180, 120));
    EXPECT_TRUE(view.isWarped) << name;
    EXPECT_GT(psnr(view, directly(PinholeCamera(usualView(), 180, 120), statues())), 15) << name;
  }
}

TEST(Resample, panoramasAreWarped) {
  View within = usualView();
  within.fovVerticalDegrees = 12;
  const ReferenceImages images =
      buildReferenceImages(cameraChoice("panorama"), PinholeCamera(within, 1440, 720), statues());
  const ResampledView view = resample(images, PinholeCamera(within, 36, 24));
  EXPECT_TRUE(view.isWarped);
  EXPECT_GT(psnr(view, directly(PinholeCamera(within, 36, 24), statues())), 15);
}

}  // namespace
}  // namespace ocelli
