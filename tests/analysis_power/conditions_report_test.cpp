// The whole report of a study of several conditions, with a plan of contrasts and without; and power of a contrast.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "analysis/dataset/exclusions.h"
#include "analysis/inference/holm.h"
#include "analysis/power/contrast_effects.h"
#include "analysis/power/power_simulation.h"
#include "analysis/power/simulated_dataset.h"
#include "analysis/report/contrast_weights.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/explain.h"
#include "analysis/tables/paper_tables.h"
#include "oc_core/base/error.h"
#include "tests/analysis_power/crossed_study.h"
#include "tests/analysis_power/small_protocol.h"
#include "tests/base/temporary_folder.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const ReportTable* tableIn(const ReportDocument& document, const std::string& id) {
  for (const ReportElement& element : document.elements) {
    if (const auto* table = std::get_if<ReportTable>(&element); table != nullptr && table->id == id) {
      return table;
    }
  }
  return nullptr;
}

std::string textOf(const ReportDocument& document) {
  std::string text;
  for (const ReportElement& element : document.elements) {
    if (const auto* paragraph = std::get_if<ReportParagraph>(&element)) {
      text += paragraph->text + "\n";
    } else if (const auto* note = std::get_if<ReportNote>(&element)) {
      text += note->text + "\n";
    } else if (const auto* heading = std::get_if<ReportHeading>(&element)) {
      text += "# " + heading->text + "\n";
    } else if (const auto* table = std::get_if<ReportTable>(&element)) {
      text += table->caption + "\n";
      for (const auto& row : table->rows) {
        for (const ReportCell& cell : row) {
          text += cell.text + cell.source + " | ";
        }
        text += "\n";
      }
    }
  }
  return text;
}

class ConditionsReport : public testing::Test {
 protected:
  ReportDocument reportOf(const AnalysisPlan& plan) {
    analysis_ = applyPlan(crossedStudy(protocol_, 12, 5), plan);
    return studyReport(analysis_, paperTables(analysis_), {{}, "test"});
  }

  Protocol protocol_ = crossedProtocol();
  AnalysisData analysis_{};
};

TEST_F(ConditionsReport, HasTheContrastsOfThePlanByFamily) {
  const ReportDocument document = reportOf(crossedPlan());
  EXPECT_THAT(document.failures, IsEmpty());
  const ReportTable* family = tableIn(document, "family-find");
  ASSERT_NE(family, nullptr);
  ASSERT_EQ(family->rows.size(), 5u);
  EXPECT_FALSE(family->exploratory);
  std::vector<double> pValues;
  for (const auto& row : family->rows) {
    ASSERT_TRUE(row[4].value && row[5].value) << row[0].text;
    pValues.push_back(*row[4].value);
  }
  const std::vector<double> adjusted = holmAdjusted(pValues);
  for (size_t i = 0; i < adjusted.size(); ++i) {
    EXPECT_DOUBLE_EQ(*family->rows[i][5].value, adjusted[i]);
  }
  EXPECT_EQ(family->rows[2][1].text, "ratio of times, camera (bent / flat)");
  EXPECT_EQ(family->rows[4][1].text, "ratio of ratios of times, camera (bent / flat) x height (high / low)");
  const ReportTable* paths = tableIn(document, "family-path-right");
  ASSERT_NE(paths, nullptr) << "of the model, as these contrasts name no family";
  EXPECT_EQ(paths->rows[0][0].text, "Paths are recognised better with bent rays, low");
  const ReportTable* contrasts = tableIn(document, "find-time-contrasts");
  ASSERT_NE(contrasts, nullptr);
  EXPECT_FALSE(contrasts->exploratory);
  EXPECT_EQ(contrasts->rows.size(), 5u);
  EXPECT_NE(tableIn(document, "conditions-find-times"), nullptr);
  EXPECT_EQ(tableIn(document, "conditions-find-times")->rows.size(), 4u);
  EXPECT_NE(tableIn(document, "find-time-conditions"), nullptr);
  EXPECT_NE(tableIn(document, "survey-preference"), nullptr);
  const std::string text = textOf(document);
  EXPECT_THAT(text, Not(HasSubstr("@")));
  EXPECT_THAT(text, HasSubstr("Left out, as they compare two views: the tables of Rosen 2010"));
  EXPECT_THAT(text, HasSubstr("(1 | subject) + (1 | subject:view) + (1 | case) + (1 | case:view); as fitted"));
  const Cell* cell = findCell(document.origins.tables, family->rows[0][4].id);
  ASSERT_NE(cell, nullptr);
  ASSERT_EQ(cell->cells.size(), 1u);
  EXPECT_NE(findCell(document.origins.tables, cell->cells[0]), nullptr) << cell->cells[0];
  EXPECT_THAT(explainCell(document.origins.tables, analysis_.data, cell->cells[0]), HasSubstr("contrast of model"));
  for (const ReportFile& file : tableFiles(analysis_, document, {}, true)) {
    EXPECT_NE(file.name, "analysis.R");
    if (file.name == "tables/trials.csv") {
      // Of paths, whose cases have no size, an empty one.
      for (const char* part : {"simulated,camera,height,size\r\n", ",1,bent,low,large\r\n", ",1,bent,low,\r\n"}) {
        EXPECT_NE(file.bytes.find(part), std::string::npos) << part;
      }
    }
  }
}

TEST_F(ConditionsReport, ComparesWithTheFirstWhereThereIsNoPlan) {
  const ReportDocument document = reportOf(defaultPlan(protocol_.conditions.names, {"find", "path"}));
  EXPECT_THAT(document.failures, IsEmpty());
  const ReportTable* family = tableIn(document, "family-find-time");
  ASSERT_NE(family, nullptr);
  EXPECT_TRUE(family->exploratory);
  ASSERT_EQ(family->rows.size(), 3u);
  EXPECT_EQ(family->rows[0][1].text, "ratio of times, flat-high / flat-low");
  EXPECT_THAT(textOf(document), HasSubstr("the term session is left out: session is the same in all trials"));
}

TEST_F(ConditionsReport, ComparesNothingOfOneCondition) {
  Dataset data = crossedStudy(protocol_, 12, 5);
  data.conditions.list.resize(1);
  data.sources[0].protocolText.clear();  // which has four
  std::erase_if(data.trials, [](const Trial& trial) { return trial.view != TrialView::kReference; });
  analysis_ = applyPlan(std::move(data), defaultPlan(ViewConditions{{{"flat-low", "flat-low"}}}, {"find", "path"}));
  const ReportDocument document = studyReport(analysis_, paperTables(analysis_), {{}, "test"});
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_EQ(tableIn(document, "find-time-contrasts"), nullptr);
  ASSERT_NE(tableIn(document, "find-time-conditions"), nullptr);
  EXPECT_EQ(tableIn(document, "find-time-conditions")->rows.size(), 1u);
}

TEST(ContrastsOfTwoConditions, AreTheEffectOfTheViewInAnotherParametrisation) {
  const Protocol protocol = smallProtocol();
  const AnalysisPlan plan = planFromJsonText(
      R"({"name": "pair", "models": [{"name": "find-time", "task": "find", "kind": "log_normal_mixed", "terms": ["view"],
          "random": [{"group": "subject", "slopes": ["view"]}, {"group": "case"}]}],
          "contrasts": [{"name": "gc", "model": "find-time", "conditions": ["gc", "ppc"]}]})",
      "plan.json", {"find", "count", "path", "survey"});
  SimulationPlan simulation;
  simulation.kind = SubjectKind::kGenerator;
  simulation.seed = 4;
  simulation.sessions.assign(16, 1);
  simulation.effects.at("find", kSubjectGraphSd) = 0.5;
  simulation.effects.at("find", kSubjectSd) = 0.6;
  const AnalysisData analysis = applyPlan(simulatedDatasetWithoutAnswers(protocol, simulation), plan);
  const ReportDocument document = studyReport(analysis, paperTables(analysis), {{"find"}, "test"});
  EXPECT_THAT(document.failures, IsEmpty());
  const ReportTable* contrasts = tableIn(document, "find-time-contrasts");
  const ReportTable* model = tableIn(document, "find-time");
  ASSERT_TRUE(contrasts != nullptr && model != nullptr) << "the old sections stand beside it";
  EXPECT_NE(tableIn(document, "family-find-time"), nullptr);
  const ReportCell& interval = contrasts->rows[0][2];
  const ReportCell& other = model->rows[0][2];
  ASSERT_TRUE(interval.interval && other.interval);
  EXPECT_NEAR(*contrasts->rows[0][1].value, *model->rows[0][1].value, 1e-3);
  // The same likelihood, whose search ends where it is flat.
  EXPECT_NEAR(interval.interval->first, other.interval->first, 2e-3);
  EXPECT_NEAR(interval.interval->second, other.interval->second, 2e-3);
}

TEST_F(ConditionsReport, PowerIsThatOfAContrast) {
  const TemporaryFolder folder;
  const auto effects = folder.write("effects.json", R"({"find": {"conditions":
      {"flat-high": 0.1, "bent-low": -0.3, "bent-high": 0.05}, "subject_graph_sd": 0.1}})");
  const AnalysisPlan plan = crossedPlan();
  const PlannedModel& model = *plan.findModel("find-time");
  SupposedEffects supposed{"find", effects.string()};
  supposed.residualSd = 0.3;
  for (const PlannedContrast& contrast : contrastsOf(plan, model, protocol_.conditions.names)) {
    const Truth truth = contrastTruth(protocol_, supposed, model, contrast);
    EXPECT_NEAR(std::log(truth.effect), crossedTruths().at(contrast.name), 1e-12) << contrast.name;
  }
  const PlannedContrast& pair = plan.contrasts[0];
  const Truth wanted = contrastTruth(protocol_, supposed, model, pair);
  const Truth none = contrastTruthWithoutEffect(protocol_, "find", wanted);
  EXPECT_EQ(none.effects.ofCondition("find", "bent-low"), 0.0);
  PowerWork work{protocol_, plan, model};
  work.subjects = {12};
  work.simulations = 10;
  work.contrast = &pair;
  const std::vector<PowerCurve> curves = simulatePower(work, {wanted, none});
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].question, PowerCurve::Question::kPower);
  EXPECT_EQ(curves[1].question, PowerCurve::Question::kFalseAlarm);
  // An effect of 0.3 with a standard error of about 0.05: found by nearly all; of 10 studies without, 5 or more of 5 %
  // are found in 6 of 100,000.
  EXPECT_GE(curves[0].sizes[0].found.successes, 8);
  EXPECT_LE(curves[1].sizes[0].found.successes, 4);
  EXPECT_NEAR(std::log(curves[0].sizes[0].estimate), -0.3, 0.08) << "five standard errors of the mean";
  EXPECT_EQ(nameOf(curves[0]), "bent-low / flat-low of 0.741, test of find-pair");
  EXPECT_THAT(describeContrastTruth(protocol_, wanted, "find"), Contains(HasSubstr("bent-low: trials take")));
}

TEST_F(ConditionsReport, PowerNeedsEffectsOfConditions) {
  const AnalysisPlan plan = crossedPlan();
  const PlannedModel& model = *plan.findModel("find-time");
  const auto errorOf = [&](const SupposedEffects& supposed) {
    try {
      contrastTruth(protocol_, supposed, model, plan.contrasts[0]);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  SupposedEffects supposed{"find", ""};
  EXPECT_THAT(errorOf(supposed), HasSubstr("which effects of conditions"));
  supposed.ratio = 0.8;
  EXPECT_THAT(errorOf(supposed), HasSubstr("--ratio: this option is for studies of two conditions"));
  const TemporaryFolder folder;
  const SupposedEffects wrong{"find", folder.write("e.json", R"({"find": {"conditions": {"gone": 1}}})").string()};
  EXPECT_THAT(errorOf(wrong), HasSubstr("the protocol has no condition \"gone\""));
}

}  // namespace
}  // namespace ocelli::test
