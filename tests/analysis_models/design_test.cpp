#include "analysis/models/design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Strings = std::vector<std::string>;

const Strings kViews = {"ppc", "gc", "gc", "ppc"};

TEST(Design, CodesFactorsAndTheirInteractions) {
  FixedEffects fixed(4);
  fixed.addIntercept();
  fixed.addFactor("view", kViews, {"ppc", "gc"}, Coding::kCentered);
  fixed.addFactor("size", {"s", "m", "l", "s"}, {"s", "m", "l"}, Coding::kTreatment);
  fixed.addInteraction("view", "size");
  EXPECT_EQ(fixed.names(), (Strings{"(intercept)", "view=gc", "size=m", "size=l", "view=gc:size=m", "view=gc:size=l"}));
  Eigen::MatrixXd expected(4, 6);
  expected << 1, -0.5, 0, 0, 0, 0,  //
      1, 0.5, 1, 0, 0.5, 0,         //
      1, 0.5, 0, 1, 0, 0.5,         //
      1, -0.5, 0, 0, 0, 0;
  EXPECT_EQ(fixed.columns(), expected);
  EXPECT_EQ(fixed.columnsOf("size"), (std::vector<Eigen::Index>{2, 3}));
}

TEST(Design, DropsAndNamesColumnsThatOthersDetermine) {
  FixedEffects fixed(4);
  fixed.addIntercept();
  fixed.addNumber("x", {1, 2, 3, 5});
  fixed.addNumber("twice", {2e9, 4e9, 6e9, 10e9});
  fixed.addNumber("nothing", {0, 0, 0, 0});
  // A factor of which one level occurs.
  fixed.addFactor("view", {"ppc", "ppc", "ppc", "ppc"}, {"ppc", "gc"}, Coding::kCentered);
  fixed.addNumber("z", {1e-9, 0, 0, 0});
  const Design design = makeDesign(fixed, {});
  EXPECT_EQ(design.fixedNames, (Strings{"(intercept)", "x", "z"}));
  ASSERT_EQ(design.dropped.size(), 3U);
  EXPECT_EQ(design.dropped[0].name, "twice");
  EXPECT_EQ(design.dropped[1].reason, "it is 0 in every row");
  EXPECT_EQ(design.dropped[2].reason, "the columns before it determine it");
  EXPECT_TRUE(design.fixed.isApprox(design.basis * design.triangle, 1e-14));
  EXPECT_TRUE((design.basis.transpose() * design.basis).isIdentity(1e-14));
  EXPECT_EQ(design.rowsLike(fixed), design.fixed);
  EXPECT_THROW(design.rowsLike(FixedEffects(4)), InputError);
}

TEST(Design, GroupsRowsByTheirSortedLevels) {
  FixedEffects fixed(4);
  fixed.addFactor("view", kViews, {"ppc", "gc"}, Coding::kCentered);
  RandomTerm term = randomIntercepts("subject", nestedLevels({"b", "a", "b", "a"}, {"1", "1", "1", "2"}));
  addSlope(term, "view", fixed);
  EXPECT_EQ(term.levels, (Strings{"a/1", "a/2", "b/1"}));
  EXPECT_EQ(term.levelOfRow, (std::vector<int>{2, 0, 2, 1}));
  EXPECT_EQ(term.names, (Strings{"(intercept)", "view=gc"}));
  EXPECT_EQ(term.columns.col(1), fixed.columns().col(0));
}

TEST(Design, RefusesWhatDoesNotFit) {
  FixedEffects fixed(2);
  fixed.addIntercept();
  EXPECT_THROW(fixed.addIntercept(), InputError);
  EXPECT_THROW(fixed.addNumber("x", {1}), InputError);
  EXPECT_THROW(fixed.addNumber("x", {1, std::nan("")}), InputError);
  EXPECT_THROW(fixed.addFactor("view", {"gc", "other"}, {"ppc", "gc"}, Coding::kTreatment), InputError);
  EXPECT_THROW(fixed.addInteraction("x", "y"), InputError);
  RandomTerm term = randomIntercepts("subject", {"a", "b"});
  EXPECT_THROW(makeDesign(FixedEffects(3), {term}), InputError);
  term.columns(0, 0) = std::nan("");
  EXPECT_THROW(makeDesign(fixed, {term}), InputError);
}

TEST(Design, SaysWhyNoModelIsPossible) {
  const auto why = [](const Strings& subjects, bool needsReplicates = true) {
    FixedEffects fixed(static_cast<Eigen::Index>(subjects.size()));
    fixed.addIntercept();
    return whyImpossible(makeDesign(fixed, {randomIntercepts("subject", subjects)}), needsReplicates).value_or("");
  };
  EXPECT_EQ(why({}), "there are no rows");
  EXPECT_EQ(why({"a"}), "1 rows are too few for 1 fixed effects");
  EXPECT_EQ(why({"a", "a", "a"}), "there is only one subject, whose variance cannot be told");
  EXPECT_THAT(why({"a", "b", "c"}), testing::HasSubstr("cannot be told from the residuals"));
  EXPECT_EQ(why({"a", "b", "c"}, false), "");
  EXPECT_EQ(why({"a", "b", "b"}), "");
}

}  // namespace
}  // namespace ocelli
