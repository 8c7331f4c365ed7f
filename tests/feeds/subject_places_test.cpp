#include "oc_core/feeds/subject_places.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/feeds/made_blobs.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

TEST(SubjectPlaces, twoFeedsTellOnePlace) {
  const FeedSetup setup = test::tSetup();
  const glm::dvec3 place(0.3, 0, -0.9);
  const auto subjects = locateSubjects(setup, test::allBlobs(setup, {{place}}));
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_GE(subjects[0].feeds.size(), 2u);
  // Feet are told by cells of 2 pixels, so lines of sight are off by up to a pixel: 1 cm at 6 m.
  EXPECT_LT(glm::length(subjects[0].place - place), 0.02);
}

TEST(SubjectPlaces, tellsTwoSubjectsApart) {
  const FeedSetup setup = test::tSetup();
  const auto subjects = locateSubjects(setup, test::allBlobs(setup, {{{-4, 0, -1}}, {{4, 0, -1.4}}}));
  EXPECT_EQ(subjects.size(), 2u);
}

TEST(SubjectPlaces, whoIsKnownIsNotFoundAgain) {
  const FeedSetup setup = test::tSetup();
  const auto all = test::allBlobs(setup, {{{-0.4, 0, -1}}, {{0.5, 0, -1.4}}});
  std::vector<Image<uint16_t>> cells;
  std::vector<const Image<uint16_t>*> known;
  for (const FeedBlobs& blobs : all) {
    cells.push_back(blobs.core);
  }
  for (const Image<uint16_t>& each : cells) {
    known.push_back(&each);
  }
  EXPECT_FALSE(locateSubjects(setup, all).empty());
  EXPECT_TRUE(locateSubjects(setup, all, known).empty());
}

TEST(SubjectPlaces, eachPlaceHasOneFrustumAndBothAddUpBetween) {
  const FeedGraph graph(test::tSetup());
  EXPECT_EQ(shareShown(graph, 0, {0, 0, 2}), 1);
  EXPECT_EQ(shareShown(graph, 1, {0, 0, 2}), 0);
  EXPECT_EQ(shareShown(graph, 1, {-4, 0, -1}), 1);
  EXPECT_EQ(shareShown(graph, 2, {-4, 0, -1}), 0);
  EXPECT_EQ(shareShown(graph, 0, {-4, 0, -1}), 0);
  for (double x = -1.5; x < 0; x += 0.05) {
    const glm::dvec3 place(x, 0, -1);
    EXPECT_NEAR(shareShown(graph, 0, place) + shareShown(graph, 1, place), 1, 1e-12);
  }
}

TEST(SubjectPlaces, whatIsEnteredIsShownUntilTheNextFace) {
  const FeedGraph graph(test::chainSetup());
  const std::vector<std::pair<glm::dvec3, std::vector<double>>> places{{{0, 0, 2}, {1, 0, 0, 0}},
                                                                       {{-3, 0, -1.2}, {1, 1, 0, 0}},
                                                                       {{-6, 0, -1.2}, {1, 1, 0, 1}},
                                                                       {{4, 0, -1.2}, {1, 0, 1, 0}}};
  for (const auto& [place, entered] : places) {
    double shown = 0;
    for (size_t i = 0; i < graph.frusta(); ++i) {
      const size_t row = graph.feedIndexOf(i);
      EXPECT_EQ(shareEntered(graph, i, place), entered[row]) << place.x << " " << graph.feedOf(i).name;
      shown += shareShown(graph, i, place);
    }
    EXPECT_EQ(shown, 1) << place.x;
  }
}

}  // namespace
}  // namespace ocelli
