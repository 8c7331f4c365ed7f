#include "oc_core/feeds/subject_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "tests/feeds/made_blobs.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

constexpr double kFrame = 1.0 / 15;

using Bodies = std::vector<test::MadeBody>;

class Tracked {
 public:
  const SubjectTracks& tracks() const { return tracks_; }
  double seconds() const { return seconds_; }

  /// Bodies are seen for so long; `at` says where they are, by seconds from the beginning.
  template <class At>
  void see(double seconds, const At& at) {
    for (const double end = seconds_ + seconds - kFrame / 2; seconds_ < end; seconds_ += kFrame) {
      tracks_.update(test::allBlobs(graph_.setup(), at(seconds_)), seconds_);
    }
  }

  std::set<uint64_t> numbers() const {
    std::set<uint64_t> numbers;
    for (size_t i = 0; i < tracks_.count(); ++i) {
      numbers.insert(tracks_.number(i));
    }
    return numbers;
  }

  /// How far the nearest subject is from a place.
  double away(const glm::dvec3& place) const {
    double least = 1e9;
    for (size_t i = 0; i < tracks_.count(); ++i) {
      least = std::min(least, glm::length(tracks_.place(i) - place));
    }
    return least;
  }

 private:
  FeedGraph graph_{test::tSetup()};
  SubjectTracks tracks_{graph_};
  double seconds_ = 0;
};

glm::dvec3 alongTheBranch(double seconds) {
  return {-5 + 1.1 * seconds, 0, -1.2};
}

TEST(SubjectTracks, oneWalkerIsOneSubjectFromFeedToFeed) {
  Tracked tracked;
  for (int second = 1; second < 8; ++second) {
    tracked.see(1, [](double now) { return Bodies{{alongTheBranch(now)}}; });
    EXPECT_EQ(tracked.tracks().count(), 1u) << second;
    // Made bodies have no feet that are ahead, so places are too far off by that; and walkers go on between frames.
    EXPECT_LT(tracked.away(alongTheBranch(tracked.seconds() - kFrame)), 0.35) << second;
  }
}

TEST(SubjectTracks, twoThatPassEachOtherStayTwo) {
  Tracked tracked;
  const auto first = [](double now) { return glm::dvec3(-2.5 + 0.9 * now, 0, -0.8); };
  const auto second = [](double now) { return glm::dvec3(2.5 - 0.9 * now, 0, -1.6); };
  const auto both = [&](double now) { return Bodies{{first(now), test::kRed}, {second(now), test::kBlue}}; };
  for (int half = 1; half < 10; ++half) {
    tracked.see(0.5, both);
    const double now = tracked.seconds() - kFrame;
    // Nearer to itself than to the other, whose way is 0.8 m beside it, and as exact as a single one, nearly.
    EXPECT_LT(tracked.away(first(now)), 0.5) << now;
    EXPECT_LT(tracked.away(second(now)), 0.5) << now;
  }
  EXPECT_EQ(tracked.tracks().count(), 2u);
}

TEST(SubjectTracks, whoIsHiddenGoesOnAsItWalked) {
  Tracked tracked;
  // The nearer one stands before the stem's camera. Only the stem sees the other, who walks behind it.
  const glm::dvec3 still(0, 0, 2.2);
  const auto hidden = [](double now) { return glm::dvec3(0.75 - 0.5 * now, 0, 1); };
  const auto both = [&](double now) { return Bodies{{still, test::kRed}, {hidden(now), test::kBlue}}; };
  // It is hidden after 1.6 s, and comes out on the other side. Who stayed where it was at first would be 0.8 m off.
  for (const double seconds : {1.6, 1.4}) {
    tracked.see(seconds, both);
    EXPECT_EQ(tracked.tracks().count(), 2u);
    EXPECT_LT(tracked.away(hidden(tracked.seconds() - kFrame)), 0.6);
  }
}

TEST(SubjectTracks, whoComesOutElsewhereIsRecognized) {
  const glm::dvec3 still(0, 0, 2.2);
  for (const Rgb8& color : {test::kBlue, Rgb8(60, 170, 70)}) {
    Tracked tracked;
    // As above, but out of sight the other one turns round, and comes out where nobody expects it.
    const auto hidden = [](double now) { return glm::dvec3(0.75 - 0.5 * now, 0, 1); };
    tracked.see(1.3, [&](double now) { return Bodies{{still, test::kRed}, {hidden(now), test::kBlue}}; });
    ASSERT_EQ(tracked.tracks().count(), 2u);
    const std::set<uint64_t> before = tracked.numbers();
    tracked.see(0.4, [&](double) { return Bodies{{still, test::kRed}}; });
    tracked.see(0.3, [&](double) { return Bodies{{still, test::kRed}, {{1, 0, -0.5}, color}}; });
    if (color == test::kBlue) {
      EXPECT_EQ(tracked.numbers(), before);
    } else {
      EXPECT_EQ(tracked.numbers().size(), 3u) << "that is somebody else";
    }
  }
}

TEST(SubjectTracks, whereTheFeedSeesBackgroundNobodyIs) {
  Tracked tracked;
  tracked.see(2, [](double) { return Bodies{{{-3, 0, -1}}}; });
  EXPECT_EQ(tracked.tracks().count(), 1u);
  tracked.see(0.5, [](double) { return Bodies{}; });
  EXPECT_EQ(tracked.tracks().count(), 0u);
}

TEST(SubjectTracks, cellsAreThoseOfWhoStandsThere) {
  Tracked tracked;
  const Bodies bodies{{{-3, 0, -1}, test::kRed}, {{0.2, 0, 0.5}, test::kBlue}};
  tracked.see(1, [&](double) { return bodies; });
  ASSERT_EQ(tracked.tracks().count(), 2u);
  const auto blobs = test::allBlobs(test::tSetup(), bodies);
  for (size_t feed = 0; feed < blobs.size(); ++feed) {
    const Image<uint16_t>& who = tracked.tracks().cells(feed).who;
    ASSERT_EQ(who.size(), blobs[feed].core.size());
    size_t wrong = 0;
    size_t all = 0;
    for (size_t i = 0; i < who.size(); ++i) {
      if (blobs[feed].core[i] > 0) {
        const glm::dvec3& place = bodies[blobs[feed].colors[i] == test::kRed ? 0 : 1].place;
        ++all;
        wrong += who[i] == 0 || glm::length(tracked.tracks().place(who[i] - 1u) - place) > 0.5 ? 1 : 0;
      }
    }
    // Corners of made heads and trunks are out of the outlines.
    EXPECT_LT(wrong, 0.03 * static_cast<double>(all)) << "feed " << feed;
  }
}

TEST(SubjectTracks, nobodyIsFoundTwiceWhileStanding) {
  Tracked tracked;
  tracked.see(4, [](double) {
    return Bodies{{{-3, 0, -1}, test::kRed}, {{-2.2, 0, -1.5}, test::kBlue}, {{0.3, 0, 2}}};
  });
  EXPECT_EQ(tracked.tracks().count(), 3u);
}

}  // namespace
}  // namespace ocelli
