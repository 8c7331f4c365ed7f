// Sessions that are killed lose nothing that was acknowledged, and go on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"
#include "tests/study_store/kill_harness.h"

namespace ocelli::test {
namespace {

TEST(Kill, LosesNoAcknowledgedTrial) {
  const TemporaryFolder folder;
  const KillReport report = killSessions(OCELLI_KILL_CHILD, folder.path(), 40, 1);
  EXPECT_THAT(report.problems, testing::IsEmpty());
  EXPECT_EQ(report.kills, 40);
  // The kills came in the midst of something: trials were acknowledged, cut short, and gone on with.
  EXPECT_GT(report.acknowledged, 40);
  EXPECT_GT(report.interrupted, 0);
  EXPECT_GT(report.resumed, 0);
}

}  // namespace
}  // namespace ocelli::test
