#include "oc_core/base/progress.h"

#include <gtest/gtest.h>

#include <string>

namespace ocelli {
namespace {

TEST(Progress, NobodyListeningIsFine) {
  report(Progress(), "slice", 0.5);
}

TEST(Progress, TellsStageAndFraction) {
  std::string stage;
  double fraction = 0;
  report(
      [&](std::string_view name, double part) {
        stage = name;
        fraction = part;
      },
      "slice", 0.5);
  EXPECT_EQ(stage, "slice");
  EXPECT_EQ(fraction, 0.5);
}

}  // namespace
}  // namespace ocelli
