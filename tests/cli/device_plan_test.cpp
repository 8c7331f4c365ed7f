// `ocelli device plan` from outside: its figures add up, and its verdict follows from them. Times are this machine's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

const std::string kPlan = "device plan builtin:box --profile test ";

nlohmann::json jsonOf(const std::string& arguments) {
  const ProgramResult result = runProgram(kPlan + arguments + " --json");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  return nlohmann::json::parse(result.output);
}

TEST(DevicePlan, TellsEachCodingWholeAndWithChanges) {
  const nlohmann::json json = jsonOf("--link usb2 --rate 0.5");
  EXPECT_EQ(json["link_bytes_per_second"], 40e6);
  EXPECT_EQ(json["wanted_hertz"], 0.5);
  EXPECT_EQ(json["reached"], true);
  EXPECT_TRUE(json["alternatives"].empty());
  const nlohmann::json& codings = json["plan"]["codings"];
  ASSERT_EQ(codings.size(), 6u);
  for (const nlohmann::json& coding : codings) {
    const double bytes = coding["payload_bytes"].get<double>() + coding["overhead_bytes"].get<double>();
    EXPECT_NEAR(coding["link_hertz"].get<double>(), 40e6 / bytes, 1e-6 * 40e6 / bytes);
    EXPECT_LE(coding["hertz"], coding["link_hertz"]);
    EXPECT_EQ(coding["limit"], "none");
  }
  // 24 slices of 3 planes of 64 rows of 8 bytes.
  EXPECT_EQ(codings[0]["payload_bytes"], 24.0 * 3 * 64 * 8);
  EXPECT_LT(codings[2]["payload_bytes"], codings[0]["payload_bytes"]);
}

TEST(DevicePlan, ASceneAtRestHasNoChanges) {
  const nlohmann::json json = jsonOf("--link usb2 --turn 0");
  for (size_t i = 3; i < 6; ++i) {
    EXPECT_EQ(json["plan"]["codings"][i]["payload_bytes"], 0);
  }
}

TEST(DevicePlan, SaysWhatMayHelpWhereTheLinkIsTooSlow) {
  const nlohmann::json json = jsonOf("--link 2e4");
  EXPECT_EQ(json["reached"], false);
  EXPECT_EQ(json["wanted_hertz"], 24);  // of the profile
  std::vector<std::string> names;
  for (const nlohmann::json& other : json["alternatives"]) {
    names.push_back(other["name"]);
  }
  EXPECT_THAT(names, testing::ElementsAre("--undithered", "half the columns and rows", "its OCRI (ddoc)"));
  const ProgramResult text = runProgram(kPlan + "--link 2e4");
  EXPECT_THAT(text.output, testing::AllOf(HasSubstr("of 24 frames a second at best"), HasSubstr("what may help"),
                                          HasSubstr("half the columns"), HasSubstr("link")));
}

TEST(DevicePlan, AnswersWrongOptions) {
  for (const std::string wrong : {"--link usb9", "--link usb2 --rate -1", "--link usb2 --turn 400", ""}) {
    const ProgramResult result = runProgram(kPlan + wrong);
    EXPECT_EQ(result.exitCode, 2) << wrong;
    EXPECT_THAT(result.error, HasSubstr("try: ")) << wrong;
  }
}

}  // namespace
}  // namespace ocelli::test
