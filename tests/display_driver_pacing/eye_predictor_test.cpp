#include "display_driver/pacing/eye_predictor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "display_driver/pacing/foreseen_eyes.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

HostTime sampleTime(double seconds) {
  return HostTime(std::chrono::nanoseconds(std::llround((100 + seconds) * 1e9)));
}

glm::vec3 straight(double t) {
  return {static_cast<float>(0.8 * t), static_cast<float>(0.2 - 0.3 * t), 10};
}

TEST(EyePredictor, NothingBeforeTheFirstSample) {
  for (const EyePrediction how : {EyePrediction::kNone, EyePrediction::kVelocity, EyePrediction::kKalman}) {
    EyePredictor predictor(how);
    EXPECT_FALSE(predictor.at(sampleTime(0)));
    predictor.add(sampleTime(0), {1, 2, 3});
    EXPECT_EQ(predictor.at(sampleTime(0.05)), glm::vec3(1, 2, 3)) << "one sample has no velocity";
    EXPECT_EQ(predictor.at(sampleTime(-1)), glm::vec3(1, 2, 3));
  }
}

TEST(EyePredictor, SteadyMotionIsForeseen) {
  for (const EyePrediction how : {EyePrediction::kVelocity, EyePrediction::kKalman}) {
    EyePredictor predictor(how);
    for (int i = 0; i <= 60; ++i) {
      predictor.add(sampleTime(i / 60.0), straight(i / 60.0));
    }
    for (const double ahead : {0.02, 0.08, 0.15}) {
      EXPECT_LT(glm::distance(*predictor.at(sampleTime(1 + ahead)), straight(1 + ahead)), 2e-3f) << ahead;
    }
  }
}

TEST(EyePredictor, ThePlaceThatWasLastIsMissedByWhatTheEyeMoved) {
  EyePredictor predictor(EyePrediction::kNone);
  predictor.add(sampleTime(0), straight(0));
  predictor.add(sampleTime(1), straight(1));
  EXPECT_EQ(predictor.at(sampleTime(1.1)), straight(1));
}

TEST(EyePredictor, NoFartherThanHeadsKeepTheirVelocity) {
  for (const EyePrediction how : {EyePrediction::kVelocity, EyePrediction::kKalman}) {
    EyePredictor predictor(how);
    for (int i = 0; i <= 60; ++i) {
      predictor.add(sampleTime(i / 60.0), straight(i / 60.0));
    }
    EXPECT_LT(glm::distance(*predictor.at(sampleTime(1.2)), straight(1.15)), 2e-3f);
    EXPECT_EQ(predictor.at(sampleTime(1.3)), straight(1)) << "the tracker has lost it";
  }
}

TEST(EyePredictor, AfterAPauseMotionBeginsAnew) {
  for (const EyePrediction how : {EyePrediction::kVelocity, EyePrediction::kKalman}) {
    EyePredictor predictor(how);
    for (int i = 0; i <= 60; ++i) {
      predictor.add(sampleTime(i / 60.0), straight(i / 60.0));
    }
    predictor.add(sampleTime(3), {0, 0, 9});
    EXPECT_EQ(predictor.at(sampleTime(3.05)), glm::vec3(0, 0, 9));
  }
}

TEST(EyePredictor, TimesThatDoNotGoForwardReplaceThePlace) {
  for (const EyePrediction how : {EyePrediction::kVelocity, EyePrediction::kKalman}) {
    EyePredictor predictor(how);
    predictor.add(sampleTime(0), {0, 0, 10});
    predictor.add(sampleTime(0), {1, 0, 10});
    predictor.add(sampleTime(-1), {2, 0, 10});
    EXPECT_EQ(predictor.at(sampleTime(0.01)), glm::vec3(2, 0, 10));
  }
}

TEST(EyePredictor, AnEyeAtRestStaysAboutThereThoughTheTrackerIsNoisy) {
  Random random(5);
  EyePredictor predictor(EyePrediction::kKalman);
  float worst = 0;
  for (int i = 0; i < 600; ++i) {
    const auto noise = [&] { return random.inRange(-0.012f, 0.012f); };
    predictor.add(sampleTime(i / 60.0), glm::vec3(noise(), noise(), 10 + noise()));
    if (i > 60) {
      worst = std::max(worst, glm::distance(*predictor.at(sampleTime(i / 60.0 + 0.08)), glm::vec3(0, 0, 10)));
    }
  }
  EXPECT_LT(worst, 0.08f);
}

TEST(EyePredictor, NamesAreRead) {
  const auto names = eyePredictionNames();
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(eyePredictionFromName(names[i], "--predict"), static_cast<EyePrediction>(i));
  }
  EXPECT_THROW(eyePredictionFromName("magic", "--predict"), InputError);
}

TEST(ForeseenEyes, TellsHowFarItWasOff) {
  for (const EyePrediction how : {EyePrediction::kNone, EyePrediction::kKalman}) {
    ForeseenEyes eyes(how);
    for (int i = 0; i < 200; ++i) {
      const double t = i / 50.0;
      eyes.add({t + 7000, straight(t)}, sampleTime(t));
      eyes.at(sampleTime(t + 0.07));
    }
    const PredictionErrors errors = eyes.errors();
    EXPECT_GT(errors.count, 180u);
    const double moved = 0.07 * std::hypot(0.8, 0.3);
    EXPECT_NEAR(errors.medianLast, moved, 1e-3);
    EXPECT_NEAR(errors.aheadSeconds, 0.07, 1e-4);
    if (how == EyePrediction::kNone) {
      EXPECT_NEAR(errors.median, moved, 1e-3);
    } else {
      EXPECT_LT(errors.median, 0.1 * moved);
    }
  }
}

TEST(ForeseenEyes, LinesThatAreHeldUpOnTheirWayDoNotShakeTheVelocity) {
  Random random(3);
  ForeseenEyes eyes(EyePrediction::kVelocity);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = i / 60.0;
    const double delay = 0.002 + static_cast<double>(random.inRange(0, 0.015f));
    eyes.add({t, straight(t)}, sampleTime(t + delay));
    if (i > 100) {
      const glm::vec3 foreseen = *eyes.at(sampleTime(t + 0.06));
      worst = std::max(worst, static_cast<double>(glm::distance(foreseen, straight(t + 0.06))));
    }
  }
  EXPECT_LT(worst, 0.02) << "by the times of arrival it would be off by 0.1 and more";
}

TEST(ForeseenEyes, TimesThatSayNothingAreThoseOfArrival) {
  ForeseenEyes eyes(EyePrediction::kVelocity);
  for (int i = 0; i <= 60; ++i) {
    eyes.add({0, straight(i / 60.0)}, sampleTime(i / 60.0));
  }
  EXPECT_LT(glm::distance(*eyes.at(sampleTime(1.05)), straight(1.05)), 2e-3f);
}

}  // namespace
}  // namespace ocelli
