// The protocols that come with the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "study/outline/question_kinds.h"
#include "study/outline/questionnaire.h"
#include "study/protocol/balance.h"
#include "study/protocol/check_report.h"
#include "study/protocol/protocol_warnings.h"
#include "study/protocol/session_length.h"

namespace ocelli::test {
namespace {

using testing::Each;
using testing::HasSubstr;

Protocol protocolOf(const std::string& name) {
  return readProtocol(std::filesystem::path(OCELLI_SOURCE_DIR "/protocols") / (name + ".json"));
}

std::multiset<std::string> trialsOf(const Protocol& protocol, const std::string& block, int slot) {
  std::multiset<std::string> trials;
  for (const TrialPlan& trial : scheduleOf(protocol, slot, 1, protocol.seed).trials) {
    const ProtocolBlock& of = protocol.blocks[static_cast<size_t>(trial.block)];
    if (of.name == block) {
      trials.insert(of.task->caseInfo(trial.caseIndex).label + " " + protocol.nameOf(trial.view));
    }
  }
  return trials;
}

TEST(Rosen2010, HasTheTrialsThatTheTextTells) {
  const Protocol protocol = protocolOf("rosen2010");
  EXPECT_EQ(protocol.sessions, 3);
  // Sections 7.4.2 to 7.4.4.
  EXPECT_EQ(trialsOf(protocol, "find stationary", 0).size(), 24u);
  EXPECT_EQ(trialsOf(protocol, "find moving", 0).size(), 16u);
  EXPECT_EQ(trialsOf(protocol, "count stationary", 0).size(), 20u);
  EXPECT_EQ(trialsOf(protocol, "count moving", 0).size(), 20u);
  EXPECT_EQ(trialsOf(protocol, "path", 0).size(), 10u);
  for (int slot = 1; slot < 4; ++slot) {
    EXPECT_EQ(scheduleOf(protocol, slot, 1, 1).trials, scheduleOf(protocol, 0, 1, 1).trials);
  }
  for (const char* find : {"find stationary", "find moving"}) {
    const std::multiset<std::string> trials = trialsOf(protocol, find, 0);
    EXPECT_EQ(std::set<std::string>(trials.begin(), trials.end()).size(), trials.size());
  }
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, protocol.seed);
  for (size_t i = 1; i < schedule.trials.size(); ++i) {
    if (schedule.trials[i].block == schedule.trials[i - 1].block) {
      EXPECT_NE(schedule.trials[i].view, schedule.trials[i - 1].view);
    }
  }
  ASSERT_TRUE(protocol.survey.has_value());
  EXPECT_EQ(protocol.survey->fields.size(), 3u);
  for (const FormField& field : protocol.survey->fields) {
    EXPECT_EQ(field.options.size(), 5u);
  }
}

TEST(Rosen2010, CountsFourToSevenObjectsInFiveTenOrTwentySeconds) {
  const Protocol protocol = protocolOf("rosen2010");
  for (const ProtocolBlock& block : protocol.blocks) {
    if (block.taskName != "count") {
      continue;
    }
    std::set<int> objects;
    std::set<double> exposures;
    std::set<bool> duplicates;
    for (int i = 0; i < block.task->caseCount(); ++i) {
      const CaseInfo info = block.task->caseInfo(i);
      objects.insert(*info.objects);
      exposures.insert(*info.exposureSeconds);
      duplicates.insert(*info.duplicateColors);
    }
    EXPECT_EQ(objects, (std::set<int>{4, 5, 6, 7}));
    EXPECT_EQ(exposures, (std::set<double>{5, 10, 20}));
    EXPECT_EQ(duplicates.size(), 2u);
  }
}

TEST(BalancedProtocol, HasTheSameTrialsAndCellsThatDifferByAtMostOneForOneToSixtySubjects) {
  const Protocol protocol = protocolOf("rosen2010-balanced");
  const Protocol original = protocolOf("rosen2010");
  for (const char* find : {"find stationary", "find moving"}) {
    EXPECT_EQ(trialsOf(protocol, find, 3), trialsOf(original, find, 3));
  }
  for (int subjects = 1; subjects <= 60; ++subjects) {
    const int session = 1 + subjects % protocol.sessions;  // balance_test.cpp has all of them
    const std::vector<BalanceTable> tables = balanceOf(protocol, subjects, session, protocol.seed);
    EXPECT_EQ(tables.size(), 4u + 3 * protocol.blocks.size());
    for (const BalanceTable& table : tables) {
      EXPECT_LE(table.difference, 1) << table.factors << " over " << subjects;
    }
  }
}

TEST(BalancedProtocol, HasNoCaseTwiceInARowAndNoWarnings) {
  const Protocol protocol = protocolOf("rosen2010-balanced");
  EXPECT_THAT(warningsOf(protocol, protocol.seed), Each(HasSubstr("[fill in:")));
  for (int slot = 0; slot < 60; ++slot) {
    for (int session = 1; session <= protocol.sessions; ++session) {
      const SessionSchedule schedule = scheduleOf(protocol, slot, session, protocol.seed);
      EXPECT_EQ(schedule.trials.size(), 90u);
      for (size_t i = 1; i < schedule.trials.size(); ++i) {
        const TrialPlan& before = schedule.trials[i - 1];
        const TrialPlan& trial = schedule.trials[i];
        if (trial.block == before.block) {
          EXPECT_NE(trial.caseIndex, before.caseIndex);
          EXPECT_NE(trial.view, before.view);
        }
      }
    }
  }
}

TEST(ShortProtocol, TakesTenMinutes) {
  const Protocol protocol = protocolOf("short");
  const double seconds = durationOf(partsOf(protocol, scheduleOf(protocol, 0, 1, 1))).typicalSeconds;
  EXPECT_GT(seconds, 7 * 60);
  EXPECT_LT(seconds, 11 * 60);
}

TEST(EstimatesProtocol, AsksForBothNumbersInTenMinutesWithTruthsThatDiffer) {
  const Protocol protocol = protocolOf("estimates");
  ASSERT_EQ(protocol.blocks.size(), 2u);
  EXPECT_THAT(warningsOf(protocol, protocol.seed), Each(HasSubstr("[fill in:")));
  const double seconds = durationOf(partsOf(protocol, scheduleOf(protocol, 0, 1, 1))).typicalSeconds;
  EXPECT_GT(seconds, 7 * 60);
  EXPECT_LT(seconds, 11 * 60);
  for (const ProtocolBlock& block : protocol.blocks) {
    std::set<std::string> truths;
    for (int i = 0; i < block.task->caseCount(); ++i) {
      TrialPlan plan;
      plan.caseIndex = i;
      truths.insert(block.task->answerOf(plan));
    }
    EXPECT_EQ(static_cast<int>(truths.size()), block.task->caseCount()) << block.name;
  }
}

TEST(StaircaseProtocol, LevelsAreByHowMuchTheFartherBallIsFarther) {
  const Protocol protocol = protocolOf("staircase");
  EXPECT_THAT(warningsOf(protocol, protocol.seed), Each(HasSubstr("[fill in:")));
  const ProtocolBlock& block = protocol.blocks.at(0);
  ASSERT_NE(block.staircase, nullptr);
  EXPECT_GE(block.staircase->levels.back(), 10 * block.staircase->levels.front());
  for (int i = 0; i < block.task->caseCount(); ++i) {
    TrialPlan plan;
    plan.caseIndex = i;
    const auto run = block.task->start(plan, {640, 400, 60});
    run->handle(KeyEvent{Key::kLeft, true, {}});
    const std::map<std::string, double> measures = run->outcome().value().measures;
    const double left = measures.at("left_distance_m");
    const double right = measures.at("right_distance_m");
    EXPECT_NEAR(std::max(left, right) / std::min(left, right) - 1, measures.at("level"), 1e-4);
  }
}

TEST(CheckReport, WarnsWhileTheConsentIsTheSample) {
  for (const char* name : {"short", "rosen2010", "rosen2010-balanced", "nearer", "estimates", "staircase"}) {
    nlohmann::json json =
        nlohmann::json::parse(std::ifstream(OCELLI_SOURCE_DIR "/protocols/" + std::string(name) + ".json"));
    json["blocks"] = nlohmann::json::array({json.at("blocks").at(0)});
    const auto placeholders = [&] {
      const Protocol protocol = protocolFromJsonText(json.dump(), name);
      const std::vector<std::string> warnings = warningsOf(protocol, 1);
      return std::count_if(warnings.begin(), warnings.end(),
                           [](const std::string& warning) { return warning.find("[fill in:") != std::string::npos; });
    };
    EXPECT_EQ(placeholders(), 5) << name;  // controller, contact, purpose, retention, complaints
    json["consent"]["paragraphs"] = {"Do you agree [really]?"};
    EXPECT_EQ(placeholders(), 0) << name;
  }
}

TEST(CheckReport, WarnsOfWhatTheOriginalDoes) {
  const std::string report = checkReport(protocolOf("rosen2010"), {});
  EXPECT_NE(report.find("differences between views include those of learning"), std::string::npos);
  EXPECT_NE(report.find("all subjects have the same schedule"), std::string::npos);
  EXPECT_NE(report.find("90"), std::string::npos);
}

TEST(QuestionsProtocol, CanBeReadInAllLanguages) {
  const std::string text = protocolOf("questions").text;
  const std::string english = protocolOf("questions").title;
  for (const SubjectCatalogue& language : subjectCatalogues()) {
    std::string other = text;
    const std::string field = R"("language": "en")";
    ASSERT_NE(other.find(field), std::string::npos);
    other.replace(other.find(field), field.size(), R"("language": ")" + language.language + '"');
    const Protocol protocol = protocolFromJsonText(other, language.language);
    EXPECT_EQ(protocol.title == english, language.language == kSourceLanguage);
    EXPECT_EQ(protocol.demographics->fields[1].values[2], "colour-blind") << "what is stored has no language";
    const bool warns = checkReport(protocol, {}).find("are a draft") != std::string::npos;
    EXPECT_EQ(warns, language.isDraft) << language.language;
  }
}

TEST(QuestionsProtocol, HasAllKindsOfQuestionsAndAllQuestionnaires) {
  const Protocol protocol = protocolOf("questions");
  std::set<std::string> kinds;
  std::set<std::string> questionnaires;
  for (const ProtocolForm* form : formsOf(protocol)) {
    questionnaires.insert(form->questionnaire);
    for (const FormField& field : form->fields) {
      kinds.insert(field.kind);
    }
  }
  EXPECT_EQ(kinds.size(), questionKinds().size());
  for (const std::string& name : questionnaireNames()) {
    EXPECT_TRUE(questionnaires.contains(name)) << name;
  }
}

TEST(NearerProtocol, HasAsManyCasesOfEitherSide) {
  const Protocol protocol = protocolOf("nearer");
  ASSERT_EQ(protocol.blocks.size(), 1u);
  int left = 0;
  const TaskBlock& task = *protocol.blocks[0].task;
  for (int i = 0; i < task.caseCount(); ++i) {
    TrialPlan plan;
    plan.caseIndex = i;
    left += task.answerOf(plan) == "left" ? 1 : 0;
  }
  EXPECT_EQ(2 * left, task.caseCount());
  // Nor does a view go with a side, in the first half of the trials either.
  for (int slot = 0; slot < 4; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 1, protocol.seed);
    std::map<std::pair<TrialView, std::string>, int> first;
    for (size_t i = 0; i < schedule.trials.size() / 2; ++i) {
      ++first[{schedule.trials[i].view, task.answerOf(schedule.trials[i])}];
    }
    for (const auto& [viewAndSide, count] : first) {
      EXPECT_EQ(count, task.caseCount() / 4) << protocol.nameOf(viewAndSide.first) << viewAndSide.second;
    }
  }
  EXPECT_THAT(warningsOf(protocol, protocol.seed), Each(HasSubstr("[fill in:")));
}

}  // namespace
}  // namespace ocelli::test
