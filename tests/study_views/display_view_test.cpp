// A display before which the head moves: which image shows when, what it is made of, and what is made beforehand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "oc_core/image/color.h"
#include "oc_core/render/identity_image.h"
#include "study/task/task.h"
#include "study/task/trial_image.h"
#include "study/views/display_light.h"
#include "tests/study_views/view_examples.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr TrialScreen kDisplayScreen{256, 160, 60};
constexpr int64_t kQuarter = kTicksPerSecond;  // of a sway of 4 s: the right end

/// The ball and the cube of viewScene() lie within 4 m of the middle, 7.5 m ahead.
std::string displayJson(const std::string& more = "") {
  return R"({"kind": "display", "profile": "test", "distance_meters": 7.5, "radius_meters": 4)" + more + "}";
}
const std::string kSway = R"(, "head": {"sway_degrees": 15, "seconds": 4, "images": 7})";

class DisplayView : public testing::Test {
 protected:
  TrialLayout layout(const std::string& json, int64_t tick = 0) const {
    TrialLayout layout = layoutOf(scene_);
    layout.views = readView(json)->views(viewVantage());
    layout.tick = tick;
    return layout;
  }
  Image<Rgb8> image(const std::string& json, int64_t tick = 0) const {
    return viewsOf(layout(json, tick), kDisplayScreen, rasterizeStudy);
  }

  const StudyScene scene_ = viewScene();
};

double meanLight(const Image<Rgb8>& image) {
  double sum = 0;
  for (const Rgb8& pixel : image) {
    sum += 0.2126 * linearFromSrgbByte(pixel.x) + 0.7152 * linearFromSrgbByte(pixel.y) +
           0.0722 * linearFromSrgbByte(pixel.z);
  }
  return sum / static_cast<double>(image.size());
}

TEST_F(DisplayView, AtRestIsThatOfAnEyeThatRests) {
  EXPECT_EQ(image(displayJson(kSway)), image(displayJson()));
  EXPECT_EQ(image(displayJson(kSway), 2 * kQuarter), image(displayJson()));
}

TEST_F(DisplayView, FollowsTheTick) {
  const Image<Rgb8> rest = image(displayJson(kSway));
  const Image<Rgb8> right = image(displayJson(kSway), kQuarter);
  const Image<Rgb8> left = image(displayJson(kSway), 3 * kQuarter);
  EXPECT_NE(right, rest);
  EXPECT_NE(left, rest);
  EXPECT_NE(left, right);
  EXPECT_EQ(image(displayJson(kSway), 5 * kQuarter), right);
  EXPECT_EQ(image(displayJson(kSway), 1), rest) << "between poses the nearest shows";
  EXPECT_EQ(image(displayJson(), kQuarter), rest) << "an eye that rests does so at any tick";
}

// From the right, what is nearer than the middle is seen farther to the left, and what is farther away to the right.
TEST_F(DisplayView, NearThingsMoveAgainstTheHead) {
  const auto middleOf = [&](int64_t tick, uint32_t object) {
    for (const ObjectSighting& each :
         sightings(objectsIn(layout(displayJson(kSway), tick), layout(displayJson(kSway), tick).views.front()))) {
      if (each.object == object) {
        return each.centroid.x;
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  // The ball stands 6 m ahead, the cube 9 m.
  EXPECT_LT(middleOf(kQuarter, 1), middleOf(0, 1) - 2);
  EXPECT_GT(middleOf(kQuarter, 2), middleOf(0, 2) + 2);
}

TEST_F(DisplayView, ARepresentationMadeAtRestShowsGapsBeside) {
  const auto litOf = [&](const std::string& more, int64_t tick) {
    const Image<Rgb8> shown = image(displayJson(kSway + more), tick);
    size_t lit = 0;
    for (const Rgb8& pixel : shown) {
      lit += pixel != Rgb8(0) ? 1 : 0;
    }
    return lit;
  };
  const std::string rest = R"(, "camera": "di", "made_at": "rest")";
  const std::string each = R"(, "camera": "di", "made_at": "each")";
  EXPECT_EQ(image(displayJson(kSway + rest)), image(displayJson(kSway + R"(, "camera": "di")")));
  EXPECT_NE(image(displayJson(kSway + rest), kQuarter), image(displayJson(kSway + each), kQuarter));
  EXPECT_LT(litOf(rest, kQuarter), litOf("", kQuarter)) << "the whole geometry has more to shine";
}

// Of what an eye sees from where the representation was made, one made for each pose is the same.
TEST_F(DisplayView, MadeForEachPoseIsThatOfThePose) {
  EXPECT_EQ(image(displayJson(kSway + R"(, "camera": "di", "made_at": "each")")),
            image(displayJson(kSway + R"(, "camera": "di", "made_at": "rest")")));
}

TEST_F(DisplayView, PreparedImagesAreTheSame) {
  const std::string json = displayJson(kSway);
  TrialLayout prepared = layout(json);
  double last = 0;
  prepared.views.front().prepare(prepared, [&](std::string_view, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  EXPECT_EQ(last, 1);
  for (int64_t tick = 0; tick < 4 * kQuarter; tick += 60) {
    prepared.tick = tick;
    EXPECT_EQ(viewsOf(prepared, kDisplayScreen, rasterizeStudy), image(json, tick));
  }
}

// A trial makes a scene of its own that looks the same: it finds what was made beforehand.
TEST_F(DisplayView, ScenesThatLookTheSameShareImages) {
  const std::shared_ptr<const SceneView> view = readView(displayJson(kSway));
  TrialLayout first = layoutOf(scene_);
  first.views = view->views(viewVantage());
  first.views.front().prepare(first, {});
  const StudyScene other = viewScene();
  TrialLayout second = layoutOf(other);
  second.views = view->views(viewVantage());
  second.tick = kQuarter;
  second.views.front().prepare(second, {});
  first.tick = kQuarter;
  EXPECT_EQ(viewsOf(second, kDisplayScreen, rasterizeStudy), viewsOf(first, kDisplayScreen, rasterizeStudy));
}

TEST_F(DisplayView, TakesTheMeanLightThatIsAskedFor) {
  for (const char* camera : {"", R"(, "camera": "di")"}) {
    const Image<Rgb8> shown = image(displayJson(kSway + R"(, "mean_luminance": 0.01)" + camera));
    // The view has 240 x 150 of the screen's pixels; bytes of sRGB move dark light by up to some percent.
    const double share = 240.0 * 150 / (256 * 160);
    EXPECT_NEAR(meanLight(shown), 0.01 * share, 0.0005 * share) << camera;
  }
}

TEST(GainForMean, ByHand) {
  Image<glm::vec3> light(4, 1, glm::vec3(0));
  light[0] = glm::vec3(1);
  light[1] = glm::vec3(0.5f);
  // Both below white: (1 + 0.5) g / 4 = 0.15.
  EXPECT_NEAR(gainForMean(light, 0.15), 0.4, 1e-9);
  // The first is cut off at white: (1 + 0.5 g) / 4 = 0.4.
  EXPECT_NEAR(gainForMean(light, 0.4), 1.2, 1e-9);
  // More than both can send, 0.5: 99 % of that.
  EXPECT_NEAR(gainForMean(light, 0.9), 2 * (4 * 0.99 * 0.5 - 1), 1e-6);
  EXPECT_EQ(gainForMean(Image<glm::vec3>(3, 3, glm::vec3(0)), 0.1), 1);
}

TEST_F(DisplayView, ImagesOfFewerRowsAreScaled) {
  const Image<Rgb8> full = image(displayJson());
  const Image<Rgb8> scaled = image(displayJson(R"(, "image_rows": 75)"));
  EXPECT_NE(full, scaled);
  // The gain of either takes its own 99th percentile to white, so that their means differ by some percent.
  EXPECT_NEAR(meanLight(scaled), meanLight(full), 0.25 * meanLight(full));
  EXPECT_EQ(image(displayJson(R"(, "image_rows": 150)")), full);
}

TEST_F(DisplayView, SaysWhatItReaches) {
  const std::shared_ptr<const SceneView> view = readView(displayJson());
  const PinholeCamera eye = viewVantage().pinholes.front().camera;
  const auto around = [](const glm::vec3& middle) { return Box{middle - 0.1f, middle + 0.1f}; };
  const glm::vec3 center = eye.eye() + 7.5f * eye.forward();
  EXPECT_TRUE(view->reaches(eye, around(center)));
  EXPECT_TRUE(view->reaches(eye, around(center + 3.8f * eye.forward())));
  EXPECT_FALSE(view->reaches(eye, around(center + 4.0f * eye.forward())));
  EXPECT_TRUE(readView(R"("pinhole")")->reaches(eye, around(center + 50.0f)));
  EXPECT_FALSE(view->movesEye());
  EXPECT_TRUE(readView(displayJson(kSway))->movesEye());
}

TEST(DisplayViewOptions, SaysWhatIsWrong) {
  EXPECT_THAT(errorOfView(displayJson(R"(, "made_at": "rest")")), HasSubstr("made_at"));
  EXPECT_THAT(errorOfView(displayJson(R"(, "camera": "di", "made_at": "each")")), HasSubstr("\"head\""));
  EXPECT_THAT(errorOfView(displayJson(kSway + R"(, "camera": "di", "made_at": "here")")), HasSubstr("made_at"));
  EXPECT_THAT(errorOfView(displayJson(R"(, "mean_luminance": 0.9)")), HasSubstr("mean_luminance"));
  EXPECT_THAT(errorOfView(displayJson(R"(, "image_rows": 10)")), HasSubstr("image_rows"));
  EXPECT_THAT(errorOfView(displayJson(R"(, "head": {"sway_degrees": 5, "speed": 1})")), HasSubstr("speed"));
}

}  // namespace
}  // namespace ocelli::test
