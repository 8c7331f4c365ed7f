#include "analysis/base/estimable.h"

#include <gtest/gtest.h>

#include "analysis/base/analysis_error.h"

namespace ocelli {
namespace {

TEST(Estimable, IsAResultOrAReason) {
  const Estimable<int> possible = 3;
  ASSERT_TRUE(possible.isPossible());
  EXPECT_EQ(*possible, 3);
  const auto impossible = Estimable<int>::impossible("there is one subject");
  ASSERT_FALSE(impossible.isPossible());
  EXPECT_EQ(impossible.reason(), "there is one subject");
  // A result that is a text is not taken for a reason.
  EXPECT_TRUE(Estimable<std::string>(std::string("text")).isPossible());
}

TEST(AnalysisError, SaysWhatWhereAndWhatToDo) {
  const AnalysisError error(AnalysisError::Kind::kInput, "this is no database", "x.db", "give another");
  EXPECT_STREQ(error.what(), "x.db: this is no database\n  try: give another");
  EXPECT_EQ(error.kind(), AnalysisError::Kind::kInput);
}

}  // namespace
}  // namespace ocelli
