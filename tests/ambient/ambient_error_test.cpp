#include "oc_core/ambient/ambient_error.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace ocelli {
namespace {

TEST(AmbientError, isWhatIsCountedByHand) {
  const std::vector<float> truth{0.5f, 0.5f, 1, 0};
  const std::vector<float> light{0.75f, 0.5f, 0.5f, 0.0625f};
  const AmbientError error = ambientError(light, truth);
  EXPECT_EQ(error.points, 4u);
  EXPECT_DOUBLE_EQ(error.signedMean, (0.25 - 0.5 + 0.0625) / 4);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((0.0625 + 0.25 + 0.0625 * 0.0625) / 4));
  EXPECT_DOUBLE_EQ(error.wrongShare, 0.5);
}

TEST(AmbientError, isNothingWithoutPoints) {
  const AmbientError error = ambientError({}, {});
  EXPECT_EQ(error.points, 0u);
  EXPECT_EQ(error.rmse, 0);
  EXPECT_EQ(error.wrongShare, 0);
}

}  // namespace
}  // namespace ocelli
