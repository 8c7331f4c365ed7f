// What the kinds show, compared with what shows the same in a simpler way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"
#include "tests/study_views/view_examples.h"

namespace ocelli::test {
namespace {

constexpr TrialScreen kKindScreen{256, 160, 60};

Image<Rgb8> imageOf(const StudyScene& scene, const std::vector<TrialLayout::View>& views) {
  TrialLayout layout = layoutOf(scene);
  layout.views = views;
  return viewsOf(layout, kKindScreen, rasterizeStudy);
}

double shareOfEqual(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  size_t equal = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    equal += a[i] == b[i] ? 1 : 0;
  }
  return static_cast<double>(equal) / static_cast<double>(a.size());
}

PinholeCamera movedPinhole(const glm::vec3& by) {
  const PinholeCamera camera = viewVantage().pinholes.front().camera;
  View view = camera.view();
  const glm::vec3 step = by.x * camera.right() - by.y * camera.down() - by.z * camera.forward();
  view.eye += step;
  view.target += step;
  return {view, camera.width(), camera.height()};
}

TEST(OcriView, OfTheWholeGeometryIsWhatTheMovedEyeSees) {
  const StudyScene scene = viewScene();
  const auto view = readView(R"({"kind": "ocri", "camera": "geometry", "eye_offset_meters": [0.4, 0.2, -0.3]})");
  std::vector<TrialLayout::View> direct;
  direct.emplace_back(viewVantage().pinholes.front().place, movedPinhole({0.4f, 0.2f, -0.3f}));
  EXPECT_EQ(imageOf(scene, view->views(viewVantage())), imageOf(scene, direct));
}

TEST(OcriView, OfADepthImageLacksWhatItsEyeDidNotSee) {
  const StudyScene scene = viewScene();
  std::vector<TrialLayout::View> direct;
  direct.emplace_back(viewVantage().pinholes.front().place, movedPinhole({0.3f, 0, 0}));
  const Image<Rgb8> truth = imageOf(scene, direct);
  const Rgb8 sky = srgbFromLinear(Image<glm::vec3>(1, 1, skyColor()))(0, 0);
  /// Where the sky shows through what the eye had not seen from where it was before.
  const auto holesOf = [&](const std::string& camera) {
    const auto view = readView(R"({"kind": "ocri", "camera": ")" + camera +
                               R"(", "eye_offset_meters": [0.3, 0, 0], "image_scale": 2})");
    const Image<Rgb8> image = imageOf(scene, view->views(viewVantage()));
    size_t holes = 0;
    // Away from the sides, beyond which no image reaches.
    for (int y = 0; y < image.height(); ++y) {
      for (int x = image.width() / 4; x < image.width() * 3 / 4; ++x) {
        holes += image(x, y) == sky && truth(x, y) != sky ? 1 : 0;
      }
    }
    return 2 * static_cast<double>(holes) / static_cast<double>(image.size());
  };
  const double depthImage = holesOf("di");
  EXPECT_GT(depthImage, 0.005);
  EXPECT_LT(holesOf("ddoc"), depthImage / 2);
}

TEST(CameraView, OfTheDepthImageIsThePinholesImage) {
  const StudyScene scene = viewScene();
  const Image<Rgb8> pinhole = imageOf(scene, readView(R"("pinhole")")->views(viewVantage()));
  const Image<Rgb8> image = imageOf(scene, readView(R"({"kind": "camera", "camera": "di"})")->views(viewVantage()));
  EXPECT_GT(shareOfEqual(image, pinhole), 0.999);
}

TEST(CameraView, KnowsObjectsAsThePinholeDoes) {
  const StudyScene scene = viewScene();
  TrialLayout layout = layoutOf(scene);
  layout.views = readView(R"("pinhole")")->views(viewVantage());
  const Image<uint32_t> truth = objectsIn(layout, layout.views.front());
  for (const char* json : {R"({"kind": "camera", "camera": "di"})",
                           R"({"kind": "ocri", "camera": "di", "eye_offset_meters": [0, 0, 0]})"}) {
    layout.views = readView(json)->views(viewVantage());
    const Image<uint32_t> objects = objectsIn(layout, layout.views.front());
    size_t differ = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      differ += (truth[i] == kNothing ? kStructure : truth[i]) != (objects[i] == kNothing ? kStructure : objects[i]);
    }
    EXPECT_LT(static_cast<double>(differ) / static_cast<double>(truth.size()), 0.01) << json;
  }
}

TEST(CameraView, SaysWhereItsObjectsStand) {
  const StudyScene scene = viewScene();
  TrialLayout layout = layoutOf(scene);
  layout.views = readView(R"({"kind": "camera", "camera": "panorama"})")->views(viewVantage());
  const std::shared_ptr<const ShownContent> shown = shownIn(layout, layout.views.front());
  const auto& image = std::get<ShownImage>(*shown);
  size_t seen = 0;
  for (size_t i = 0; i < image.objects.size(); ++i) {
    if (image.objects[i] == 1) {
      const Box& box = scene.boxOf(0);
      EXPECT_LT(glm::distance(image.positions[i], (box.lower + box.upper) / 2.0f), glm::distance(box.lower, box.upper));
      ++seen;
    }
  }
  EXPECT_GT(seen, 5u);
}

// A matrix of pinholes has up to a hundred panes, and each frame asks for all of them.
TEST(MadeView, KeepsAllPanesOfAMoment) {
  const StudyScene scene = viewScene();
  TrialLayout layout = layoutOf(scene);
  Vantage vantage = viewVantage({0, 0, 640, 400});
  const View first = vantage.pinholes.front().camera.view();
  for (int i = 1; i < 40; ++i) {
    View turned = first;
    turned.target.z += 0.01f * static_cast<float>(i);
    vantage.pinholes.push_back({{0, 0, 640, 400}, PinholeCamera(turned, 640, 400)});
  }
  layout.views = readView(R"({"kind": "camera", "camera": "di"})")->views(vantage);
  std::vector<std::shared_ptr<const ShownContent>> shown;
  for (const TrialLayout::View& view : layout.views) {
    shown.push_back(shownIn(layout, view));
  }
  for (size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shownIn(layout, layout.views[i]), shown[i]) << "made again";
  }
}

TEST(PanesView, TheMiddleOneLooksAhead) {
  const StudyScene scene = viewScene();
  const auto panes = readView(R"({"kind": "panes", "headings_degrees": [-90, 0, 90]})")->views(viewVantage());
  ASSERT_EQ(panes.size(), 3u);
  const auto forwardOf = [&](size_t i) { return std::get<PinholeCamera>(panes[i].camera).forward(); };
  const PinholeCamera ahead = viewVantage().pinholes.front().camera;
  EXPECT_NEAR(static_cast<double>(glm::dot(forwardOf(1), ahead.forward())), 1, 1e-6);
  EXPECT_NEAR(static_cast<double>(glm::dot(forwardOf(2), ahead.right())), 1, 1e-6);
  EXPECT_NEAR(static_cast<double>(glm::dot(forwardOf(0), ahead.right())), -1, 1e-6);
  for (const TrialLayout::View& pane : panes) {
    EXPECT_EQ(pane.place.width, std::get<PinholeCamera>(pane.camera).width());
    // As wide a field as the task's own camera.
    EXPECT_NEAR(pane.place.width / static_cast<double>(std::get<PinholeCamera>(pane.camera).focalPixels()),
                240.0 / static_cast<double>(ahead.focalPixels()), 1e-4);
  }
  EXPECT_LT(panes[0].place.right(), panes[1].place.left + 1e-9);
}

}  // namespace
}  // namespace ocelli::test
