#include "analysis/base/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace ocelli {
namespace {

TEST(Failure, isWhatIsThrownInOneLine) {
  EXPECT_EQ(failureOf([] { throw std::overflow_error("too\nlarge"); }), "too large");
  EXPECT_EQ(failureOf([] { throw std::domain_error(""); }), "an error without a message");
  EXPECT_EQ(failureOf([] {}), std::nullopt);
}

TEST(Failure, aLackOfMemoryIsThrownOn) {
  EXPECT_THROW(failureOf([] { throw std::bad_alloc(); }), std::bad_alloc);
}

}  // namespace
}  // namespace ocelli
