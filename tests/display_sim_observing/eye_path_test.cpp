#include "display_sim/observing/eye_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

// Coordinates are floats of about 10.
constexpr float kPathRounding = 1e-5f;

void expectNear(const glm::vec3& got, const glm::vec3& expected) {
  EXPECT_LT(glm::distance(got, expected), kPathRounding) << got.x << "," << got.y << "," << got.z;
}

TEST(EyePath, eyesLieOnEitherSide) {
  const EyePair front = eyePair({0, 0, 10}, 0.5);
  expectNear(front.left, {-0.25f, 0, 10});
  expectNear(front.right, {0.25f, 0, 10});
  const EyePair fromTheRight = eyePair({8, 3, 0}, 0.5);  // looks along -x: its right is -z
  expectNear(fromTheRight.left, {8, 3, 0.25f});
  expectNear(fromTheRight.right, {8, 3, -0.25f});
}

TEST(EyePath, aTurntableGoesAround) {
  const std::vector<glm::vec3> eyes = turntableEyes({0, 2, 10}, 4);
  ASSERT_EQ(eyes.size(), 4u);
  expectNear(eyes[0], {0, 2, 10});
  expectNear(eyes[1], {10, 2, 0});  // counterclockwise from above: from in front to the right
  expectNear(eyes[2], {0, 2, -10});
  expectNear(eyes[3], {-10, 2, 0});
}

TEST(EyePath, csvAndJsonAreRead) {
  const test::TemporaryFolder folder;
  const std::vector<EyePose> csv =
      readEyePath(folder.write("way.csv", "time,x,y,z\r\n0, 0,0.5,10\n\n0.5,1e0,0.5 ,-9.5\n"));
  const std::vector<EyePose> json = readEyePath(folder.write(
      "way.json", R"({"poses": [{"time": 0, "eye": [0, 0.5, 10]}, {"time": 0.5, "eye": [1, 0.5, -9.5]}]})"));
  const std::vector<EyePose> marked = eyePathFromCsv("\xef\xbb\xbftime,x,y,z\n0,0,0.5,10\n0.5,1,0.5,-9.5\n", "way.csv");
  for (const auto& poses : {csv, marked, json}) {
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_EQ(poses[0].seconds, 0);
    EXPECT_EQ(poses[0].eye, glm::vec3(0, 0.5f, 10));
    EXPECT_EQ(poses[1].seconds, 0.5);
    EXPECT_EQ(poses[1].eye, glm::vec3(1, 0.5f, -9.5f));
  }
}

TEST(EyePath, badFilesNameTheLineOrTheField) {
  const auto problemOf = [](const auto& read) -> std::string {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    return "read";
  };
  const auto csv = [&](const std::string& text) { return problemOf([&] { eyePathFromCsv(text, "way.csv"); }); };
  const auto json = [&](const std::string& text) { return problemOf([&] { eyePathFromJson(text, "way.json"); }); };
  EXPECT_THAT(csv(""), HasSubstr("no poses"));
  EXPECT_THAT(csv("time,x,y,z\n"), HasSubstr("no poses"));
  EXPECT_THAT(csv("0,0,0,10\n"), HasSubstr("way.csv:1"));
  for (const char* line : {"1,2,3", "1,2,3,4,5", "1,2,3,", "1,2,3,x", "1,2,3,nan", "1,2,3,1e9", "1,2 3,4,5", ",,,"}) {
    EXPECT_THAT(csv(std::string("time,x,y,z\n0,0,0,10\n") + line + "\n"), HasSubstr("way.csv:3")) << line;
  }
  EXPECT_THAT(csv("time,x,y,z\n1,0,0,10\n1,0,0,10\n"), HasSubstr("pose 2"));
  EXPECT_THAT(json("{}"), HasSubstr("poses"));
  EXPECT_THAT(json(R"({"poses": 3})"), HasSubstr("array"));
  EXPECT_THAT(json(R"({"poses": []})"), HasSubstr("no poses"));
  EXPECT_THAT(json(R"({"poses": [{"time": 0, "eye": [1, 2]}]})"), HasSubstr("pose 1"));
  EXPECT_THAT(json(R"({"poses": [{"time": 0, "eye": [1, 2, 3], "up": 1}]})"), HasSubstr("up"));
  EXPECT_THAT(problemOf([] { readEyePath("way.txt"); }), HasSubstr(".csv"));
  EXPECT_THAT(problemOf([] { readEyePath("no-such-way.csv"); }), HasSubstr("no-such-way.csv"));
}

TEST(EyePath, framesLieOnStraightLines) {
  const std::vector<EyePose> poses = {{1, {0, 0, 10}}, {2, {4, 0, 10}}, {2.5, {4, 2, 10}}};
  const std::vector<glm::vec3> eyes = eyesAlong(poses, 4);
  ASSERT_EQ(eyes.size(), 7u) << "both ends";
  expectNear(eyes[0], {0, 0, 10});
  expectNear(eyes[1], {1, 0, 10});
  expectNear(eyes[4], {4, 0, 10});
  expectNear(eyes[5], {4, 1, 10});
  expectNear(eyes[6], {4, 2, 10});
  EXPECT_EQ(eyesAlong({{3, {0, 0, 10}}}, 24).size(), 1u);
  EXPECT_THROW(eyesAlong(poses, 1e6), InputError);
}

}  // namespace
}  // namespace ocelli
