#include "oc_core/feeds/subject_marks.h"

#include <gtest/gtest.h>

#include "tests/feeds/made_blobs.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

/// The sums of the marks of a feed: erased and shown.
glm::dvec2 sumOf(const FeedMarks& marks) {
  glm::dvec2 sum(0);
  for (const FeedMark& mark : marks.cells()) {
    sum += glm::dvec2(mark.erased, mark.shown) / 255.0;
  }
  return sum;
}

// In the left branch, so before the near face of "right", whose camera stands behind it.
constexpr glm::dvec3 kInTheLeft{-3, 0, -1.2};

TEST(SubjectMarks, erasesTheBackOfASubjectOfTheOtherBranch) {
  const FeedGraph graph(test::tSetup());
  const auto all = test::allBlobs(graph.setup(), {{kInTheLeft}});
  ASSERT_EQ(all[2].blobs.size(), 1u);
  EXPECT_TRUE(all[2].blobs[0].isCutBelow) << "that camera does not see the feet";
  const std::vector<glm::dvec3> places{kInTheLeft};
  // Blobs of one body each have the number 1, as the subject has.
  const glm::dvec2 left = sumOf(markSubjects(graph, 1, all[1], all[1].core, places));
  EXPECT_EQ(left.x, 0);
  EXPECT_GT(left.y, 500);
  const glm::dvec2 right = sumOf(markSubjects(graph, 2, all[2], all[2].core, places));
  EXPECT_GT(right.x, 500);
  EXPECT_EQ(right.y, 0);
}

TEST(SubjectMarks, theRootShowsAllThatItsOwnRaysMeet) {
  // Where its rays pass the near face of the left branch, that one shows him; where they do not, nothing is erased.
  const FeedGraph graph(test::tSetup());
  const auto all = test::allBlobs(graph.setup(), {{kInTheLeft}});
  ASSERT_GE(all[0].blobs.size(), 1u);
  const std::vector<glm::dvec3> places{kInTheLeft};
  EXPECT_EQ(sumOf(markSubjects(graph, 0, all[0], all[0].core, places)), glm::dvec2(0));
}

TEST(SubjectMarks, whoIsInAnOldPictureIsErased) {
  const FeedGraph graph(test::tSetup());
  const FeedBlobs blobs = test::blobsOf(graph.feedOf(1), {{kInTheLeft}});
  const FeedMarks marks = eraseSubjects(blobs);
  ASSERT_EQ(marks.cells().size(), blobs.wide.size());
  for (size_t i = 0; i < blobs.wide.size(); ++i) {
    EXPECT_EQ(marks.cells()[i], (FeedMark{blobs.wide[i] > 0 ? uint8_t{255} : uint8_t{0}, 0}));
  }
  EXPECT_GT(sumOf(marks).x, 500);
}

TEST(SubjectMarks, whoIsNotKnownStandsWhereItsFeetAre) {
  const FeedGraph graph(test::tSetup());
  const auto all = test::allBlobs(graph.setup(), {{kInTheLeft}});
  const glm::dvec2 left = sumOf(markSubjects(graph, 1, all[1], {}, {}));
  EXPECT_EQ(left.x, 0);
  EXPECT_GT(left.y, 500);
}

TEST(SubjectMarks, theRimOfASubjectIsItsOwn) {
  const FeedGraph graph(test::tSetup());
  FeedBlobs blobs = test::blobsOf(graph.feedOf(2), {{kInTheLeft}});
  const Image<uint16_t> who = blobs.core;
  for (int y = 0; y < blobs.wide.height(); ++y) {
    for (int x = 1; x < blobs.wide.width(); ++x) {
      blobs.wide(x - 1, y) = std::max(blobs.wide(x - 1, y), blobs.core(x, y));
    }
  }
  const std::vector<glm::dvec3> places{kInTheLeft};
  const FeedMarks marks = markSubjects(graph, 2, blobs, who, places);
  for (size_t i = 0; i < blobs.wide.size(); ++i) {
    EXPECT_EQ(marks.cells()[i].erased, blobs.wide[i] > 0 ? 255 : 0);
  }
}

TEST(SubjectMarks, marksAreFoundByTheirCells) {
  for (const int scale : {2, 3, 4, 5, 21}) {
    const int width = 8190 / scale;
    FeedMarks marks(width, 2, scale);
    for (int x = 0; x < width; ++x) {
      marks.cells()(x, 1) = {static_cast<uint8_t>(x % 251), 0};
    }
    for (int pixel = 0; pixel < width * scale; ++pixel) {
      FeedPlace place;
      place.x = pixel << FeedPlace::kFractionBits;
      place.y = scale << FeedPlace::kFractionBits;
      ASSERT_EQ(marks.at(place).erased, pixel / scale % 251) << pixel << " by " << scale;
    }
  }
}

}  // namespace
}  // namespace ocelli
