#include "cli/progress_bar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(ProgressBar, ShowsStageAndPercentage) {
  testing::internal::CaptureStderr();
  ProgressBar bar;
  bar.show("slice", 0.5);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), EndsWith("slice [###############...............]  50%"));
}

TEST(ProgressBar, SurvivesFractionsThatAreNone) {
  testing::internal::CaptureStderr();
  ProgressBar bar;
  bar.show("a", -1);
  bar.show("b", 2);
  bar.show("c", std::nan(""));
  const std::string drawn = testing::internal::GetCapturedStderr();
  EXPECT_THAT(drawn, HasSubstr("a [..............................]   0%"));
  EXPECT_THAT(drawn, HasSubstr("b [##############################] 100%"));
  EXPECT_THAT(drawn, EndsWith("c")) << "how far it is, is not known";
}

TEST(ProgressBar, DrawsRarelyWithinAStage) {
  testing::internal::CaptureStderr();
  ProgressBar bar;
  for (int i = 0; i < 1000; ++i) {
    bar.show("slice", i / 1000.0);
  }
  // 100 redraws would take ten seconds.
  EXPECT_LT(testing::internal::GetCapturedStderr().size(), 100 * 50u);
}

TEST(ProgressBar, ClearsWhatItDrewAndNothingElse) {
  ProgressBar bar;
  testing::internal::CaptureStderr();
  bar.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  bar.show("slice", 0);
  testing::internal::CaptureStderr();
  bar.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "\r\033[K");
}

}  // namespace
}  // namespace ocelli
