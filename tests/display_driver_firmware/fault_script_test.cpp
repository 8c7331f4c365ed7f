#include "display_driver/firmware/fault_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::string problemOf(const std::string& faults) {
  try {
    faultScriptFromJson("{\"faults\": [" + faults + "]}", "script");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The example of the header.
TEST(FaultScript, isReadAsItStands) {
  const FaultScript script = faultScriptFromJson(
      R"({"faults": [{"at_ms": 500, "fault": "stall"},
                     {"at_frame": 20, "fault": "unplug", "for_ms": 300},
                     {"at_ms": 900, "fault": "slow_link", "bytes_per_second": 2000000, "for_ms": 500}]})",
      "script");
  EXPECT_EQ(script, (FaultScript{{{.kind = FaultKind::kStall, .at = 500'000},
                                  {.kind = FaultKind::kUnplug, .afterFrames = 20, .duration = 300'000},
                                  {.kind = FaultKind::kSlowLink, .at = 900'000, .duration = 500'000, .amount = 2e6}}}));
}

TEST(FaultScript, everyKindHasItsName) {
  std::set<std::string> names;
  for (size_t i = 0; i < kFaultKinds; ++i) {
    names.insert(nameOf(static_cast<FaultKind>(i)));
  }
  EXPECT_EQ(names, (std::set<std::string>{"stall", "short_write", "slow_link", "unplug", "wrong_sequence", "bit_flips",
                                          "phase_drift", "full_buffers", "deaf_control"}));
}

TEST(FaultScript, comesBackFromItsText) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const FaultScript script = randomFaults(seed, 20, 5'000'000);
    ASSERT_TRUE(faultScriptFromJson(jsonText(script), "script") == script) << jsonText(script);
  }
}

TEST(FaultScript, isReadFromAFile) {
  const test::TemporaryFolder folder;
  const auto path = folder / "faults.json";
  const FaultScript script = randomFaults(1, 5, 1'000'000);
  std::ofstream(path) << jsonText(script);
  EXPECT_EQ(readFaultScript(path), script);
  EXPECT_THROW(readFaultScript(folder / "missing.json"), InputError);
}

TEST(FaultScript, problemsNameFaultAndField) {
  EXPECT_THAT(problemOf(R"({"fault": "stall"}, {"fault": "fire"})"),
              AllOf(HasSubstr("fault 2"), HasSubstr("\"fault\""), HasSubstr("deaf_control")));
  EXPECT_THAT(problemOf(R"({"fault": "unplug"})"), AllOf(HasSubstr("fault 1"), HasSubstr("for_ms")));
  EXPECT_THAT(problemOf(R"({"fault": "slow_link", "for_ms": 1})"), HasSubstr("bytes_per_second"));
  EXPECT_THAT(problemOf(R"({"fault": "slow_link", "for_ms": 1, "bytes_per_second": 0})"),
              HasSubstr("bytes_per_second"));
  EXPECT_THAT(problemOf(R"({"fault": "phase_drift", "for_ms": 1, "rate": 9})"), HasSubstr("rate"));
  EXPECT_THAT(problemOf(R"({"fault": "stall", "for_ms": 1})"), HasSubstr("for_ms"));
  EXPECT_THAT(problemOf(R"({"fault": "stall", "at_ms": -1})"), HasSubstr("at_ms"));
  EXPECT_THAT(problemOf(R"({"at_ms": 1})"), HasSubstr("fault"));
  EXPECT_THROW(faultScriptFromJson("[]", "script"), InputError);
  EXPECT_THROW(faultScriptFromJson("{}", "script"), InputError);
  EXPECT_THROW(faultScriptFromJson("{\"faults\": {}}", "script"), InputError);
  EXPECT_THROW(faultScriptFromJson("", "script"), InputError);
  EXPECT_TRUE(faultScriptFromJson("{\"faults\": []}", "script").faults.empty());
}

TEST(FaultScript, randomOnesAreOfAllKindsInTheirOrderAndTheSameForASeed) {
  std::set<FaultKind> kinds;
  const FaultScript script = randomFaults(7, 500, 1'000'000);
  for (size_t i = 0; i < script.faults.size(); ++i) {
    kinds.insert(script.faults[i].kind);
    EXPECT_LT(script.faults[i].at, 1'000'000);
    EXPECT_TRUE(i == 0 || script.faults[i - 1].at <= script.faults[i].at);
  }
  EXPECT_EQ(script.faults.size(), 500u);
  EXPECT_EQ(kinds.size(), kFaultKinds);
  EXPECT_EQ(script, randomFaults(7, 500, 1'000'000));
  EXPECT_FALSE(script == randomFaults(8, 500, 1'000'000));
}

}  // namespace
}  // namespace ocelli
