#include "analysis/dataset/csv_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "analysis/dataset/database.h"
#include "study/export/study_export.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

struct CsvExport : ::testing::Test {
  SampleFolder folder;
  std::string path = folder.file("study.db");
  std::string tables = folder.file("tables");

  void exportSmallStudy() {
    SampleStudy study(path);
    fillSmallStudy(study);
    SampleTrial trial;
    trial.plan.reset();
    study.addTrial(trial);
    trial.plan = 3;
    trial.ending = "redone";
    trial.answer = "=2, \"x\"\nand more";
    study.addTrial(trial);
    trial.ending = "completed";
    trial.response = 1.0 / 3;
    study.addTrial(trial);
    exportStudy(path, tables, {});
  }
  std::string errorWith(const std::string& table, const std::string& from, const std::string& to) {
    const std::string file = tables + "/" + table;
    const std::string whole = textOf(file);
    const size_t at = whole.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(file, std::ios::binary) << std::string(whole).replace(at, from.size(), to);
    const std::string error = analysisErrorOf([&] { readCsvExport(tables); });
    std::ofstream(file, std::ios::binary) << whole;
    return error;
  }
};

TEST_F(CsvExport, isTheSameDataAsItsDatabase) {
  exportSmallStudy();
  const Dataset fromDatabase = readDatabase(path);
  const Dataset fromTables = readCsvExport(tables);
  EXPECT_EQ(dataHash(fromTables), dataHash(fromDatabase));
  ASSERT_EQ(fromTables.trials.size(), fromDatabase.trials.size());
  for (size_t i = 0; i < fromTables.trials.size(); ++i) {
    EXPECT_EQ(fromTables.trials[i].digest, fromDatabase.trials[i].digest) << i;
    EXPECT_EQ(fromTables.trials[i].measures, fromDatabase.trials[i].measures) << i;
    EXPECT_EQ(fromTables.trials[i].responseSeconds, fromDatabase.trials[i].responseSeconds) << i;
  }
  ASSERT_EQ(fromTables.otherAttempts.size(), fromDatabase.otherAttempts.size());
  for (size_t i = 0; i < fromTables.otherAttempts.size(); ++i) {
    EXPECT_EQ(fromTables.otherAttempts[i].why, fromDatabase.otherAttempts[i].why) << i;
  }
  EXPECT_FALSE(fromTables.consentIsKnown);
  EXPECT_EQ(fromTables.trials.back().answer, "=2, \"x\"\nand more");
}

TEST_F(CsvExport, takesTheProtocolFromItsFile) {
  exportSmallStudy();
  const std::string protocol = folder.file("protocol.json");
  std::ofstream(protocol, std::ios::binary) << kSampleProtocol;
  EXPECT_EQ(readCsvExport(tables, protocol).sources[0].protocolSha256, readDatabase(path).sources[0].protocolSha256);
}

TEST_F(CsvExport, brokenRowsAreNamed) {
  exportSmallStudy();
  EXPECT_THAT(errorWith("trials.csv", "\r\n2,", "\r\n"), HasSubstr("trials.csv:3: this row has"));
  EXPECT_THAT(errorWith("trials.csv", ",ppc,", ",cpp,"), HasSubstr("trials.csv:2: column \"view\" is \"cpp\""));
  EXPECT_THAT(errorWith("trials.csv", ",60,", ",6o,"), HasSubstr("column \"response_s\" is \"6o\""));
  EXPECT_THAT(errorWith("trials.csv", ",60,", ",nan,"), HasSubstr("column \"response_s\" is \"nan\""));
  EXPECT_THAT(errorWith("trials.csv", ",60,", ",-60,"), HasSubstr("trials.csv:8: column \"response_s\" is -60"));
  EXPECT_THAT(errorWith("trials.csv", ",find,", "," + std::string(2000, 'x') + ","),
              HasSubstr("column \"task\" has 2000 bytes"));
  EXPECT_THAT(errorWith("trials.csv", "case_label", "label"), HasSubstr("column \"case_label\" is missing"));
  EXPECT_THAT(errorWith("trials.csv", "case_label", "view"), HasSubstr("stands twice"));
  EXPECT_THAT(errorWith("answers.csv", "demographics", "\"demographics"),
              HasSubstr("a quote of this row does not end"));
  EXPECT_THAT(errorWith("subjects.csv", "person", "simulated_observer"), HasSubstr("contradicts"));
  EXPECT_THAT(analysisErrorOf([&] { readCsvExport(folder.file("nowhere")); }), HasSubstr("cannot read this file"));
  EXPECT_EQ(analysisErrorOf([&] { readCsvExport(tables); }), "");
}

TEST_F(CsvExport, viewsAreTheConditionsOfTheProtocol) {
  exportSmallStudy();
  std::string text = textOf(tables + "/trials.csv");
  for (const auto& [from, to] : {std::pair(",ppc,", ",flat,"), std::pair(",gc,", ",bent,")}) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
      text.replace(at, std::string(from).size(), to);
    }
  }
  std::ofstream(tables + "/trials.csv", std::ios::binary) << text;
  EXPECT_THAT(analysisErrorOf([&] { readCsvExport(tables); }),
              HasSubstr("must be ppc or gc, unless --protocol FILE names other conditions"));
  const std::string protocol = folder.file("protocol.json");
  std::ofstream(protocol) << R"({"name": "a", "conditions": [{"name": "flat"}, {"name": "bent"}]})";
  const Dataset read = readCsvExport(tables, protocol);
  const Dataset usual = readDatabase(path);
  ASSERT_EQ(read.trials.size(), usual.trials.size());
  for (size_t i = 0; i < read.trials.size(); ++i) {
    EXPECT_EQ(read.trials[i].view, usual.trials[i].view) << i;
  }
  EXPECT_EQ(read.conditions.nameOf(TrialView::kOther), "bent");
}

}  // namespace
}  // namespace ocelli::test
