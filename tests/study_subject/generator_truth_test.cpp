#include "study/subject/generator_truth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "oc_core/base/error.h"
#include "tests/study_session/session_harness.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

ProtocolBlock blockOf(const std::string& task, const std::string& json) {
  ProtocolBlock block;
  block.name = task;
  block.title = task;
  block.taskName = task;
  block.task = test::readBlock(task, json);
  return block;
}

/// Both tasks, with cases that effects tell apart, in two sessions.
Protocol protocolOfFindAndCount() {
  Protocol protocol;
  protocol.name = "truth";
  protocol.sessions = 2;
  protocol.blocks.push_back(blockOf("find", R"({"maze": "small", "limit_seconds": 60, "cases": [
      {"row": 0, "column": 0}, {"row": 0, "column": 5}, {"row": 3, "column": 3}, {"row": 4, "column": 0}]})"));
  protocol.blocks.push_back(blockOf("count", R"({"maze": "small",
      "pinholes": {"rows": 1, "columns": 1, "views": [{"row": 2, "column": 0, "heading": "east"}]}, "cases": [
      {"objects": 4, "exposure_seconds": 5}, {"objects": 5, "exposure_seconds": 10},
      {"objects": 6, "exposure_seconds": 20, "duplicate_colors": true}, {"objects": 7, "exposure_seconds": 10}]})"));
  return protocol;
}

TEST(GeneratorTruth, SharesAreThoseOfManySubjectsAndCases) {
  const Protocol protocol = protocolOfFindAndCount();
  GeneratorEffects effects;
  effects.at("count", "right") = -0.5;
  effects.at("count", "subject_sd") = 1.2;
  effects.at("count", "item_sd") = 0.8;
  effects.at("count", "item_view_sd") = 4;
  std::array<double, 2> right{};
  std::array<double, 2> trials{};
  constexpr uint64_t kStudies = 3000;  // cases are new in each
  for (uint64_t study = 0; study < kStudies; ++study) {
    for (int session = 1; session <= 2; ++session) {
      const SessionSchedule schedule = scheduleOf(protocol, static_cast<int>(study % 8), session, study);
      test::FakeSink sink;
      generateSession(protocol, {schedule, effects, study, study + 7}, sink);
      for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
        if (end.record.plan.task == "count") {
          const auto view = static_cast<size_t>(end.record.plan.view);
          right[view] += end.record.outcome.correct ? 1 : 0;
          trials[view] += 1;
        }
      }
    }
  }
  for (const TrialView view : kViews) {
    const auto v = static_cast<size_t>(view);
    // Trials of a subject are alike: its mean of 8 varies by 0.3, so that of all by 0.3 / sqrt(3000) = 0.0055.
    // With cases that gain alike it would be 0.04 off in the graph camera.
    EXPECT_NEAR(shareRight(protocol, effects, "count", view), right[v] / trials[v], 4 * 0.0055) << v;
  }
}

TEST(GeneratorTruth, SharesWithoutSpreadAreThoseOfTheLogit) {
  Protocol protocol = protocolOfFindAndCount();
  protocol.sessions = 1;
  GeneratorEffects effects;
  effects.at("count", "right") = 1;
  effects.at("count", "graph") = 0.5;
  effects.at("count", "duplicates") = 0;
  effects.at("count", "doubled_exposure") = 0;
  effects.at("count", "subject_sd") = 0;
  effects.at("count", "item_sd") = 0;
  EXPECT_NEAR(shareRight(protocol, effects, "count", TrialView::kReference), 1 / (1 + std::exp(-1.0)), 1e-12);
  EXPECT_NEAR(shareRight(protocol, effects, "count", TrialView::kOther), 1 / (1 + std::exp(-1.5)), 1e-12);
}

TEST(GeneratorTruth, TimesAreGeometricMeansOverCasesAndSessions) {
  const Protocol protocol = protocolOfFindAndCount();
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 2;
  effects.at("find", "graph") = -0.4;
  effects.at("find", "session") = -0.2;
  EXPECT_NEAR(geometricMeanSeconds(protocol, effects, "find", TrialView::kReference), std::exp(2 - 0.1), 1e-12);
  EXPECT_NEAR(geometricMeanSeconds(protocol, effects, "find", TrialView::kOther), std::exp(2 - 0.1 - 0.4), 1e-12);
}

TEST(GeneratorTruth, AProtocolWithoutTheTaskIsRejected) {
  EXPECT_THROW(shareRight(protocolOfFindAndCount(), {}, "path", TrialView::kOther), InputError);
}

}  // namespace
}  // namespace ocelli
