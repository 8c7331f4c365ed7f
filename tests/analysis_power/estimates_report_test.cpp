// The whole report of estimates of both units, of two and of three conditions; and power of estimates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <map>

#include "analysis/dataset/exclusions.h"
#include "analysis/power/power_simulation.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/report/view_test.h"
#include "analysis/tables/explain.h"
#include "analysis/tables/paper_tables.h"
#include "oc_core/base/error.h"
#include "study/subject/generator_truth.h"
#include "study/tasks/task_registry.h"
#include "tests/analysis_power/sham_tasks.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const ReportTable* tableNamed(const ReportDocument& document, const std::string& id) {
  for (const ReportElement& element : document.elements) {
    if (const auto* table = std::get_if<ReportTable>(&element); table != nullptr && table->id == id) {
      return table;
    }
  }
  return nullptr;
}

bool hasFigure(const ReportDocument& document, const std::string& id) {
  return std::any_of(document.elements.begin(), document.elements.end(), [&](const ReportElement& element) {
    const auto* figure = std::get_if<ReportFigure>(&element);
    return figure != nullptr && figure->id == id;
  });
}

std::vector<std::string> notesIn(const ReportDocument& document) {
  std::vector<std::string> notes;
  for (const ReportElement& element : document.elements) {
    if (const auto* note = std::get_if<ReportNote>(&element)) {
      notes.push_back(note->text);
    }
  }
  return notes;
}

/// The number in a row of a table, by the start of the row's label and the title of the column.
double numberIn(const ReportDocument& document, const std::string& id, const std::string& row,
                const std::string& column) {
  const ReportTable* table = tableNamed(document, id);
  if (table == nullptr) {
    ADD_FAILURE() << "no table " << id;
    return kNotKnown;
  }
  for (const auto& cells : table->rows) {
    for (size_t i = 0; i < table->columns.size(); ++i) {
      // A label that starts a sentence has a capital letter.
      std::string label = cells[0].text;
      label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
      if (label.starts_with(row) && table->columns[i].title == column && cells[i].value) {
        return *cells[i].value;
      }
    }
  }
  ADD_FAILURE() << "no " << column << " of " << row << " in " << id;
  return kNotKnown;
}

class EstimatesReport : public testing::Test {
 protected:
  EstimatesReport() {
    registerShamTasks();
    effects_.at("reach", "error") = -0.25;
    effects_.at("reach", "graph") = -0.15;
    effects_.at("bearing", "graph") = 12;
  }
  ReportDocument reportOf(const Protocol& protocol, const AnalysisPlan& plan) {
    Dataset data = shamStudy(protocol, effects_, 16, 5);
    // Two answers that did not come in time, and an exact one.
    for (size_t i = 0; i < 2; ++i) {
      data.trials[i].measures.clear();
      data.trials[i].censored = true;
      data.trials[i].correct = false;
    }
    for (Trial& trial : data.trials) {
      if (trial.task == "reach" && trial.subject == data.subjects.back().id) {
        trial.measures["estimate_m"] = trial.measures.at("truth_m");
        break;
      }
    }
    analysis_ = applyPlan(std::move(data), plan);
    return studyReport(analysis_, paperTables(analysis_), {{}, "test"});
  }

  GeneratorEffects effects_;
  AnalysisData analysis_{};
};

AnalysisPlan quickPlan() {
  AnalysisPlan plan;
  plan.bootstrapSamples = 100;
  return plan;
}

TEST_F(EstimatesReport, OfTwoConditionsHasBothUnits) {
  const ReportDocument document = reportOf(shamProtocol(), quickPlan());
  EXPECT_THAT(document.failures, IsEmpty());
  // By the generator exp(-0.25) and exp(-0.4), of 16 subjects with a spread of 0.2 and 16 cases with 0.1: five errors.
  EXPECT_NEAR(std::log(numberIn(document, "estimates-reach-bias", "flat", "Estimate")), -0.25, 0.32);
  EXPECT_NEAR(numberIn(document, "task-reach-signed-error", "view (bent against flat)", "Estimate"), std::exp(-0.15),
              0.25);
  EXPECT_GT(numberIn(document, "task-reach-absolute-error", "view (bent / flat)", "Estimate"), 0);
  EXPECT_NEAR(numberIn(document, "estimates-reach-exponents", "bent", "Estimate"), 1, 0.3);
  EXPECT_NEAR(numberIn(document, "task-bearing-signed-error", "view (bent against flat)", "Estimate"), 12, 15);
  EXPECT_NEAR(numberIn(document, "estimates-bearing-vectors", "flat, mean direction", "Estimate"), 0, 20);
  EXPECT_LT(numberIn(document, "estimates-bearing-uniformity", "flat, V test", "p"), 0.001);
  EXPECT_NEAR(numberIn(document, "estimates-bearing-turned", "bent less flat", "Estimate"), 12, 15);
  EXPECT_LE(numberIn(document, "estimates-bearing-hotelling", "bent less flat", "p"), 1);
  EXPECT_LT(numberIn(document, "estimates-bearing-mirrored", "flat, off by more", "Estimate"), 0.1);
  EXPECT_EQ(numberIn(document, "estimates-reach-counts", "flat", "Time-outs") +
                numberIn(document, "estimates-reach-counts", "bent", "Time-outs") +
                numberIn(document, "estimates-bearing-counts", "flat", "Time-outs") +
                numberIn(document, "estimates-bearing-counts", "bent", "Time-outs"),
            2);
  for (const char* figure : {"figure-estimates-reach-scatter", "figure-estimates-bearing-roses",
                             "figure-estimates-reach-bias", "figure-task-reach-signed-error-sensitivity"}) {
    EXPECT_TRUE(hasFigure(document, figure)) << figure;
  }
  EXPECT_THAT(notesIn(document), testing::Contains(HasSubstr("estimates are exact")));
  EXPECT_EQ(tableNamed(document, "task-reach-right"), nullptr) << "right within a tolerance is no default model";
  const ReportTable* bias = tableNamed(document, "estimates-reach-bias");
  EXPECT_THAT(explainCell(document.origins.tables, analysis_.data, bias->rows[0][1].id),
              AllOf(HasSubstr("expected  measures\n"), HasSubstr("estimate_m "), HasSubstr(", truth_m ")));
}

TEST_F(EstimatesReport, OfThreeConditionsComparesWithTheFirst) {
  effects_.setCondition("reach", "bent", -0.15);
  effects_.setCondition("reach", "high", 0);
  const ReportDocument document = reportOf(shamProtocol(3), quickPlan());
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_EQ(tableNamed(document, "family-task-reach-signed-error")->rows.size(), 2u);
  EXPECT_EQ(tableNamed(document, "family-task-reach-signed-error")->rows[0][1].text, "ratio of estimates, bent / flat");
  EXPECT_EQ(tableNamed(document, "family-task-bearing-signed-error")->rows[0][1].text,
            "difference of signed errors, bent / flat");
  EXPECT_NEAR(numberIn(document, "task-bearing-signed-error-conditions", "flat", "Estimate"), 0, 20);
  EXPECT_EQ(tableNamed(document, "estimates-reach-exponents")->rows.size(), 3u);
  EXPECT_EQ(tableNamed(document, "estimates-bearing-turned-holm")->rows.size(), 2u);
}

TEST_F(EstimatesReport, OfOneConditionComparesNothing) {
  const ReportDocument document = reportOf(shamProtocol(1), quickPlan());
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_EQ(tableNamed(document, "estimates-reach-exponents")->rows.size(), 1u);
  EXPECT_EQ(tableNamed(document, "estimates-bearing-turned"), nullptr);
}

/// One subject, few trials, estimates that are all exact, directions that go everywhere: reasons, and no failures.
TEST_F(EstimatesReport, OfNextToNothingSaysWhatIsMissing) {
  for (const int conditions : {1, 2, 3}) {
    const Protocol protocol = shamProtocol(conditions);
    for (const int subjects : {1, 2, 3}) {
      for (const size_t trials : {size_t{1}, size_t{4}, size_t{1000}}) {
        Dataset data = shamStudy(protocol, effects_, subjects, 9);
        for (Trial& trial : data.trials) {
          if (trial.task == "reach" && trials < 1000) {
            trial.measures["estimate_m"] = trial.measures.at("truth_m");
          } else if (trial.task == "bearing") {
            trial.measures["estimate_degrees"] = 120.0 * (trial.caseIndex % 3);
            trial.measures["truth_degrees"] = 0;
          }
        }
        std::map<std::string, size_t> kept;
        std::erase_if(data.trials, [&](const Trial& trial) { return ++kept[trial.subject + trial.task] > trials; });
        analysis_ = applyPlan(std::move(data), quickPlan());
        const ReportDocument document = studyReport(analysis_, paperTables(analysis_), {{}, "test"});
        EXPECT_THAT(document.failures, IsEmpty()) << conditions << " " << subjects << " " << trials;
        EXPECT_NE(tableNamed(document, "estimates-reach-counts"), nullptr);
      }
    }
  }
}

TEST_F(EstimatesReport, TablesForOthersHaveErrors) {
  const ReportDocument document = reportOf(shamProtocol(), quickPlan());
  std::string trials;
  std::string script;
  for (const ReportFile& file : tableFiles(analysis_, document, {}, true)) {
    trials = file.name == "tables/trials.csv" ? file.bytes : trials;
    script = file.name == "analysis.R" ? file.bytes : script;
  }
  EXPECT_THAT(trials, HasSubstr("simulated,unit,estimate,truth,signed_error\r\n"));
  EXPECT_THAT(trials, HasSubstr(",1,,,,\r\n")) << "one that did not come in time";
  EXPECT_THAT(trials, HasSubstr(",1,degrees,"));
  EXPECT_THAT(script, HasSubstr(R"(error_model("task-bearing-signed-error", trials[trials$task == "bearing", ], )"
                                R"("degrees", FALSE, c("view"))"))
      << "there is one session";
}

TEST_F(EstimatesReport, ThresholdsAreThoseOfStaircases) {
  Dataset data = shamStudy(shamProtocol(), effects_, 12, 5);
  for (Trial& trial : data.trials) {
    // Levels 1 to 16: right from 6 on, in the second view from 9 on, and by guessing below.
    const double level = trial.caseIndex + 1;
    trial.measures = {{"level", level}, {"guess_rate", 0.5}};
    trial.correct = level >= (trial.view == TrialView::kOther ? 9 : 6) || trial.caseIndex % 2 == 0;
  }
  analysis_ = applyPlan(std::move(data), quickPlan());
  const ReportDocument document = studyReport(analysis_, paperTables(analysis_), {{}, "test"});
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_EQ(numberIn(document, "thresholds-reach-counts", "flat", "Thresholds"), 12);
  // Between the last wrong and the first right level above.
  const double flat = numberIn(document, "thresholds-reach-means", "flat", "Estimate");
  const double bent = numberIn(document, "thresholds-reach-means", "bent", "Estimate");
  EXPECT_GT(flat, 2);
  EXPECT_LT(flat, 6);
  EXPECT_GT(bent, flat);
  EXPECT_LT(bent, 9);
  EXPECT_TRUE(hasFigure(document, "figure-thresholds-reach-curves"));
  EXPECT_TRUE(hasFigure(document, "figure-thresholds-reach"));
  EXPECT_EQ(tableNamed(document, "task-reach-right"), nullptr) << "staircases hold shares where they want them";
}

TEST_F(EstimatesReport, ThresholdsThatCannotBeSaySo) {
  Dataset data = shamStudy(shamProtocol(), effects_, 4, 5);
  for (Trial& trial : data.trials) {
    trial.measures = {{"level", 1.0 + trial.caseIndex}};
    trial.correct = true;
  }
  analysis_ = applyPlan(std::move(data), quickPlan());
  const ReportDocument document = studyReport(analysis_, paperTables(analysis_), {{}, "test"});
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_EQ(numberIn(document, "thresholds-reach-counts", "flat", "Without"), 4);
  EXPECT_THAT(notesIn(document), testing::Contains(HasSubstr("all answers are right")));
}

TEST(DataGeneratorOfEstimates, DrawsErrorsAroundTheTruth) {
  const Protocol protocol = shamProtocol();
  GeneratorEffects effects;
  effects.at("reach", "error") = 0.3;
  effects.at("reach", "graph") = -0.2;
  effects.at("bearing", "error") = -170;  // around the back, where errors wrap
  for (const char* deviation : {"subject_sd", "subject_graph_sd", "item_sd", "item_view_sd", "residual_sd"}) {
    effects.at("reach", deviation) = 0;
    effects.at("bearing", deviation) = 0;
  }
  const Dataset data = shamStudy(protocol, effects, 2, 3);
  ASSERT_EQ(data.trials.size(), 2u * 2 * 2 * 16);
  for (const Trial& trial : data.trials) {
    const std::optional<EstimatedValue> value = estimatedValue(trial.measures);
    ASSERT_TRUE(value);
    const bool isReach = trial.task == "reach";
    const double error = isReach ? (trial.view == TrialView::kOther ? 0.1 : 0.3) : -170;
    EXPECT_NEAR(value->signedError(), error, 1e-9);
    // Right within a factor of 1.2, or 15 degrees.
    EXPECT_EQ(trial.correct, isReach && trial.view == TrialView::kOther);
    EXPECT_EQ(trial.censored, false);
    EXPECT_TRUE(trial.answer.empty()) << "answers are not told here";
  }
  EXPECT_NEAR(meanError(protocol, effects, "reach", TrialView::kOther), 0.1, 1e-12);
}

SupposedEffects supposedOf(const std::string& task) {
  SupposedEffects supposed;
  supposed.task = task;
  return supposed;
}

TEST(PowerOfEstimates, IsOfSignedErrors) {
  const Protocol protocol = shamProtocol();
  SupposedEffects supposed = supposedOf("bearing");
  supposed.difference = 12;
  supposed.subjectSd = 8;
  supposed.caseViewSd = 0;
  const Truth truth = wantedTruth(protocol, supposed);
  EXPECT_TRUE(truth.isDifference);
  EXPECT_EQ(truth.effect, 12);
  EXPECT_EQ(truth.label, "bent turns estimates by 12 degrees");
  AnalysisPlan plan;
  plan.models = reportTask("bearing", {true, false}).models;
  const PlannedModel* model = viewModelOf(plan, "bearing", ModelKind::kSignedErrorMixed);
  ASSERT_NE(model, nullptr);
  PowerWork work{protocol, plan, *model};
  work.subjects = {12};
  work.simulations = 10;
  const std::vector<PowerCurve> curves = simulatePower(work, {truth, truthWithoutEffect(protocol, "bearing", truth)});
  ASSERT_EQ(curves.size(), 2u);
  // The standard error is about 2 degrees: nearly all find 12; of 10 studies without, 5 or more are found in 6 of
  // 100,000.
  EXPECT_GE(curves[0].sizes[0].found.successes, 8);
  EXPECT_LE(curves[1].sizes[0].found.successes, 4);
  EXPECT_EQ(curves[0].trueValue, 12);
  EXPECT_NEAR(curves[0].sizes[0].estimate, 12, 5) << "more than five standard errors of the mean of ten";
}

TEST(PowerOfEstimates, OfLengthsIsARatio) {
  const Protocol protocol = shamProtocol();
  SupposedEffects supposed = supposedOf("reach");
  supposed.ratio = 0.8;
  const Truth truth = wantedTruth(protocol, supposed);
  EXPECT_FALSE(truth.isDifference);
  EXPECT_NEAR(truth.effect, 0.8, 1e-12);
  EXPECT_NEAR(truth.other - truth.reference, std::log(0.8), 1e-12);
  EXPECT_EQ(truth.label, "estimates with bent are 0.8 of those with flat");
}

TEST(PowerOfEstimates, SaysWhichOptionsItTakes) {
  const Protocol protocol = shamProtocol();
  const auto problemOf = [&](const SupposedEffects& supposed) {
    try {
      wantedTruth(protocol, supposed);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  SupposedEffects supposed = supposedOf("bearing");
  EXPECT_THAT(problemOf(supposed), HasSubstr("--difference"));
  supposed.ratio = 0.8;
  EXPECT_THAT(problemOf(supposed), HasSubstr("not for --task bearing"));
  supposed = supposedOf("reach");
  supposed.ratio = 0.8;
  supposed.subjectSd = 8;
  EXPECT_THAT(problemOf(supposed), HasSubstr("too large in log(estimate / truth)"));
}

}  // namespace
}  // namespace ocelli::test
