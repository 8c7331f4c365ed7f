// What every kind of view keeps to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"
#include "study/views/view_registry.h"
#include "tests/study_views/view_examples.h"

namespace ocelli::test {
namespace {

constexpr TrialScreen kViewScreen{256, 160, 60};

class ViewContract : public testing::TestWithParam<ViewExample> {
 protected:
  TrialLayout layout() const {
    TrialLayout layout = layoutOf(scene_);
    layout.views = view_->views(vantage_);
    return layout;
  }

  const StudyScene scene_ = viewScene();
  const Vantage vantage_ = viewVantage();
  const std::shared_ptr<const SceneView> view_ = readView(GetParam().json);
};

TEST_P(ViewContract, PlacesLieWithinThoseOfTheTask) {
  const PixelRect& all = vantage_.pinholes.front().place;
  const TrialLayout layout = this->layout();
  ASSERT_FALSE(layout.views.empty());
  for (const TrialLayout::View& each : layout.views) {
    EXPECT_GE(each.place.left, all.left);
    EXPECT_GE(each.place.top, all.top);
    EXPECT_LE(each.place.right(), all.right());
    EXPECT_LE(each.place.bottom(), all.bottom());
    const Image<uint32_t> objects = objectsIn(layout, each);
    EXPECT_EQ(objects.width(), each.place.width);
    EXPECT_EQ(objects.height(), each.place.height);
  }
}

TEST_P(ViewContract, ShowsTheObjects) {
  const TrialLayout layout = this->layout();
  std::vector<size_t> pixels(2, 0);
  for (const TrialLayout::View& each : layout.views) {
    for (const ObjectSighting& sighting : sightings(objectsIn(layout, each))) {
      ASSERT_LE(sighting.object, pixels.size());
      pixels[sighting.object - 1] += sighting.pixels;
    }
  }
  EXPECT_GT(pixels[0], 10u);
  EXPECT_GT(pixels[1], 5u);
}

TEST_P(ViewContract, FollowsObjectsThatMove) {
  TrialLayout layout = this->layout();
  const Image<Rgb8> before = viewsOf(layout, kViewScreen, rasterizeStudy);
  layout.objectOffsets[0] = {0, 0, 0.8f};
  EXPECT_NE(viewsOf(layout, kViewScreen, rasterizeStudy), before);
  layout.objectOffsets[0] = {0, 0, 0};
  EXPECT_EQ(viewsOf(layout, kViewScreen, rasterizeStudy), before);
}

TEST_P(ViewContract, GivesTheSamePixelsAgainAndOnOtherThreads) {
  const Image<Rgb8> first = viewsOf(layout(), kViewScreen, rasterizeStudy);
  TrialLayout again = layoutOf(scene_);
  again.views = readView(GetParam().json)->views(vantage_);
  EXPECT_EQ(viewsOf(again, kViewScreen, rasterizeStudy), first);
  std::vector<Image<Rgb8>> images(3);
  std::vector<std::thread> threads;
  for (Image<Rgb8>& image : images) {
    threads.emplace_back([&] { image = viewsOf(layout(), kViewScreen, rasterizeStudy); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_THAT(images, testing::Each(first));
}

// Scenes come and go; another one may stand where one stood before.
TEST_P(ViewContract, ShowsTheSceneThatItIsAskedFor) {
  TrialLayout layout = this->layout();
  const Image<Rgb8> first = viewsOf(layout, kViewScreen, rasterizeStudy);
  Maze other = scene_.maze();
  other.landmarks[0].color = LandmarkColor::kGreen;
  const StudyScene changed(other);
  layout.scene = &changed;
  EXPECT_NE(viewsOf(layout, kViewScreen, rasterizeStudy), first);
}

// A trial may outlive the protocol that its view was read from.
TEST_P(ViewContract, ViewsLiveOnTheirOwn) {
  TrialLayout layout = layoutOf(scene_);
  layout.views = readView(GetParam().json)->views(viewVantage());
  EXPECT_EQ(viewsOf(layout, kViewScreen, rasterizeStudy), viewsOf(this->layout(), kViewScreen, rasterizeStudy));
}

// A view that cannot be made shows nothing; it ends no trial.
TEST_P(ViewContract, AnEyeWithinAWallEndsNothing) {
  Vantage within = vantage_;
  View view = within.pinholes.front().camera.view();
  view.eye.z -= 1.5f;
  view.target.z -= 1.5f;
  within.pinholes.front().camera = PinholeCamera(view, 240, 150);
  TrialLayout layout = layoutOf(scene_);
  layout.views = view_->views(within);
  EXPECT_NO_THROW(viewsOf(layout, kViewScreen, rasterizeStudy));
  EXPECT_NO_THROW(objectsIn(layout, layout.views.front()));
}

INSTANTIATE_TEST_SUITE_P(Kinds, ViewContract, testing::ValuesIn(viewExamples()),
                         [](const auto& each) { return each.param.kind + std::to_string(each.index); });

TEST(ViewExamples, AreOfEveryKind) {
  for (const ViewKind& kind : viewKinds()) {
    EXPECT_TRUE(std::any_of(viewExamples().begin(), viewExamples().end(), [&](const ViewExample& each) {
      return each.kind == kind.name;
    })) << kind.name;
  }
}

}  // namespace
}  // namespace ocelli::test
