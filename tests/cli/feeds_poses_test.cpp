// `ocelli feeds calibrate pose`, and what `ocelli feeds run` says of cameras that have moved since: the program itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "oc_core/base/file_bytes.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"
#include "tests/feeds_calibration/calibration_rigs.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

nlohmann::json jsonOf(const glm::dvec3& p) {
  return {p.x, p.y, p.z};
}

/// A camera that sees tags, and a video of a gray wall.
class FeedsPoses : public testing::Test {
 protected:
  FeedsPoses() {
    RandomNumbers random(1, 3);
    writePng(folder_ / "tags.png", tagPicture(rig_, random));
    VideoWriter wall(folder_ / "wall.mkv", rig_.width, rig_.height, {});
    for (int k = 0; k < 3; ++k) {
      wall.add(Image<Rgb8>(rig_.width, rig_.height, Rgb8(90)), 0.1 * k);
    }
    wall.finish();
    FeedSetup setup;
    for (const char* name : {"left", "blind"}) {
      Feed feed;
      feed.name = name;
      feed.source = name == std::string("left") ? "tags.png" : "wall.mkv";
      feed.width = rig_.width;
      feed.height = rig_.height;
      feed.lens = rig_.lens;
      feed.pose = {{0, 1, 0}, {0, 1, -1}, {0, 1, 0}};
      setup.feeds.push_back(feed);
    }
    setup.frusta = {{"left", "", {}}};
    setup.output = {320, 240, 40, rig_.pose.target};
    folder_.write("setup.json", jsonText(setup));
    nlohmann::json tags = nlohmann::json::array();
    for (const KnownTag& tag : rig_.places.tags) {
      nlohmann::json corners = nlohmann::json::array();
      for (const glm::dvec3& corner : tag.corners) {
        corners.push_back(jsonOf(corner));
      }
      tags.push_back({{"id", tag.id}, {"corners", corners}});
    }
    folder_.write("places.json", nlohmann::json{{"tags", tags}}.dump());
  }

  std::string at(const char* name) const { return inQuotes(folder_ / name); }
  ProgramResult calibrate() const {
    return runProgram("feeds calibrate pose " + at("setup.json") + " --places " + at("places.json") + " -o " +
                      at("posed.json"));
  }
  /// Turns the camera of "left" in the file by about `pixels` of its image.
  void turnCamera(double pixels) const {
    FeedSetup setup = feedSetupFromJsonText(readFile(folder_ / "posed.json"), "posed.json");
    FeedPose& pose = setup.feeds[0].pose;
    pose.target = pose.eye + pose.forward() + pose.right() * (pixels / setup.feeds[0].lens.focal.x);
    folder_.write("posed.json", jsonText(setup));
  }
  ProgramResult run(const std::string& more) const {
    return runProgram("feeds run " + at("posed.json") + " -o " + at("frames") + " --json " + at("figures.json") + " " +
                      more);
  }
  nlohmann::json movedPixels() const {
    return nlohmann::json::parse(readFile(folder_ / "figures.json")).at("feeds").at(0).at("moved_pixels");
  }

  TemporaryFolder folder_;
  CalibrationRig rig_ = calibrationRig(1);
};

TEST_F(FeedsPoses, aFeedWithoutAPoseDoesNotStopTheOthers) {
  const ProgramResult result = calibrate();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("1 of 2 feeds have no new pose"));
  EXPECT_THAT(result.error, HasSubstr("feed \"blind\" with"));
  const FeedSetup setup = readFeedSetup(folder_ / "posed.json");
  EXPECT_LT(glm::distance(setup.feeds[0].pose.eye, rig_.pose.eye), 0.1);
  EXPECT_GE(setup.places.tags.size(), 2u);
  EXPECT_EQ(setup.places.tags[0].seenBy, std::vector<std::string>{"left"});
}

TEST_F(FeedsPoses, nothingIsWrittenWhereNoFeedHasAPose) {
  writePng(folder_ / "tags.png", Image<Rgb8>(rig_.width, rig_.height, Rgb8(90)));
  const ProgramResult result = calibrate();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("2 of 2 feeds"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "posed.json"));
}

TEST_F(FeedsPoses, runsSayWhichCameraHasMoved) {
  calibrate();
  ProgramResult result = run("");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, Not(HasSubstr("moved"))) << "it is where it was";
  EXPECT_THAT(result.error, Not(HasSubstr("blind"))) << "it saw no tags when poses were found";
  EXPECT_LT(movedPixels().get<double>(), 1);

  turnCamera(14);
  result = run("");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, HasSubstr("warning: camera 1 (left) has moved: 1"));
  EXPECT_NEAR(movedPixels().get<double>(), 14, 4) << "pixels are wider beside the middle";
  const Image<Rgb8> labelled = readPng(folder_ / "frames" / "frame-000000.png");

  result = run("--check-poses error");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("camera 1 (left) has moved: 1"));

  result = run("--check-poses off");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_THAT(result.error, Not(HasSubstr("moved")));
  EXPECT_TRUE(movedPixels().is_null());
  EXPECT_NE(readPng(folder_ / "frames" / "frame-000000.png"), labelled) << "the label says that it has moved";
}

TEST_F(FeedsPoses, checksTakeThePlacesOfTheSetup) {
  calibrate();
  const ProgramResult still = runProgram("feeds calibrate check " + at("posed.json"));
  EXPECT_EQ(still.exitCode, 0);
  EXPECT_THAT(still.output, HasSubstr("0       unknown")) << "the wall has no tags";
  turnCamera(14);
  const ProgramResult moved = runProgram("feeds calibrate check " + at("posed.json"));
  EXPECT_EQ(moved.exitCode, 1);
  EXPECT_THAT(moved.error, HasSubstr("camera 1 (left) has moved"));
  const ProgramResult none = runProgram("feeds calibrate check " + at("setup.json"));
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.error, HasSubstr("there are no places of tags"));
  writePng(folder_ / "tags.png", Image<Rgb8>(rig_.width, rig_.height, Rgb8(90)));
  const ProgramResult dark = runProgram("feeds calibrate check " + at("posed.json"));
  EXPECT_EQ(dark.exitCode, 1);
  EXPECT_THAT(dark.error, HasSubstr("nothing was checked"));
}

TEST_F(FeedsPoses, sheetsHaveABoardTagsOrBoth) {
  const auto pagesOf = [&](const std::string& what) {
    std::filesystem::remove(folder_ / "a.pdf");
    const ProgramResult result = runProgram("feeds calibrate " + what);
    if (result.exitCode != 0) {
      return -result.exitCode;
    }
    const std::string pdf = readFile(folder_ / "a.pdf");
    const std::regex page("/Type\\s*/Page[^s]");
    return static_cast<int>(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), page), std::sregex_iterator()));
  };
  EXPECT_EQ(pagesOf("sheet -o " + at("a.pdf")), 1);
  EXPECT_EQ(pagesOf("sheet --tags 0,1 --tag-size 130 -o " + at("a.pdf")), 2);
  EXPECT_EQ(pagesOf("sheet --tags 0,1 --board 9x6:25 -o " + at("a.pdf")), 3);
  EXPECT_EQ(pagesOf("--sheet " + at("a.pdf")), 5);
  EXPECT_EQ(pagesOf("sheet --tag-size 100 -o " + at("a.pdf")), -2);
  EXPECT_EQ(pagesOf("--sheet " + at("a.png")), -2);
  EXPECT_EQ(pagesOf("--sheet " + at("a.pdf") + " check " + at("setup.json")), -2);
  const ProgramResult neither = runProgram("feeds calibrate");
  EXPECT_EQ(neither.exitCode, 2);
  EXPECT_THAT(neither.error, HasSubstr("subcommand is required"));
}

}  // namespace
}  // namespace ocelli::test
