#include "analysis/tables/paper_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "analysis/dataset/merge.h"
#include "analysis/tables/neutral_tables.h"
#include "analysis/tables/published_values.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

struct PaperTables : ::testing::Test {
  SampleFolder folder;
  std::string path = folder.file("study.db");

  std::vector<Table> tables(const PaperTableOptions& options = {}) const {
    return paperTables(applyPlan(merge({readSource(path)}), AnalysisPlan()), options);
  }
  std::string text(const std::string& cell, const PaperTableOptions& options = {}) const {
    const std::vector<Table> all = tables(options);
    const Cell* found = findCell(all, cell);
    return found == nullptr ? "no such cell" : displayText(*found);
  }
};

TEST_F(PaperTables, countWhatStands) {
  SampleStudy study(path);
  fillSmallStudy(study);
  EXPECT_EQ(text("section-7.4.2/stationary/ppc"), "11.0 s (n = 1)");
  EXPECT_EQ(text("section-7.4.2/stationary/ppc", {TimeoutsInMeans::kSetToLimit}), "35.5 s (n = 2)");
  EXPECT_EQ(text("section-7.4.2/stationary/faster"), "45.5 %");
  EXPECT_EQ(text("section-7.4.2/stationary/ppc/published"), "20.4 s");
  EXPECT_EQ(text("section-7.4.2/moving/gc/published"), "9.11 s");
  EXPECT_EQ(text("section-7.4.2/moving/ppc"), "no trials");
  EXPECT_EQ(text("time-outs/stationary/ppc"), "50.0 % (1/2)");
  EXPECT_EQ(text("figure-7.5/stationary/location-1/gc"), "6.0 s (n = 2)");
  EXPECT_EQ(text("section-7.4.3/stationary/gc"), "100.0 % (2/2)");
  EXPECT_EQ(text("table-7.2-left/stationary/5-s/gc"), "100.0 % (2/2)");
  EXPECT_EQ(text("table-7.2-left/stationary/10-s/gc"), "no trials");
  EXPECT_EQ(text("table-7.2-right/stationary/unique/gc"), "100.0 % (2/2)");
  EXPECT_EQ(text("table-7.1/stationary/session-1/gc"), "no trials");  // nobody came three times
  EXPECT_EQ(text("count-errors/stationary/gc"), "0.00 (n = 4)");
  EXPECT_EQ(text("section-7.4.4/all/gc"), "no trials");
  EXPECT_EQ(text("section-7.4.5/easier-find"), "4.50 (n = 2)");
  EXPECT_EQ(text("section-7.4.5/easier-path"), "no answers");
  EXPECT_EQ(text("subjects/analysed"), "2");
  EXPECT_EQ(text("subjects/analysed/published"), "45");
  EXPECT_EQ(text("subjects/completed-2"), "2");
  EXPECT_EQ(text("subjects/completed-3"), "0");
  EXPECT_EQ(text("subjects/enrolled/published"), "not reported");
}

TEST_F(PaperTables, ofOtherProtocolsHaveNeitherItsNamesNorItsNumbers) {
  SampleStudy study(path);
  fillSmallStudy(study);  // of two sessions
  Dataset data = merge({readSource(path)});
  EXPECT_TRUE(isOfRosen2010(data));
  for (const char* other : {"short", "rosen2010b", ""}) {
    data.sources[0].protocolName = other;
    EXPECT_FALSE(isOfRosen2010(data));
    const std::vector<Table> all = paperTables(applyPlan(data, AnalysisPlan()));
    EXPECT_EQ(all.size(), 11u) << "nobody was shown a path";
    EXPECT_EQ(findCell(all, "path-means/all/gc"), nullptr);
    for (const Table& table : all) {
      const std::string text = plainText(table) + cellsCsv({table});
      for (const char* word : {"7.1", "7.4", "Section", "Figure", "the text", "not reported", "easier_path", ",1,,"}) {
        EXPECT_EQ(text.find(word), std::string::npos) << word << " in " << text;
      }
      for (const TableRow& row : table.rows) {
        EXPECT_EQ(row.cells.size(), table.cellNames.size()) << table.name;
        for (const Cell& cell : row.cells) {
          EXPECT_FALSE(cell.isPublished()) << cell.name;
          EXPECT_TRUE(cell.name.starts_with(table.name + "/")) << cell.name;
          for (const std::string& part : cell.cells) {
            EXPECT_NE(findCell(all, part), nullptr) << part;
          }
        }
      }
    }
    EXPECT_EQ(displayText(*findCell(all, "find-means/stationary/faster")), "45.5 %");
    EXPECT_EQ(displayText(*findCell(all, "find-by-session/stationary/session-2/gc")), "7.0 s (n = 2)");
    EXPECT_EQ(findCell(all, "find-by-session/stationary/session-3/gc"), nullptr) << "two sessions were planned";
    EXPECT_EQ(displayText(*findCell(all, "survey-means/easier-find")), "4.50 (n = 2)");
  }
}

TEST_F(PaperTables, everyCellHasANameOfItsOwnAndARow) {
  SampleStudy study(path);
  fillSmallStudy(study);
  SampleTrial hostile;
  for (int i = 0; i < 3; ++i) {
    hostile.plan = 10 + i;
    hostile.caseIndex = 5 + i;
    hostile.caseLabel = i == 0 ? "Location 1" : "<script>";
    study.addTrial(hostile);
  }
  std::set<std::string> names;
  for (const Table& table : tables()) {
    for (const TableRow& row : table.rows) {
      EXPECT_EQ(row.heads.size(), table.headNames.size()) << table.name;
      EXPECT_EQ(row.cells.size(), table.cellNames.size()) << table.name;
      for (const Cell& cell : row.cells) {
        EXPECT_TRUE(names.insert(cell.name).second) << cell.name;
        EXPECT_TRUE(cell.name.starts_with(table.name + "/")) << cell.name;
        EXPECT_NE(displayText(cell), "") << cell.name;
        if (cell.from == Cell::From::kTrials || cell.from == Cell::From::kAnswers) {
          EXPECT_EQ(cell.denominator, static_cast<int64_t>(cell.rows.size())) << cell.name;
        }
        if (cell.from == Cell::From::kSubjects && cell.value) {
          EXPECT_EQ(*cell.value, static_cast<double>(cell.subjects.size())) << cell.name;
        }
      }
    }
  }
  EXPECT_TRUE(names.contains("figure-7.5/stationary/script/ppc"));
  EXPECT_TRUE(names.contains("figure-7.5/stationary/script-2/ppc"));
  EXPECT_TRUE(names.contains("figure-7.5/stationary/location-1-2/ppc"));
}

TEST_F(PaperTables, nothingGivesNoNumbers) {
  SampleStudy study(path);
  for (const Table& table : tables()) {
    EXPECT_EQ(plainText(table).find("nan"), std::string::npos) << plainText(table);
    for (const TableRow& row : table.rows) {
      for (const Cell& cell : row.cells) {
        EXPECT_TRUE(cell.isPublished() || cell.from == Cell::From::kSubjects || !cell.value) << cell.name;
      }
    }
  }
}

TEST_F(PaperTables, oneSubjectInOneView) {
  SampleStudy study(path);
  study.addSubject("S01");
  study.addSession("S01", 1, "aborted");
  study.addTrial({});
  EXPECT_EQ(text("section-7.4.2/stationary/ppc"), "10.0 s (n = 1)");
  EXPECT_EQ(text("section-7.4.2/stationary/gc"), "no trials");
  EXPECT_EQ(text("section-7.4.2/stationary/faster"), "not available");
  EXPECT_EQ(text("subjects/consented"), "no consent is recorded");
}

TEST_F(PaperTables, sessionsThatAreMissingMakeNoThreeSessions) {
  SampleStudy study(path);
  study.addSubject("S01");
  study.addSession("S01", 3);
  study.addSubject("S02");
  for (const int session : {1, 2, 3}) {
    study.addSession("S02", session, session == 2 ? "unwell" : "completed");
  }
  study.addSubject("S03");
  for (const int session : {1, 2, 3}) {
    study.addSession("S03", session);
  }
  SampleTrial trial;
  trial.session = 3;
  for (const char* subject : {"S01", "S02", "S03"}) {
    trial.subject = subject;
    study.addTrial(trial);
  }
  EXPECT_EQ(text("table-7.1/stationary/session-3/ppc"), "10.0 s (n = 1)");  // S03
  EXPECT_EQ(text("table-7.1/stationary/session-1/ppc"), "no trials");
  EXPECT_EQ(text("subjects/completed-3"), "1");
  EXPECT_EQ(text("section-7.4.2/stationary/ppc"), "no trials");
}

TEST(PublishedValues, areThoseOfTheText) {
  EXPECT_EQ(publishedTable71(false, 1).pinhole, 19.7);
  EXPECT_EQ(publishedTable71(true, 3).graph, 8.2);
  EXPECT_EQ(publishedTable73(true, 2).graph, 98.0);
  EXPECT_EQ(publishedTable72(false, 20.0).pinhole, 56.5);
  EXPECT_EQ(publishedTable72(false, true).graph, 84.9);
  EXPECT_FALSE(publishedTable72(true, 20.0).pinhole);
  EXPECT_FALSE(publishedTable71(false, 4).pinhole);
  EXPECT_EQ(publishedPaths(0).graph, 69.8);
  EXPECT_EQ(publishedSurvey("easier_count"), 4.98);
  EXPECT_FALSE(publishedSurvey("mood"));
}

}  // namespace
}  // namespace ocelli::test
