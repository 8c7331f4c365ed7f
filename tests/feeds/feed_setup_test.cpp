#include "oc_core/feeds/feed_setup.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "tests/base/temporary_folder.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

std::string setupError(const std::string& text) {
  try {
    feedSetupFromJsonText(text, "setup.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string errorAfter(const std::function<void(FeedSetup&)>& change) {
  FeedSetup setup = test::tSetup();
  change(setup);
  return setupError(jsonText(setup));
}

TEST(FeedSetup, jsonComesBack) {
  FeedSetup setup = test::chainSetup();
  setup.feeds[1].source = "rtsp://127.0.0.1:8554/left";
  setup.feeds[1].ffmpegOptions = {"rtsp_flags=listen", "rtsp_transport=tcp"};
  setup.feeds[2].source = "v4l2:/dev/video2";
  setup.feeds[2].framesPerSecond = 15;
  EXPECT_EQ(feedSetupFromJsonText(jsonText(setup), "setup.json"), setup);
}

FeedSetup withPlaces() {
  FeedSetup setup = test::tSetup();
  setup.places.tags = {{3, {{{0, 2, -1}, {1, 2, -1}, {1, 1, -1}, {0, 1, -1}}}, {"left", "stem"}},
                       {586, {{{0, 2, -2}, {1, 2, -2}, {1, 1, -2}, {0, 1, -2}}}, {}}};
  setup.places.corners = {{"right", {10.5, 20}, {1, 2, 3}}};
  return setup;
}

TEST(FeedSetup, keepsPlaces) {
  const FeedSetup setup = withPlaces();
  EXPECT_EQ(feedSetupFromJsonText(jsonText(setup), "setup.json"), setup);
  FeedSetup wrong = setup;
  wrong.places.tags[0].seenBy.push_back("attic");
  EXPECT_THAT(setupError(jsonText(wrong)), testing::HasSubstr("\"places\" names the feed \"attic\""));
  wrong = setup;
  wrong.places.corners[0].feed = "cellar";
  EXPECT_THAT(setupError(jsonText(wrong)), testing::HasSubstr("\"cellar\""));
  nlohmann::json json = nlohmann::json::parse(jsonText(setup));
  json["places"]["tags"][1]["id"] = 3;
  EXPECT_THAT(setupError(json.dump()), testing::HasSubstr("which another tag has"));
}

TEST(FeedSetup, schemaAgreesWithTheReader) {
  const nlohmann::json schema = readJsonFile(OCELLI_FEEDS_SCHEMA);
  const nlohmann::json whole = nlohmann::json::parse(jsonText(withPlaces()));
  for (const auto& [name, value] : whole.items()) {
    EXPECT_TRUE(schema.at("properties").contains(name)) << name;
  }
  for (const auto& [name, value] : whole.at("feeds").at(0).items()) {
    EXPECT_TRUE(schema.at("properties").at("feeds").at("items").at("properties").contains(name)) << name;
  }
  for (const auto& [name, value] : whole.at("frusta").at(1).items()) {
    EXPECT_TRUE(schema.at("properties").at("frusta").at("items").at("properties").contains(name)) << name;
  }
}

/// A setup that is written elsewhere names the same files.
TEST(FeedSetup, keepsItsFilesInAnotherFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_directories(folder / "b");
  FeedSetup setup = test::tSetup();
  setup.feeds[1].source = "rtsp://127.0.0.1:8554/left";
  setup.feeds[2].background = "right.png";
  folder.write("a/setup.json", jsonText(setup));
  const FeedSetup read = readFeedSetup(folder / "a" / "setup.json");
  writeFeedSetup(read, folder / "b" / "setup.json");
  const FeedSetup again = readFeedSetup(folder / "b" / "setup.json");
  EXPECT_EQ(std::filesystem::weakly_canonical(again.feeds[0].source), folder / "a" / "stem.mkv");
  EXPECT_EQ(again.feeds[1].source, "rtsp://127.0.0.1:8554/left");
  EXPECT_EQ(std::filesystem::weakly_canonical(again.feeds[2].background), folder / "a" / "right.png");
}

TEST(FeedSetup, putsParentsFirst) {
  FeedSetup setup = test::chainSetup();
  std::reverse(setup.frusta.begin(), setup.frusta.end());
  orderFrusta(setup, "here");
  EXPECT_EQ(setup.frusta[0].feed, "stem");
  EXPECT_EQ(setup.frusta[3].feed, "beyond");
}

TEST(FeedSetup, namesWhatIsNoTree) {
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta.erase(s.frusta.begin()); }), testing::HasSubstr("is no frustum"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].parent = ""; }), testing::HasSubstr("2 frusta are roots"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) {
                s.frusta[0] = {"stem", "left", s.frusta[1].near};
              }),
              testing::HasSubstr("no frustum is the root"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) {
                s.frusta[1].parent = "right";
                s.frusta[2].parent = "left";
              }),
              testing::HasSubstr("go round in a circle"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].parent = "attic"; }), testing::HasSubstr("\"attic\""));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].feed = "attic"; }), testing::HasSubstr("does not exist"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].feed = "right"; }), testing::HasSubstr("two frusta"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.feeds[1].name = "right"; }), testing::HasSubstr("two feeds"));
}

TEST(FeedSetup, namesBadFacesAndFields) {
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].near[0].x += 1; }), testing::HasSubstr("is not flat"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.frusta[1].near.fill({1, 2, 3}); }), testing::HasSubstr("has no area"));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.feeds[0].pose.target = s.feeds[0].pose.eye; }),
              testing::HasSubstr("\"target\""));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.feeds[0].width = 0; }), testing::HasSubstr("\"width\""));
  EXPECT_THAT(errorAfter([](FeedSetup& s) { s.feeds[0].lens.focal.x = 0; }), testing::HasSubstr("\"focal\""));
  nlohmann::json json = nlohmann::json::parse(jsonText(test::tSetup()));
  json["colour"] = 1;
  EXPECT_THAT(setupError(json.dump()), testing::HasSubstr("\"colour\""));
  json.erase("colour");
  json["frusta"][1]["near"] = {1, 2, 3, 4};
  EXPECT_THAT(setupError(json.dump()), testing::HasSubstr("4 points"));
  json["frusta"][1].erase("near");
  EXPECT_THAT(setupError(json.dump()), testing::HasSubstr("\"near\""));
}

}  // namespace
}  // namespace ocelli
