#include "oc_core/feeds/subject_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/feeds/made_blobs.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

struct TwoBodies {
  FeedSetup setup = test::tSetup();
  Feed feed = setup.feeds[0];
  FeedBlobs blobs;
  std::vector<test::MadeBody> bodies;
  std::vector<SubjectColors> colors{2};

  explicit TwoBodies(std::vector<test::MadeBody> made) : bodies(std::move(made)) {
    blobs = test::blobsOf(feed, bodies);
  }

  void learnColors() {
    for (size_t i = 0; i < bodies.size(); ++i) {
      for (size_t part = 0; part < 3; ++part) {
        for (int n = 0; n < 400; ++n) {
          colors[i].add(part, SubjectColors::binOf(bodies[i].color));
        }
      }
    }
  }

  std::vector<ExpectedBody> expected(const glm::dvec3& off = glm::dvec3(0)) const {
    std::vector<ExpectedBody> all;
    for (size_t i = 0; i < bodies.size(); ++i) {
      auto view = BodyView::of(feed, bodies[i].place + off, bodies[i].height, {blobs.core.width(), blobs.core.height()},
                               blobs.scale);
      EXPECT_TRUE(view);
      all.push_back({i, *view, &colors[i]});
    }
    std::sort(all.begin(), all.end(),
              [](const ExpectedBody& a, const ExpectedBody& b) { return a.view.distance() < b.view.distance(); });
    return all;
  }

  /// The share of the cells of a body's colour that are told to be its.
  double rightShare(const SubjectCells& cells, size_t body) const {
    double all = 0;
    double right = 0;
    for (size_t i = 0; i < blobs.core.size(); ++i) {
      if (blobs.core[i] > 0 && blobs.colors[i] == bodies[body].color) {
        ++all;
        right += cells.who[i] == body + 1 ? 1 : 0;
      }
    }
    return right / std::max(all, 1.0);
  }
};

/// Made bodies have sharp borders, outlines fade: a cell or two of each row may be nobody's.
constexpr double kNearlyAll = 0.98;

TEST(SubjectCells, bodiesSideBySideHaveTheirOwn) {
  const TwoBodies two({{{-0.6, 0, -0.5}, test::kRed}, {{0.6, 0, -0.9}, test::kBlue}});
  const SubjectCells cells = tellCells(two.blobs, two.expected());
  EXPECT_GT(two.rightShare(cells, 0), kNearlyAll);
  EXPECT_GT(two.rightShare(cells, 1), kNearlyAll);
  for (const BodySight& sight : cells.sights) {
    EXPECT_GT(sight.open, 0.99 * sight.inImage) << "nobody hides it";
    EXPECT_NEAR(sight.besideSeen, sight.besideExpected, 0.02);
  }
}

TEST(SubjectCells, theNearerHidesTheOther) {
  const TwoBodies two({{{0, 0, 1}, test::kRed}, {{0.1, 0, -1.6}, test::kBlue}});
  const SubjectCells cells = tellCells(two.blobs, two.expected());
  EXPECT_GT(cells.sights[0].open, 0.99 * cells.sights[0].inImage);
  EXPECT_LT(cells.sights[1].open, 0.6 * cells.sights[1].inImage);
  EXPECT_LT(cells.sights[1].feetOpen, 0.3 * cells.sights[1].feetInImage);
  EXPECT_GT(two.rightShare(cells, 0), kNearlyAll);
}

TEST(SubjectCells, coloursTellApartWhatOutlinesDoNot) {
  // Both are expected too far to the left.
  TwoBodies two({{{-0.2, 0, -0.8}, test::kRed}, {{0.25, 0, -0.9}, test::kBlue}});
  const glm::dvec3 off(-0.15, 0, 0);
  const double before = two.rightShare(tellCells(two.blobs, two.expected(off)), 0);
  two.learnColors();
  const SubjectCells cells = tellCells(two.blobs, two.expected(off));
  // The border between both is moved by 0.15 m, of bodies that are 0.44 m wide.
  EXPECT_LT(before, 0.85);
  EXPECT_GT(two.rightShare(cells, 0), 0.95);
  EXPECT_GT(two.rightShare(cells, 1), 0.95);
}

TEST(SubjectCells, whatNobodyIsExpectedToFillIsNobodys) {
  TwoBodies two({{{-0.6, 0, -0.5}, test::kRed}, {{0.6, 0, -0.9}, test::kBlue}});
  const std::vector<ExpectedBody> both = two.expected();
  const std::vector<ExpectedBody> one{both[0]};
  const SubjectCells cells = tellCells(two.blobs, one);
  EXPECT_EQ(two.rightShare(cells, 1), 0);
  EXPECT_GT(two.rightShare(cells, 0), kNearlyAll);
}

TEST(SubjectCells, onlyCellsOfOneBodyTellItsColours) {
  const TwoBodies two({{{-0.17, 0, -0.8}, test::kRed}, {{0.22, 0, -0.85}, test::kBlue}});
  const std::vector<ExpectedBody> expected = two.expected();
  const SubjectCells cells = tellCells(two.blobs, expected);
  EXPECT_GT(cells.sure.size(), 200u);
  size_t wrong = 0;
  for (const SureCell& cell : cells.sure) {
    wrong += cell.bin != SubjectColors::binOf(two.bodies[expected[cell.body].subject].color);
  }
  EXPECT_LT(wrong, 0.01 * static_cast<double>(cells.sure.size()));
}

TEST(SubjectColors, partsHaveTheirOwnAndNoiseIsAlike) {
  SubjectColors colors;
  EXPECT_FALSE(colors.isKnown());
  EXPECT_EQ(colors.likeness(1, SubjectColors::binOf(test::kRed)), 0);
  for (int n = 0; n < 400; ++n) {
    colors.add(0, SubjectColors::binOf(test::kBlue));
    colors.add(1, SubjectColors::binOf(test::kRed));
  }
  EXPECT_TRUE(colors.isKnown());
  EXPECT_GT(colors.likeness(1, SubjectColors::binOf(test::kRed)), 1);
  EXPECT_GT(colors.likeness(1, SubjectColors::binOf(Rgb8(196, 57, 54))), 0);
  EXPECT_LT(colors.likeness(1, SubjectColors::binOf(test::kBlue)), -1);
  EXPECT_GT(colors.likeness(0, SubjectColors::binOf(test::kBlue)), 1);
  SubjectColors other;
  for (int n = 0; n < 400; ++n) {
    other.add(1, SubjectColors::binOf(test::kBlue));
  }
  EXPECT_EQ(SubjectColors().likenessOf(colors), 0);
  EXPECT_EQ(colors.likenessOf(SubjectColors()), 0);
  EXPECT_GT(colors.likenessOf(colors), 1);
  EXPECT_LT(colors.likenessOf(other), -1);
  EXPECT_EQ(SubjectColors::partAt(0.2f), 0u);
  EXPECT_EQ(SubjectColors::partAt(0.7f), 1u);
  EXPECT_EQ(SubjectColors::partAt(0.95f), 2u);
}

TEST(SubjectColors, whatIsNotSeenAnyMoreFades) {
  SubjectColors colors;
  for (int n = 0; n < 400; ++n) {
    colors.add(1, SubjectColors::binOf(test::kRed));
  }
  for (int frame = 0; frame < 200; ++frame) {
    colors.forget();
    for (int n = 0; n < 5; ++n) {
      colors.add(1, SubjectColors::binOf(test::kBlue));
    }
  }
  EXPECT_GT(colors.likeness(1, SubjectColors::binOf(test::kBlue)),
            colors.likeness(1, SubjectColors::binOf(test::kRed)));
}

}  // namespace
}  // namespace ocelli
