#include <gtest/gtest.h>

#include "tests/remote_server/hostile_requests.h"

namespace ocelli::test {
namespace {

TEST(ManyHostileRequests, aHundredThousandAreSurvived) {
  expectToSurvive(100'000, 5);
}

}  // namespace
}  // namespace ocelli::test
