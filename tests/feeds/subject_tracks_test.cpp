#include "oc_core/feeds/subject_tracks.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr double kStep = 1.0 / 30;

glm::dvec3 walkerAt(double seconds) {
  return {-3 + 1.2 * seconds, 0, -1};
}

/// Tracks after a walker was told for so long.
SubjectTracks trackedFor(double seconds) {
  SubjectTracks tracks;
  for (double now = 0; now < seconds; now += kStep) {
    tracks.update(
        {{walkerAt(now), {{0, walkerAt(now)}}, 0.1}}, [](const glm::dvec3&) { return 1.0; }, now);
  }
  return tracks;
}

TEST(SubjectTracks, whoIsHiddenGoesOnWhileSomebodyIsSeenThere) {
  SubjectTracks tracks = trackedFor(2);
  std::vector<SeenSubject> subjects;
  for (double now = 2; now < 4; now += kStep) {
    subjects = tracks.update(
        {}, [](const glm::dvec3&) { return 0.9; }, now);
  }
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_TRUE(subjects[0].told.empty());
  EXPECT_LT(glm::length(subjects[0].place - walkerAt(4 - kStep)), 0.1);
}

TEST(SubjectTracks, whereTheFeedSeesBackgroundNobodyIs) {
  SubjectTracks tracks = trackedFor(2);
  std::vector<SeenSubject> subjects;
  for (double now = 2; now < 2.5; now += kStep) {
    subjects = tracks.update(
        {}, [](const glm::dvec3&) { return 0.1; }, now);
  }
  EXPECT_TRUE(subjects.empty());
}

TEST(SubjectTracks, whereNoFeedLooksOneGoesOnForAWhile) {
  SubjectTracks tracks = trackedFor(2);
  const auto unknown = [](const glm::dvec3&) { return std::optional<double>(); };
  EXPECT_EQ(tracks.update({}, unknown, 3).size(), 1u);
  EXPECT_TRUE(tracks.update({}, unknown, 8).empty());
}

TEST(SubjectTracks, eachGetsTheNearest) {
  SubjectTracks tracks;
  const auto seen = [](const glm::dvec3&) { return 1.0; };
  const glm::dvec3 a(0, 0, 0);
  const glm::dvec3 b(0.7, 0, 0);
  tracks.update({{a, {{0, a}}, 0.1}, {b, {{0, b}}, 0.1}}, seen, 0);
  // `b` alone is told, nearer to where it was than to `a`, which is first in the list and would reach it, too.
  const auto subjects = tracks.update({{b, {{0, b}}, 0.1}}, seen, kStep);
  ASSERT_EQ(subjects.size(), 2u);
  EXPECT_EQ(subjects[0].place, b);
  EXPECT_EQ(subjects[1].place, a);
}

TEST(SubjectTracks, whatIsToldLessExactlyMovesLess) {
  SubjectTracks tracks = trackedFor(2);
  const glm::dvec3 expected = walkerAt(2);
  const auto subjects = tracks.update(
      {{expected + glm::dvec3(1, 0, 0), {{0, expected}}, 1.2}}, [](const glm::dvec3&) { return 1.0; }, 2);
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_NEAR(subjects[0].place.x - expected.x, 0.25, 0.06);  // 0.3 m of 1.2
}

}  // namespace
}  // namespace ocelli
