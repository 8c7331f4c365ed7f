// What protocols/solidity.json promises: conditions that differ in what the display holds alone, equally bright, with
// nothing but the images that tells which of the two is in front.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "oc_core/image/color.h"
#include "oc_core/image/png_file.h"
#include "study/protocol/schedule.h"
#include "study/task/trial_image.h"

namespace ocelli::test {
namespace {

/// The smallest that the protocol allows.
constexpr TrialScreen kSolidityScreen{1024, 640, 60};

const Protocol& solidity() {
  static const Protocol protocol = readProtocol(OCELLI_SOURCE_DIR "/protocols/solidity.json");
  return protocol;
}

const nlohmann::json& solidityJson() {
  static const nlohmann::json json = nlohmann::json::parse(std::ifstream(OCELLI_SOURCE_DIR "/protocols/solidity.json"));
  return json;
}

/// The image of a view, without the screen around it.
Image<Rgb8> imageOf(int caseIndex, TrialView view, int64_t tick) {
  TrialPlan plan;
  plan.caseIndex = caseIndex;
  plan.view = view;
  const std::unique_ptr<TrialRun> run = solidity().blocks.front().task->start(plan, kSolidityScreen);
  TrialLayout layout = run->layout();
  layout.tick = tick;
  const std::shared_ptr<const ShownContent> shown = shownIn(layout, layout.views.front());
  Image<Rgb8> pixels = std::get<ShownImage>(*shown).pixels;
  if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
    writePng(std::filesystem::path(folder) / ("solidity " + std::to_string(caseIndex) + " " + solidity().nameOf(view) +
                                              " " + std::to_string(tick) + ".png"),
             pixels);
  }
  return pixels;
}

double luminanceOf(const Rgb8& pixel) {
  return 0.2126 * static_cast<double>(linearFromSrgbByte(pixel.x)) +
         0.7152 * static_cast<double>(linearFromSrgbByte(pixel.y)) +
         0.0722 * static_cast<double>(linearFromSrgbByte(pixel.z));
}

double meanLuminanceOf(const Image<Rgb8>& image) {
  double sum = 0;
  for (const Rgb8& pixel : image) {
    sum += luminanceOf(pixel);
  }
  return sum / static_cast<double>(image.size());
}

/// Root of the mean squared difference of luminances.
double distanceOf(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double difference = luminanceOf(a[i]) - luminanceOf(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(SolidityProtocol, ConditionsDifferInWhatTheDisplayHoldsAlone) {
  std::set<std::string> others;
  for (nlohmann::json condition : solidityJson().at("conditions")) {
    nlohmann::json& view = condition.at("view");
    view.erase("camera");
    view.erase("made_at");
    others.insert(view.dump());
  }
  EXPECT_EQ(others.size(), 1u) << "the same display, poses, brightness and pixels";
}

TEST(SolidityProtocol, NothingButTheImageTellsWhichIsInFront) {
  std::map<std::string, int> inFront;
  int left = 0;
  int cases = 0;
  std::set<std::pair<double, double>> distances;
  for (const nlohmann::json& each : solidityJson().at("blocks").at(0).at("cases")) {
    const bool isLeft = each.at("left").at("ahead_meters") < each.at("right").at("ahead_meters");
    const nlohmann::json& front = each.at(isLeft ? "left" : "right");
    const nlohmann::json& behind = each.at(isLeft ? "right" : "left");
    for (const char* look : {"shape", "color"}) {
      ++inFront[front.at(look).get<std::string>()];
      --inFront[behind.at(look).get<std::string>()];
    }
    left += isLeft ? 1 : 0;
    ++cases;
    distances.emplace(front.at("ahead_meters").get<double>(), behind.at("ahead_meters").get<double>());
    EXPECT_EQ(each.at("left").at("right_meters").get<double>(), -each.at("right").at("right_meters").get<double>());
  }
  EXPECT_EQ(2 * left, cases);
  EXPECT_EQ(distances.size(), 1u);
  for (const auto& [look, more] : inFront) {
    EXPECT_EQ(more, 0) << look << " is in front more often than behind";
  }
}

class SolidityImages : public testing::Test {
 protected:
  const std::vector<TrialView> views_ = solidity().conditions.names.all();  // full, di, ocri, followed
};

TEST_F(SolidityImages, AreEquallyBright) {
  for (const int caseIndex : {0, 5}) {
    for (const TrialView view : views_) {
      // Bytes of sRGB and the scaling of images to the screen move the mean by a percent or two.
      EXPECT_NEAR(meanLuminanceOf(imageOf(caseIndex, view, 0)), 0.02, 0.0004) << solidity().nameOf(view);
    }
  }
}

// At rest a depth image is the same, wherever it is made for other poses. To the side the one made at rest has gaps,
// which the occlusion camera's has fewer of.
TEST_F(SolidityImages, ShowHiddenLightAndGaps) {
  constexpr int64_t kRight = kTicksPerSecond;
  constexpr int64_t kLeft = 3 * kTicksPerSecond;
  EXPECT_EQ(imageOf(0, views_[1], 0), imageOf(0, views_[3], 0));
  const Image<Rgb8> full = imageOf(0, views_[0], 0);
  EXPECT_GT(distanceOf(full, imageOf(0, views_[3], 0)), 0.02) << "light that should be hidden";
  for (const int64_t tick : {kRight, kLeft}) {
    const Image<Rgb8> followed = imageOf(0, views_[3], tick);
    const double di = distanceOf(imageOf(0, views_[1], tick), followed);
    const double ocri = distanceOf(imageOf(0, views_[2], tick), followed);
    const double whole = distanceOf(imageOf(0, views_[0], tick), followed);
    EXPECT_LT(ocri, whole);
    EXPECT_GT(di, 0);
  }
}

}  // namespace
}  // namespace ocelli::test
