#include "oc_core/remote_measure/remote_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

View start() {
  View view;
  view.fovVerticalDegrees = 20;
  return view;
}

double zoomOf(const View& view) {
  return 1 / std::tan(radiansFromDegrees(view.fovVerticalDegrees) / 2);
}

TEST(RemotePath, hasSmoothBuiltInOnesFromTheView) {
  for (const RemotePathKind& kind : remotePaths()) {
    const RemotePath path = remotePath(kind.name, start(), 0, 60);
    ASSERT_EQ(path.views.size(), 900u) << kind.name;
    EXPECT_NEAR(glm::distance(path.views[0].eye, start().eye), 0, 1e-5) << kind.name;
    EXPECT_NEAR(glm::distance(glm::normalize(path.views[0].target - path.views[0].eye), glm::vec3(0, 0, -1)), 0, 1e-5);
    EXPECT_NEAR(path.views[0].fovVerticalDegrees, 20, 1e-5) << kind.name;
    bool moves = false;
    for (size_t i = 1; i < path.views.size(); ++i) {
      // No jumps: a sixtieth of a second turns by less than a thirtieth of the field of view.
      const glm::vec3 a = glm::normalize(path.views[i - 1].target - path.views[i - 1].eye);
      const glm::vec3 b = glm::normalize(path.views[i].target - path.views[i].eye);
      ASSERT_LT(glm::distance(a, b), radiansFromDegrees(20) / 30) << kind.name << " " << i;
      ASSERT_LT(std::abs(std::log(zoomOf(path.views[i]) / zoomOf(path.views[i - 1]))), 0.03) << kind.name << " " << i;
      moves = moves || path.views[i] != path.views[0];
    }
    EXPECT_TRUE(moves) << kind.name;
  }
}

TEST(RemotePath, zoomsByTwo) {
  const RemotePath path = remotePath("zoom", start(), 450, 60);
  EXPECT_NEAR(zoomOf(path.views[225]) / zoomOf(path.views[0]), 2, 1e-6);
  EXPECT_EQ(path.seconds(), 7.5);
}

TEST(RemotePath, isTheSameAtAnyRate) {
  const RemotePath slow = remotePath("look-around", start(), 30, 30);
  const RemotePath fast = remotePath("look-around", start(), 60, 60);
  for (size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(slow.views[i], fast.views[2 * i]);
  }
}

TEST(RemotePath, goesThroughTheViewsOfAFile) {
  const std::string text = R"({"views": [
    {"seconds": 0, "view": {"eye": [0, 0, 10], "fov_vertical_degrees": 40}},
    {"seconds": 1, "view": {"eye": [1, 0, 10], "fov_vertical_degrees": 20}},
    {"seconds": 3, "view": {"eye": [3, 0, 10], "fov_vertical_degrees": 10}}]})";
  const RemotePath path = remotePathFromJson(text, "walk.json", 0, 10);
  ASSERT_EQ(path.views.size(), 31u);
  EXPECT_EQ(path.views[0].eye, glm::vec3(0, 0, 10));
  EXPECT_NEAR(path.views[10].eye.x, 1, 1e-6);
  EXPECT_NEAR(path.views[10].fovVerticalDegrees, 20, 1e-6);
  // The eye goes at a constant speed of 1, which cubic curves keep.
  EXPECT_NEAR(path.views[5].eye.x, 0.5, 1e-6);
  EXPECT_NEAR(path.views[20].eye.x, 2, 1e-6);
  EXPECT_NEAR(path.views[30].eye.x, 3, 1e-6);
  // More frames than it has stay at its end.
  EXPECT_EQ(remotePathFromJson(text, "walk.json", 40, 10).views.back(), path.views.back());
  EXPECT_EQ(remotePathFromJson(text, "walk.json", 5, 10).views.size(), 5u);
}

TEST(RemotePath, isReadFromAFile) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("walk.json", R"({"views": [{"seconds": 0, "view": {"eye": [0, 0, 5]}}]})");
  EXPECT_EQ(remotePath(file, start(), 0, 60).views.size(), 1u);
}

TEST(RemotePath, refusesWhatIsWrong) {
  const auto failure = [](const std::string& text) {
    try {
      remotePathFromJson(text, "walk.json", 0, 60);
      return std::string("nothing");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(failure("{}"), HasSubstr("\"views\" is missing"));
  EXPECT_THAT(failure(R"({"views": []})"), HasSubstr("views"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": 0}]})"), HasSubstr("view"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": -1, "view": {}}]})"), HasSubstr("seconds"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": 1, "view": {}}, {"seconds": 1, "view": {}}]})"), HasSubstr("later"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": 0, "view": {"eye": [0, 0, 0]}}]})"), HasSubstr("eye"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": 0, "view": {}, "roll": 1}]})"), HasSubstr("roll"));
  EXPECT_THAT(failure(R"({"view": []})"), HasSubstr("remote_path.schema.json"));
  EXPECT_THAT(failure(R"({"views": [{"seconds": 0, "view": {}}, {"seconds": 36000, "view": {}}]})"),
              HasSubstr("100,000 frames"));
  try {
    remotePath("stroll", start(), 10, 60);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("look-around"));
  }
}

TEST(RemotePath, hasTheFieldsOfItsSchema) {
  const auto schema = nlohmann::json::parse(readFile(OCELLI_PATH_SCHEMA));
  const auto& key = schema["properties"]["views"]["items"];
  EXPECT_EQ(key["required"], nlohmann::json({"seconds", "view"}));
  const double most = key["properties"]["seconds"]["maximum"];
  const auto text = [](double seconds) {
    return R"({"views": [{"seconds": )" + std::to_string(seconds) + R"(, "view": {}}]})";
  };
  EXPECT_NO_THROW(remotePathFromJson(text(most), "walk.json", 1, 1));
  EXPECT_THROW(remotePathFromJson(text(most + 1), "walk.json", 1, 1), InputError);
}

}  // namespace
}  // namespace ocelli
