// Where the eye is at each tick: by hand.
#include "study/views/head_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/task/task.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr double kTight = 1e-5;  // places are of single precision, radii of some units

HeadMotion headOf(const std::string& json) {
  const nlohmann::json value = nlohmann::json::parse(json);
  JsonFields fields(value, "head");
  HeadMotion head = HeadMotion::read(fields, loadProfile("test"));
  fields.rejectUnknown();
  return head;
}

std::string errorOfHead(const std::string& json) {
  try {
    headOf(json);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(HeadMotion, RestsWithoutOne) {
  const HeadMotion rest;
  EXPECT_FALSE(rest.moves());
  EXPECT_EQ(rest.poseCount(), 1u);
  EXPECT_EQ(rest.poseAt(12345), 0u);
  EXPECT_EQ(rest.eyeOf(0, {1, 2, 3}), glm::vec3(1, 2, 3));
}

// A quarter of the period after rest it is at the right end, after three quarters at the left one.
TEST(HeadMotion, SwaysAsASine) {
  const HeadMotion head = headOf(R"({"sway_degrees": 30, "seconds": 4, "images": 5})");
  EXPECT_EQ(head.poseCount(), 5u);
  const auto at = [&](double seconds) { return head.poseAt(std::lround(seconds * kTicksPerSecond)); };
  EXPECT_EQ(at(0), 2u);
  EXPECT_EQ(at(1), 4u);
  EXPECT_EQ(at(2), 2u);
  EXPECT_EQ(at(3), 0u);
  EXPECT_EQ(at(4), 2u);
  EXPECT_EQ(at(401), 4u);
  // The sine is 0.5 after a twelfth of a period, where the pose nearest to it changes from 3 of 15 degrees.
  EXPECT_EQ(at(4.0 / 12), 3u);
  const glm::vec3 right = head.eyeOf(4, {0, 0, 10});
  EXPECT_NEAR(right.x, 5, kTight);
  EXPECT_NEAR(right.y, 0, kTight);
  EXPECT_NEAR(right.z, 10 * std::sqrt(0.75), kTight);
  EXPECT_EQ(head.eyeOf(2, {0, 1, 10}), glm::vec3(0, 1, 10));
}

TEST(HeadMotion, KeepsItsDistance) {
  for (const char* axis : {"horizontal", "vertical"}) {
    const HeadMotion head = headOf(std::string(R"({"sway_degrees": 25, "axis": ")") + axis + "\"}");
    const glm::vec3 rest(0.3f, 0.5f, 9);
    for (size_t pose = 0; pose < head.poseCount(); ++pose) {
      EXPECT_NEAR(glm::length(head.eyeOf(pose, rest)), glm::length(rest), kTight);
    }
  }
  const HeadMotion up = headOf(R"({"sway_degrees": 30, "axis": "vertical", "images": 3})");
  EXPECT_NEAR(up.eyeOf(2, {0, 0, 10}).y, 5, kTight);
  EXPECT_NEAR(up.eyeOf(0, {0, 0, 10}).y, -5, kTight);
}

TEST(HeadMotion, FollowsARecordingAndStaysAtItsEnd) {
  const HeadMotion head =
      headOf(R"({"poses": [{"time": 1, "eye": [0, 0, 10]}, {"time": 3, "eye": [4, 0, 10]}], "images": 5})");
  EXPECT_EQ(head.poseCount(), 5u);
  for (size_t pose = 0; pose < 5; ++pose) {
    EXPECT_NEAR(head.eyeOf(pose, {0, 0, 7}).x, static_cast<double>(pose), kTight);
  }
  EXPECT_EQ(head.poseAt(0), 0u);
  EXPECT_EQ(head.poseAt(kTicksPerSecond), 2u);
  EXPECT_EQ(head.poseAt(2 * kTicksPerSecond), 4u);
  EXPECT_EQ(head.poseAt(500 * kTicksPerSecond), 4u);
}

TEST(HeadMotion, SaysWhatIsWrong) {
  EXPECT_THAT(errorOfHead("{}"), HasSubstr("sway_degrees"));
  EXPECT_THAT(errorOfHead(R"({"sway_degrees": 61})"), HasSubstr("sway_degrees"));
  EXPECT_THAT(errorOfHead(R"({"sway_degrees": 5, "images": 4})"), HasSubstr("odd"));
  EXPECT_THAT(errorOfHead(R"({"sway_degrees": 5, "axis": "round"})"), HasSubstr("axis"));
  EXPECT_THAT(errorOfHead(R"({"sway_degrees": 5, "poses": []})"), HasSubstr("poses"));
  EXPECT_THAT(errorOfHead(R"({"poses": [{"time": 0, "eye": [0, 0, 5]}]})"), HasSubstr("two or more"));
  EXPECT_THAT(errorOfHead(R"({"poses": [{"time": 0, "eye": [0, 0, 5]}, {"time": 1, "eye": [0, 0, 0.5]}]})"),
              HasSubstr("into the display"));
  EXPECT_THAT(errorOfHead(R"({"poses": [{"time": 0, "eye": [0, 0, 5]}, {"time": 1, "eye": [0, 0, 6]}], "axis": 1})"),
              HasSubstr("axis"));
}

}  // namespace
}  // namespace ocelli::test
