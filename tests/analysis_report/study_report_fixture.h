// Whole reports of studies that a test makes.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/report/json_report.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/paper_tables.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/report_reading.h"

namespace ocelli::test {

class StudyReportTest : public testing::Test {
 protected:
  /// The report of a study that `fill` fills.
  template <class Fill>
  nlohmann::json reportOf(const Fill& fill, AnalysisPlan plan = defaultPlan()) {
    plan.bootstrapSamples = 100;  // no test here looks at them
    const std::string path = folder_.file(fmt::format("study-{}.db", ++studies_));
    SampleStudy study(path, kWholeProtocol);
    fill(study);
    analysis_ = applyPlan(merge({readDatabase(path)}), plan);
    document_ = studyReport(analysis_, paperTables(analysis_), {{}, "1.2.3"});
    return nlohmann::json::parse(jsonReport(document_));
  }
  nlohmann::json reportOfMade(const MadeStudy& made, const AnalysisPlan& plan = defaultPlan()) {
    return reportOf([&](SampleStudy& study) { fillWholeStudy(study, made); }, plan);
  }
  /// Also of the page and the figures.
  void expectHonest(const nlohmann::json& report) const {
    EXPECT_THAT(dishonestNumbers(report), testing::IsEmpty());
    for (const ReportFile& file : reportFiles(document_)) {
      if (!file.name.ends_with(".pdf")) {
        EXPECT_THAT(numbersThatAreNone(file.bytes), testing::IsEmpty()) << file.name;
      }
    }
  }

  SampleFolder folder_;
  int studies_ = 0;
  AnalysisData analysis_;
  ReportDocument document_;
};

inline MadeStudy changed(std::function<void(SampleTrial&)> change) {
  MadeStudy made;
  made.change = [change = std::move(change)](SampleTrial& trial) {
    change(trial);
    return true;
  };
  return made;
}

inline MadeStudy only(std::function<bool(const SampleTrial&)> keep) {
  MadeStudy made;
  made.change = [keep = std::move(keep)](SampleTrial& trial) { return keep(trial); };
  return made;
}

}  // namespace ocelli::test
