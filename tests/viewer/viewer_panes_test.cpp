// What each pane shows.
#include <gtest/gtest.h>

#include "display_sim/viewer/pane_overlays.h"
#include "oc_core/image/color.h"
#include "tests/viewer/test_viewer.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::countDifferent;
using test::countNear;
using test::isNear;
using test::TestViewer;

constexpr int kRoundingOfColors = 3;  // lines are blended, half floats hold linear colours

class ViewerPanesTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, ViewerPanesTest, kOffscreenProviders, providerName);

/// Whether a pixel within two of an image point has this colour.
bool hasColorAround(const Image<Rgb8>& image, const ImagePoint& q, const Rgb8& color) {
  for (int y = static_cast<int>(q.v) - 2; y <= static_cast<int>(q.v) + 2; ++y) {
    for (int x = static_cast<int>(q.u) - 2; x <= static_cast<int>(q.u) + 2; ++x) {
      if (image.contains(x, y) && isNear(image(x, y), color, 40)) {
        return true;
      }
    }
  }
  return false;
}

TEST_P(ViewerPanesTest, theSceneHasItsCameraDrawnWhereItStands) {
  TestViewer test(GetParam());
  test.key(Key::kR);  // no rays in front
  const Image<Rgb8> image = test.paneImage(Pane::kScene);
  const PinholeCamera outside(test.viewer.state().scene.view, image.width(), image.height());
  const PinholeCamera reference(View{}, 180, 120);
  // The middle of an edge of the frustum, from the eye to the far corner: nearer than the scene.
  const glm::vec3 corner = reference.worldFromCamera(reference.cameraFromImage({0, 0, 5}));
  EXPECT_TRUE(hasColorAround(image, *outside.project(corner), bytesOf(kReferenceColor)));
  // The middle of an edge of the view cell.
  EXPECT_TRUE(hasColorAround(image, *outside.project({-0.8f, 0, 9.2f}), bytesOf(kCellColor)));
  test.key(Key::kX);
  EXPECT_FALSE(hasColorAround(test.paneImage(Pane::kScene), *outside.project({-0.8f, 0, 9.2f}), bytesOf(kCellColor)));
}

TEST_P(ViewerPanesTest, theSceneShowsBentRaysAndTheEye) {
  TestViewer test(GetParam());
  EXPECT_GT(test.viewer.facts().bentRays, 0U);
  EXPECT_GT(test.viewer.facts().straightRays, 0U);
  const size_t withRays = countNear(test.paneImage(Pane::kScene), bytesOf(kBentRayColor), 60);
  test.key(Key::kR);
  const size_t without = countNear(test.paneImage(Pane::kScene), bytesOf(kBentRayColor), 60);
  EXPECT_GT(withRays, without + 100);
  // Moving the eye moves it in the scene pane: the panes are linked.
  const Image<Rgb8> before = test.paneImage(Pane::kScene);
  test.key(Key::kRight);
  EXPECT_GT(countDifferent(before, test.paneImage(Pane::kScene)), 20U);
}

TEST_P(ViewerPanesTest, theReferenceImageShowsItsSamples) {
  TestViewer test(GetParam(), "builtin:room", "di");
  const PinholeCamera reference(View{}, 180, 120);
  const Mesh mesh = loadScene("builtin:room");
  const ReferenceImage expected = buildReferenceImages(cameraChoice("di"), reference, mesh).front();
  const Image<Rgb8> image = test.paneImage(Pane::kReference);
  const ImagePlacement placement =
      placeImage(test.viewer.state().reference, {180, 120}, {image.width(), image.height()});
  size_t samples = 0;
  for (int y = 20; y < 100; y += 7) {
    for (int x = 20; x < 160; x += 7) {
      if (expected.holds(x, y)) {
        const glm::ivec2 at(placement.paneFromImage(glm::vec2(x, y) + 0.5f));
        const glm::vec3 color = expected.color(x, y);
        const Rgb8 wanted(srgbByteFromLinear(color.x), srgbByteFromLinear(color.y), srgbByteFromLinear(color.z));
        EXPECT_TRUE(isNear(image(at.x, at.y), wanted, kRoundingOfColors)) << x << ' ' << y;
        ++samples;
      }
    }
  }
  EXPECT_GT(samples, 30U);
}

TEST_P(ViewerPanesTest, depthsRunFromLightToDark) {
  TestViewer test(GetParam(), "builtin:room", "di");
  test.key(Key::kQ);
  const ReferenceImage image =
      buildReferenceImages(cameraChoice("di"), {View{}, 180, 120}, loadScene("builtin:room"))[0];
  const ReferenceScale scale = scaleOf(image);
  const Image<Rgb8> pane = test.paneImage(Pane::kReference);
  const ImagePlacement placement = placeImage(test.viewer.state().reference, {180, 120}, {pane.width(), pane.height()});
  size_t nearest = 0;
  size_t farthest = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 180; ++x) {
      const glm::ivec2 at(placement.paneFromImage(glm::vec2(x, y) + 0.5f));
      if (image.t(x, y) == scale.nearest) {
        EXPECT_TRUE(isNear(pane(at.x, at.y), bytesOf(kRampLight), 2));
        ++nearest;
      }
      if (image.t(x, y) == scale.farthest) {
        EXPECT_TRUE(isNear(pane(at.x, at.y), bytesOf(kRampDark), 2));
        ++farthest;
      }
    }
  }
  EXPECT_GT(nearest, 0U);
  EXPECT_GT(farthest, 0U);
}

TEST_P(ViewerPanesTest, thePointerReadsASample) {
  TestViewer test(GetParam());
  const PaneLayout layout = test.layoutOf(Pane::kReference);
  test.player.play(MoveStep{test.at(Pane::kReference, layout.image.width / 2, layout.image.height / 2)});
  const auto picked = test.viewer.facts().picked;
  ASSERT_TRUE(picked.has_value());
  EXPECT_NEAR(picked->pixel.x, 90, 1);
  EXPECT_NEAR(picked->pixel.y, 60, 1);
  // Its ray is drawn in the scene pane.
  EXPECT_GT(countNear(test.paneImage(Pane::kScene), bytesOf(kPickedColor), 20), 50U);
  test.player.play(MoveStep{test.at(Pane::kDisplay, 10, 10)});
  EXPECT_FALSE(test.viewer.facts().picked.has_value());
}

TEST(SampleText, saysWhatTheSampleHolds) {
  ReferenceImage image = blankReferenceImage("di", {}, 2, 1);
  image.set(1, 0, 9.5f, {0.25f, 0.5f, 1});
  image.displacement(1, 0) = {12.25f, -0.001f};
  EXPECT_EQ(sampleText(image, {0, 0}), "pixel 0, 0: no sample");
  EXPECT_EQ(sampleText(image, {1, 0}), "pixel 1, 0: z 9.5000, displaced 12.25 0.00\ncolour 0.25 0.50 1.00 (linear)");
}

TEST_P(ViewerPanesTest, whatIsMissingIsCountedAndMarked) {
  TestViewer test(GetParam(), "builtin:statues", "di");
  const Mesh scene = loadScene("builtin:statues");
  const Mesh mesh = buildRepresentation(cameraChoice("di"), {View{}, 180, 120}, scene).mesh;
  const PinholeCamera camera(test.viewer.state().reconstruction.view, 180, 120);
  const MissingSamples expected =
      countMissing(compareFrames(camera, positionImage(camera, scene), positionImage(camera, mesh)));
  ASSERT_TRUE(test.viewer.facts().missing.has_value());
  EXPECT_GT(expected.thick, 0U);
  // The GPU snaps edges to a grid of its own: as in frame_comparison_draw_test.cpp, of a smaller image.
  constexpr double kMaxSamples = 3;
  EXPECT_NEAR(static_cast<double>(test.viewer.facts().missing->strict), static_cast<double>(expected.strict),
              kMaxSamples);
  EXPECT_NEAR(static_cast<double>(test.viewer.facts().missing->thick), static_cast<double>(expected.thick),
              kMaxSamples);
  EXPECT_NEAR(static_cast<double>(test.viewer.facts().missing->truth), static_cast<double>(expected.truth),
              kMaxSamples);
  EXPECT_GT(countNear(test.paneImage(Pane::kReconstruction), kMissingThickColor, 0), 20U);
  EXPECT_GT(countNear(test.paneImage(Pane::kReconstruction), kMissingColor, 0), 20U);
  // At the reference view next to nothing is missing.
  test.key(Key::kHome);
  EXPECT_LT(test.viewer.facts().missing->strictRatio(), expected.strictRatio() / 4);
}

TEST_P(ViewerPanesTest, theTruthIsTheScene) {
  TestViewer test(GetParam(), "builtin:room", "di");
  test.key(Key::kM);
  const Image<Rgb8> plain = test.paneImage(Pane::kReconstruction);
  test.key(Key::kM);
  ASSERT_EQ(test.viewer.state().reconstruction.content, ReconstructionShown::Content::kTruth);
  const Image<Rgb8> truth = test.paneImage(Pane::kReconstruction);
  const auto places = placesBeside({truth.width(), truth.height()}, 1.5, 1);
  const PinholeCamera camera(test.viewer.state().reconstruction.view, places[0].size.x, places[0].size.y);
  const Image<Rgb8> expected = renderFrame(camera, loadScene("builtin:room")).image;
  size_t different = 0;
  size_t compared = 0;
  const int captionHeight = 60;  // a text says what it is
  for (int y = captionHeight; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      different += !isNear(truth(x + places[0].corner.x, y + places[0].corner.y), expected(x, y), 1);
      ++compared;
    }
  }
  EXPECT_LT(static_cast<double>(different), 0.005 * static_cast<double>(compared));  // edges
  EXPECT_GT(countDifferent(plain, truth), 50U);
}

TEST(PlacesBeside, keepTheAspectAndFit) {
  for (const int count : {1, 2}) {
    for (const glm::ivec2 pane : {glm::ivec2(500, 300), glm::ivec2(300, 500), glm::ivec2(3, 3)}) {
      const auto places = placesBeside(pane, 1.5, count);
      ASSERT_EQ(places.size(), static_cast<size_t>(count));
      for (const auto& place : places) {
        EXPECT_GE(place.corner.x, 0);
        EXPECT_GE(place.corner.y, 0);
        EXPECT_LE(place.corner.x + place.size.x, pane.x);
        EXPECT_LE(place.corner.y + place.size.y, pane.y);
        EXPECT_NEAR(place.size.x, 1.5 * place.size.y, 1.5);
      }
    }
  }
}

TEST_P(ViewerPanesTest, blinkingShowsTheTruthHalfOfTheTime) {
  TestViewer test(GetParam(), "builtin:room", "di");
  test.key(Key::kB);
  const bool first = blinkShowsTruth(test.viewer.state());
  const Image<Rgb8> one = test.paneImage(Pane::kReconstruction);
  test.player.play(SecondsStep{0.5});
  EXPECT_NE(blinkShowsTruth(test.viewer.state()), first);
  EXPECT_GT(countDifferent(one, test.paneImage(Pane::kReconstruction)), 50U);
}

TEST_P(ViewerPanesTest, theDisplayShowsItsVolume) {
  TestViewer test(GetParam());
  const Image<Rgb8> image = test.paneImage(Pane::kDisplay);
  const auto lit = [](const Image<Rgb8>& picture) {
    return std::count_if(picture.begin(), picture.end(), [](const Rgb8& p) { return std::max({p.x, p.y, p.z}) > 60; });
  };
  EXPECT_GT(lit(image), 2000);
  // In slow motion there is less of it, and the screen, whose corner is where the angle says.
  test.key(Key::kSpace);
  for (int i = 0; i < 10; ++i) {
    test.key(Key::kComma);
  }
  test.key(Key::kPeriod, {.shift = true});
  const Image<Rgb8> slow = test.paneImage(Pane::kDisplay);
  EXPECT_LT(lit(slow), lit(image) / 2);
  const double t = radiansFromDegrees(test.viewer.state().display.sweepDegrees);
  const PinholeCamera camera(test.viewer.state().display.view, slow.width(), slow.height());
  for (const float outward : {-1.0f, 1.0f}) {
    const glm::vec3 edge(outward * std::cos(t), 0.5f, outward * std::sin(t));
    EXPECT_TRUE(hasColorAround(slow, *camera.project(edge), bytesOf(kDisplayColor)));
  }
  // The next slice is another image.
  test.key(Key::kPeriod, {.shift = true});
  EXPECT_GT(countDifferent(slow, test.paneImage(Pane::kDisplay)), 100U);
}

TEST_P(ViewerPanesTest, aDisplayThatRunsAtItsOwnSpeedStandsStill) {
  TestViewer test(GetParam());
  const Image<Rgb8> one = test.paneImage(Pane::kDisplay);
  const double angle = test.viewer.state().display.sweepDegrees;
  test.player.play(SecondsStep{0.2});
  EXPECT_NE(test.viewer.state().display.sweepDegrees, angle);
  EXPECT_EQ(countDifferent(one, test.paneImage(Pane::kDisplay)), 0U);
}

TEST(ShownSweep, fadesOverThePersistence) {
  const DisplayProfile profile = loadProfile("perspecta");  // 12 turns a second
  DisplayShown shown;
  shown.sweepDegrees = 90;
  shown.persistenceSeconds = 0.1;
  const ShownSweep steady = shownSweep(shown, profile);
  EXPECT_EQ(steady.window.fadeRadians, 0);
  EXPECT_NEAR(steady.window.sweptRadians, kPi, 1e-12);
  EXPECT_EQ(steady.gain, 1);
  shown.speed = 1.0 / 64;
  const ShownSweep slow = shownSweep(shown, profile);
  EXPECT_NEAR(slow.window.endRadians, kPi / 2, 1e-12);
  EXPECT_NEAR(slow.window.fadeRadians, 0.1 * 24 * kPi / 64, 1e-12);
  EXPECT_EQ(slow.gain, kMaxSlowMotionGain);
  shown.speed = kMinSpeed;
  EXPECT_NEAR(shownSweep(shown, profile).window.fadeRadians, kPi / 198, 1e-12);  // one slice
}

TEST(LooksSteady, onlyWhereNeitherScreenNorLightMoves) {
  const DisplayProfile profile = loadProfile("perspecta");  // a refresh takes 1/24 s
  DisplayShown shown;
  EXPECT_TRUE(looksSteady(shown, profile));
  shown.persistenceSeconds = 0.01;  // the light flickers
  EXPECT_FALSE(looksSteady(shown, profile));
  shown.persistenceSeconds = 5;
  EXPECT_TRUE(looksSteady(shown, profile));
  shown.speed = 0.5;  // the screen shows
  EXPECT_FALSE(looksSteady(shown, profile));
  shown.speed = 1;
  shown.running = false;
  EXPECT_FALSE(looksSteady(shown, profile));
}

TEST_P(ViewerPanesTest, anEyeInTheDisplayIsSaidSo) {
  TestViewer test(GetParam());
  test.key(Key::k4);
  for (int i = 0; i < 30; ++i) {
    test.key(Key::kEqual);
  }
  EXPECT_NE(test.viewer.facts().displayProblem, "");
  test.key(Key::kHome);
  EXPECT_EQ(test.viewer.facts().displayProblem, "");
}

}  // namespace
}  // namespace ocelli
