// That R, where it is installed, finds what the report says, from the tables and the script that come with it.
#include "analysis/report/r_script.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/base/estimate.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {
namespace {

constexpr int kSubjects = 24;

/// A subject's trials of all tasks in two sessions, drawn with effects of subject, case, view and session.
class DrawnStudy {
 public:
  DrawnStudy() {
    data_.sources.push_back({});
    data_.sources.back().path = "drawn";
    data_.sources.back().protocolText = R"({"name": "drawn", "survey": {"fields": [{"name": "easier, \"find\"",
      "question": "To find", "options": ["1", "2", "3", "4", "5"], "favors": ["gc", "ppc"]}]}})";
    for (double& effect : caseEffects_) {
      effect = 0.4 * random_.normal();
    }
    for (int subject = 0; subject < kSubjects; ++subject) {
      addSubject(fmt::format("{:03}", subject + 1));
    }
  }
  const Dataset& data() const { return data_; }

 private:
  void addSubject(const std::string& id) {
    const double subject = 0.4 * random_.normal();
    const double slope = 0.1 * random_.normal();
    for (int session = 1; session <= 2; ++session) {
      for (int i = 0; i < 16; ++i) {
        const double view = (i + i / 8) % 2 == 0 ? -0.5 : 0.5;
        Trial find = trialOf(id, session, "find", i % 8, view);
        find.moving = i % 8 >= 5;
        const double seconds = std::exp(2.6 + subject + caseEffects_[i % 8] + (slope - 0.4) * view - 0.15 * session +
                                        0.6 * random_.normal());
        find.censored = seconds > 60;
        find.correct = seconds <= 60;
        find.responseSeconds = std::min(seconds, 60.0);
        find.longestSeconds = 60;
        data_.trials.push_back(find);

        Trial count = trialOf(id, session, "count", i, view);
        count.moving = i >= 10;
        count.exposureSeconds = i % 3 == 0 ? 5 : 20;
        count.duplicateColors = i % 4 >= 2;
        count.objects = 5;
        count.correct = rightWith(0.5 + subject + caseEffects_[i] + 1.2 * view);
        count.expected = "5";
        count.answer = *count.correct ? "5" : random_.uniform() < 0.5 + view ? "4" : "6";
        data_.trials.push_back(count);

        Trial path = trialOf(id, session, "path", i, view);
        path.correct = rightWith(0.6 + subject + caseEffects_[i]);
        data_.trials.push_back(path);
      }
    }
    FormAnswer answer;
    answer.answerId = static_cast<int64_t>(data_.answers.size()) + 1;
    answer.subject = id;
    answer.form = "survey";
    answer.field = "easier, \"find\"";
    answer.answer = std::to_string(2 + random_.below(4));
    data_.answers.push_back(answer);
  }

  Trial trialOf(const std::string& id, int session, const std::string& task, int caseIndex, double view) {
    Trial trial;
    trial.trialId = static_cast<int64_t>(data_.trials.size()) + 1;
    trial.subject = id;
    trial.session = session;
    trial.planIndex = static_cast<int>(data_.trials.size()) % 48;
    trial.task = task;
    trial.block = task;
    trial.caseIndex = caseIndex;
    trial.caseLabel = fmt::format("case {}", caseIndex);
    trial.view = view < 0 ? TrialView::kReference : TrialView::kOther;
    return trial;
  }
  bool rightWith(double logit) { return random_.uniform() < 1 / (1 + std::exp(-logit)); }

  RandomNumbers random_{11};
  std::array<double, 16> caseEffects_{};
  Dataset data_{};
};

/// Rows of a CSV without line breaks in its fields, whose quotes are doubled.
std::vector<std::vector<std::string>> csvRows(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> row{""};
    bool isQuoted = false;
    for (const char letter : line) {
      if (letter == '"') {
        isQuoted = !isQuoted;
      } else if (letter == ',' && !isQuoted) {
        row.emplace_back();
      } else {
        row.back() += letter;
      }
    }
    rows.push_back(row);
  }
  return rows;
}

class RScript : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("Rscript -e 'q(status = !all(sapply(c(\"lme4\", \"lmerTest\", \"survival\"), requireNamespace, "
                    "quietly = TRUE)))' > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "needs Rscript with lme4, lmerTest and survival";
    }
    std::string name = (std::filesystem::temp_directory_path() / "ocelli-r-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// By model and term: estimate, lower, upper, p.
  std::map<std::string, std::vector<double>> resultsOfR(const std::vector<ReportFile>& files) const {
    for (const ReportFile& file : files) {
      std::filesystem::create_directories((folder_ / file.name).parent_path());
      std::ofstream(folder_ / file.name) << file.bytes;
    }
    const std::string log = (folder_ / "log").string();
    const int status =
        std::system(fmt::format("Rscript '{}' > '{}' 2>&1", (folder_ / "analysis.R").string(), log).c_str());
    std::stringstream said;
    said << std::ifstream(log).rdbuf();
    EXPECT_EQ(status, 0) << said.str();
    std::map<std::string, std::vector<double>> results;
    for (const std::vector<std::string>& row : csvRows(folder_ / "tables" / "r_results.csv")) {
      std::vector<double>& numbers = results[fmt::format("{}/{}", row[0], row[1])];
      for (size_t i = 2; i < row.size(); ++i) {
        numbers.push_back(row[i] == "NA" ? kNotKnown : std::strtod(row[i].c_str(), nullptr));
      }
    }
    return results;
  }

  std::filesystem::path folder_{};
};

TEST_F(RScript, findsWhatTheReportSays) {
  AnalysisPlan plan = defaultPlan();
  plan.bootstrapSamples = 100;
  // What R has a model for: times as they are, without censored ones.
  PlannedModel linear = *plan.findModel("find-time");
  linear.name = "find-linear";
  linear.kind = ModelKind::kLinearMixed;
  plan.models.push_back(linear);
  const AnalysisData analysis = applyPlan(DrawnStudy().data(), plan);
  const ReportDocument report = studyReport(analysis, {}, {{}, "test"});
  const auto results = resultsOfR(tableFiles(analysis, report, {{}, "test"}, true));

  struct Same {
    const char* ours;
    const char* theirs;
    double tolerance;      ///< relative
    double intervals = 0;  ///< of lower, upper and p, where it is larger
  };
  // Of mixed models: where either search stops. Of the others: rounding, and what iterations leave.
  const double mixed = 1e-4;
  const double exact = 1e-6;
  // The report takes one step of the search without each subject and case, R the whole search. That of Cox regression
  // takes risk sets as they are with them, too.
  const double oneStep = 0.01;
  const double oneCoxStep = 0.06;
  const std::vector<Same> same{
      {"find-linear/view-gc-ppc", "find-linear/view", mixed},
      {"find-linear/session-each-more", "find-linear/session", mixed},
      {"find-linear/view-x-session", "find-linear/view:session", mixed},
      {"find-linear/view-x-moving", "find-linear/view:moving", mixed},
      {"find-survival/ppc-median-time", "find-survival/ppc median", exact},
      {"find-survival/gc-restricted-mean-to-60-s", "find-survival/gc restricted mean", exact},
      {"find-hazard/view-gc-ppc", "find-hazard/view", exact, oneCoxStep},
      {"find-hazard/session-each-more", "find-hazard/session", exact, oneCoxStep},
      {"find-log-normal/view-gc-ppc", "find-log-normal/view", exact, oneStep},
      {"find-log-normal/moving-yes-no", "find-log-normal/moving", exact, oneStep},
      {"count-right/view-gc-ppc", "count-right/view", mixed},
      {"count-right/exposure-each-second-more", "count-right/exposure", mixed},
      {"count-right/colours-shared-different", "count-right/duplicates", mixed},
      {"count-matched/gc-less-ppc-difference-of-shares-clustered", "count-matched/difference of shares, clustered",
       exact},
      {"count-matched/gc-less-ppc-difference-of-shares-mcnemar-s-exact-p", "count-matched/difference of shares", exact},
      {"count-matched/odds-ratio-gc-ppc-mcnemar", "count-matched/odds ratio", exact},
      {"count-error/mean-subjects-and-cases-as-clusters", "count-error/mean", exact},
      {"count-error/hodges-lehmann-center-wilcoxon", "count-error/center", exact},
      {"path-right/view-gc-ppc", "path-right/view", mixed},
      {"path-bayes/for-some-against-none", "path-bayes/for some, against none", exact},
      {"path-equivalence/difference-of-shares", "path-equivalence/difference of shares", exact},
      {"path-chance/both-views", "path-chance/both views", exact}};
  const std::array<const char*, 4> numbers{"estimate", "lower", "upper", "p"};
  for (const Same& each : same) {
    const auto theirs = results.find(each.theirs);
    ASSERT_NE(theirs, results.end()) << each.theirs;
    size_t compared = 0;
    for (size_t i = 0; i < numbers.size(); ++i) {
      const Cell* cell = findCell(report.origins.tables, fmt::format("{}/{}", each.ours, numbers[i]));
      if (cell == nullptr && i == 0) {
        cell = findCell(report.origins.tables, fmt::format("{}/value", each.ours));
      }
      const double value = theirs->second[i];
      if (cell != nullptr && cell->value && std::isfinite(value)) {
        // The number of digits of a p value is that of its logarithm's.
        const double scale = i == 3 ? std::max(1.0, -std::log(value)) * value * 10 : std::abs(value);
        const double tolerance = i == 0 ? each.tolerance : std::max(each.tolerance, each.intervals);
        EXPECT_NEAR(*cell->value, value, tolerance * scale) << each.ours << " " << numbers[i];
        ++compared;
      }
    }
    EXPECT_GT(compared, 0u) << each.ours;
  }
  EXPECT_EQ(results.count("survey/easier, find"), 1u);
  // The log-normal regression that stands in for the mixed model of censored times: near, and not the same.
  ASSERT_EQ(results.count("find-time/view"), 0u);
  ASSERT_EQ(results.count("find-time/view, survreg"), 1u);
  const Cell* view = findCell(report.origins.tables, "find-time/view-gc-ppc/estimate");
  ASSERT_NE(view, nullptr);
  EXPECT_NEAR(*view->value, results.at("find-time/view, survreg")[0], 0.05);
}

TEST(RScriptText, isMadeFromThePlanWithoutTasksThatAreLeftOut) {
  AnalysisData analysis;
  analysis.plan = defaultPlan();
  analysis.plan.models[0].terms = {"view", "session"};
  const std::string script = rScript(analysis, {"find"}, "test");
  EXPECT_THAT(script, testing::HasSubstr("times_model(\"find-time\", trials[trials$task == \"find\", ], \"censored\", "
                                         "c(\"view\", \"session\"), list(subject = c(\"view\"), case = c(\"view\")))"));
  EXPECT_THAT(script,
              testing::HasSubstr("family_of(\"primary\", TRUE, 3, c(\"find-faster\"), c(\"find-time\"), c(\"view\"))"));
  EXPECT_THAT(script, testing::Not(testing::HasSubstr("\"count-right\"")));
}

TEST(RScriptText, quotesNamesOfThePlan) {
  AnalysisData analysis;
  analysis.plan = defaultPlan();
  analysis.plan.name = "\"\nq()\n#";
  const std::string script = rScript(analysis, {}, "test");
  EXPECT_THAT(script, testing::Not(testing::HasSubstr("\nq()")));
}

}  // namespace
}  // namespace ocelli
