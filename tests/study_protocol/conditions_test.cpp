// Protocols of more than two conditions, with factors and a table of cases: tests/study_protocol/conditions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "study/protocol/check_report.h"
#include "study/protocol/protocol_warnings.h"
#include "study/protocol/schedule.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::filesystem::path kFolder = OCELLI_SOURCE_DIR "/tests/study_protocol/conditions";

TEST(ProtocolOfConditions, HasItsFactorsAndTheCasesOfItsTable) {
  const Protocol protocol = readProtocol(kFolder / "crossed.json");
  ASSERT_EQ(protocol.conditions.names.size(), 4u);
  EXPECT_EQ(protocol.conditions.views.size(), 4u);
  EXPECT_EQ(protocol.conditions.names.list[3].levels, (FactorLevels{{"panes", "three"}, {"field", "wide"}}));
  const ProtocolBlock& block = protocol.blocks[0];
  EXPECT_EQ(block.task->caseCount(), 8);
  EXPECT_EQ(block.task->caseInfo(2).label, "c");
  ASSERT_EQ(block.caseLevels.size(), 8u);
  EXPECT_EQ(block.caseLevels[2].at("distance"), "near");
  EXPECT_THAT(protocol.text, Not(HasSubstr("crossed.csv"))) << "a database stands alone";
  const Protocol stored = protocolFromJsonText(protocol.text, "study.db");
  EXPECT_EQ(stored.sha256, protocol.sha256);
  EXPECT_EQ(stored.blocks[0].caseLevels, block.caseLevels);
  EXPECT_EQ(scheduleOf(stored, 3, 1, 3), scheduleOf(protocol, 3, 1, 3));
  EXPECT_EQ(scheduleOf(protocol, 3, 1, 3).trials.size(), 32u);
  EXPECT_THAT(protocol.survey->fields[0].favors, ElementsAre(conditionAt(1), conditionAt(3)));
}

TEST(ProtocolOfConditions, ShowsEachConditionItsView) {
  for (const char* name : {"crossed.json", "five_views.json"}) {
    const Protocol protocol = readProtocol(kFolder / name);
    std::set<size_t> panes;
    for (const TrialView view : protocol.conditions.names.all()) {
      TrialPlan plan;
      plan.task = "find";
      plan.view = view;
      const TrialScreen screen{640, 400, 60};
      const TrialLayout layout = protocol.blocks[0].task->start(plan, screen)->layout();
      ASSERT_FALSE(layout.views.empty()) << name << ", " << protocol.nameOf(view);
      panes.insert(layout.views.size());
    }
    EXPECT_EQ(panes, (std::set<size_t>{1, 3})) << name;
  }
}

TEST(ProtocolOfConditions, IsToldByTheCheck) {
  const Protocol protocol = readProtocol(kFolder / "crossed.json");
  CheckOptions options;
  options.subjects = 16;
  const std::string text = checkReport(protocol, options);
  EXPECT_THAT(text, HasSubstr("three-wide    three wide panes              panes three, field wide\n"));
  EXPECT_THAT(text, HasSubstr("find: view x place in the block"));
  EXPECT_THAT(text, HasSubstr("one-narrow first"));
  EXPECT_THAT(text, Not(HasSubstr("missing:")));
  options.asJson = true;
  const nlohmann::json json = nlohmann::json::parse(checkReport(protocol, options));
  EXPECT_EQ(json["conditions"][1]["factors"]["field"], "wide");
  EXPECT_TRUE(json["missing_cells"].empty());
  for (const nlohmann::json& table : json["balance"]) {
    if (table["factors"] == "find: view x place in the block" || table["factors"] == "first view") {
      EXPECT_EQ(table["difference"], 0) << table["factors"];
    }
  }
}

TEST(ProtocolOfConditions, IsWarnedOfMissingAndDoubledCells) {
  nlohmann::json json = nlohmann::json::parse(readProtocol(kFolder / "crossed.json").text);
  json["conditions"][3]["factors"]["field"] = "narrow";
  const Protocol protocol = protocolFromJsonText(json.dump(), "study.json");
  EXPECT_THAT(warningsOf(protocol, 1), Contains(HasSubstr("no condition has the levels three, wide")));
  EXPECT_THAT(warningsOf(protocol, 1),
              Contains(HasSubstr("several conditions have the levels three, narrow (three-narrow, three-wide)")));
  EXPECT_THAT(checkReport(protocol, {}), HasSubstr("  missing: three, wide\n"));
}

TEST(ProtocolOfConditions, TellsFileLineAndColumnOfItsTable) {
  const TemporaryFolder folder;
  const std::string protocol = readFile(kFolder / "crossed.json");
  writeFile(folder / "crossed.json", protocol);
  const auto errorOf = [&](const std::string& table) {
    writeFile(folder / "crossed.csv", table);
    try {
      readProtocol(folder / "crossed.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(errorOf("row,column,distance\n0,0,near\n1,1,far\n"), "");
  EXPECT_THAT(errorOf("row,column,distance\n0,0,near\n9,1,far\n"),
              HasSubstr("crossed.csv:3, column 1 (row): field \"row\" must lie between 0 and 3"));
  EXPECT_THAT(errorOf("row,column,distance\n0,0,near\n1,1,close\n"),
              HasSubstr("crossed.csv:3, column 3 (distance): field \"distance\" must be one of near, far"));
  EXPECT_THAT(errorOf("row,column,colour,distance\n0,0,red,near\n"),
              HasSubstr("crossed.csv:2, column 3 (colour): field \"colour\" is unknown"));
  EXPECT_THAT(errorOf("row,column,distance\n0,0,near\n1,1,\n"), HasSubstr("crossed.csv:3"));
  EXPECT_THAT(errorOf("row,distance\n0,near\n"), HasSubstr("crossed.csv:2: field \"column\" is missing"));
  std::string moved = protocol;
  moved.replace(moved.find("\"limit_seconds\": 120"), 20, "\"limit_seconds\": 0.1");
  writeFile(folder / "crossed.json", moved);
  EXPECT_THAT(errorOf("row,column,distance\n0,0,near\n"), HasSubstr("crossed.json:61, \"blocks\" 1 (find): field"))
      << "what is wrong elsewhere has its line in the protocol";
}

}  // namespace
}  // namespace ocelli::test
