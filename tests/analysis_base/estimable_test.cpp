#include "analysis/base/estimable.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"

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

}  // namespace
}  // namespace ocelli
