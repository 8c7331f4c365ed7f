#include "tests/remote_server/hostile_requests.h"

#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

TEST(HostileRequests, someAreSurvived) {
  expectToSurvive(2000, 20261126);
}

}  // namespace
}  // namespace ocelli::test
