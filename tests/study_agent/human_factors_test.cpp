#include "study/agent/human_factors.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "oc_core/base/error.h"
#include "study/agent/chance.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(HumanFactors, AreTheSameForASeedAndDifferBetweenSubjects) {
  EXPECT_EQ(jsonText(drawHumanFactors(5)), jsonText(drawHumanFactors(5)));
  std::set<std::string> drawn;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    drawn.insert(jsonText(drawHumanFactors(seed)));
  }
  EXPECT_EQ(drawn.size(), 50u);
}

TEST(HumanFactors, LieAroundThoseOfTheLiterature) {
  const HumanFactors typical;
  double fixation = 0;
  double bits = 0;
  constexpr int kSubjects = 400;
  for (int i = 0; i < kSubjects; ++i) {
    const HumanFactors factors = drawHumanFactors(seedOf(1, static_cast<uint64_t>(i)));
    fixation += factors.fixationSeconds / kSubjects;
    bits += factors.bitsPerSecond / kSubjects;
    EXPECT_GE(factors.workingMemoryItems, 2.5);
    EXPECT_LE(factors.turnLapse, 0.18);
  }
  // Four standard errors of the mean, and a little for what is cut off.
  EXPECT_NEAR(fixation, typical.fixationSeconds, 4 * 0.03 / 20 + 0.002);
  EXPECT_NEAR(bits, typical.bitsPerSecond, 4 * 0.5 / 20 + 0.03);
}

TEST(HumanFactors, AreAllInTheirJson) {
  const nlohmann::json json = nlohmann::json::parse(jsonText(HumanFactors{}));
  // One field a member, but the seed.
  EXPECT_EQ(json.size() * sizeof(double), sizeof(HumanFactors) - sizeof(uint64_t));
}

TEST(HumanFactors, OtherMeansMoveEachSubjectByTheSameShare) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const HumanFactors usual = drawHumanFactors(seed);
    const HumanFactors other = drawHumanFactors(seed, {{"place_error_degrees", 1.5}, {"tracked_items", 0}});
    EXPECT_NEAR(other.placeErrorDegrees / usual.placeErrorDegrees, 3, 1e-12);
    EXPECT_EQ(other.trackedItems, 0);
    EXPECT_EQ(other.fixationSeconds, usual.fixationSeconds);
    EXPECT_EQ(other.turnsByMouse(), usual.turnsByMouse());
  }
}

TEST(HumanFactors, AreReadFromAFileByName) {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return readFactorMeans(folder.write("factors.json", text)); };
  EXPECT_EQ(read(R"({"place_error_degrees": 1, "slip": 0})"),
            (FactorMeans{{"place_error_degrees", 1.0}, {"slip", 0.0}}));
  EXPECT_THROW(read(R"({"place_error": 1})"), InputError);
  EXPECT_THROW(read(R"({"slip": 1.5})"), InputError);
  EXPECT_THROW(read("[]"), InputError);
}

TEST(Chance, NormalNumbersHaveTheirMeanAndDeviation) {
  Random random(3);
  double sum = 0;
  double squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = normal(random, 2, 3);
    sum += x;
    squares += (x - 2) * (x - 2);
  }
  EXPECT_NEAR(sum / kCount, 2, 4 * 3 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 9, 4 * 9 * std::sqrt(2.0 / kCount));
}

}  // namespace
}  // namespace ocelli
