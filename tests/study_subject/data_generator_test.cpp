#include "study/subject/data_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/sha256.h"
#include "study/tasks/task_registry.h"
#include "tests/study_session/session_harness.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

ProtocolBlock blockOf(const std::string& name, const std::string& task, const std::string& json) {
  ProtocolBlock block;
  block.name = name;
  block.title = name;
  block.taskName = task;
  block.task = test::readBlock(task, json);
  return block;
}

Protocol protocolOfAllTasks() {
  Protocol protocol;
  protocol.name = "generated";
  protocol.sessions = 2;
  protocol.blocks.push_back(blockOf("find", "find", R"({"maze": "small", "limit_seconds": 60, "cases": [
      {"row": 0, "column": 0}, {"row": 0, "column": 5}, {"row": 3, "column": 3}, {"row": 4, "column": 0}]})"));
  const std::string pinholes = R"("pinholes": {"rows": 1, "columns": 1, "views": [{"row": 2, "column": 0,
      "heading": "east"}]})";
  protocol.blocks.push_back(blockOf("count", "count", R"({"maze": "small", )" + pinholes + R"(, "cases": [
      {"objects": 4, "exposure_seconds": 5}, {"objects": 5, "exposure_seconds": 10},
      {"objects": 6, "exposure_seconds": 20, "duplicate_colors": true}, {"objects": 7, "exposure_seconds": 10}]})"));
  protocol.blocks.push_back(blockOf("path", "path", R"({"maze": "small", "turns": 3, "least_seconds": 8,
      "most_seconds": 30, "cases": [{}, {}]})"));
  return protocol;
}

/// Trials of so many subjects, in two sessions each.
std::vector<TrialRecord> generate(const GeneratorEffects& effects, int subjects) {
  const Protocol protocol = protocolOfAllTasks();
  std::vector<TrialRecord> records;
  for (int i = 0; i < subjects; ++i) {
    for (int session = 1; session <= 2; ++session) {
      const SessionSchedule schedule = scheduleOf(protocol, i, session, 1);
      test::FakeSink sink;
      generateSession(protocol, {schedule, effects, 1, static_cast<uint64_t>(i) + 100}, sink);
      for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
        records.push_back(end.record);
      }
      EXPECT_EQ(sink.all<test::SessionEnds>().size(), 1u);
    }
  }
  return records;
}

struct Mean {
  double sum = 0;
  int count = 0;
  void add(double x) {
    sum += x;
    ++count;
  }
  double value() const { return sum / count; }
};

double responseSecondsOf(const TrialRecord& record) {
  return static_cast<double>(record.outcome.responseTicks) / kTicksPerSecond;
}

TEST(DataGenerator, viewsDifferInLogTimesByTheEffectThatItWasGiven) {
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 2;  // far from the limit: next to nothing is censored
  effects.at("find", "graph") = -0.5;
  effects.at("find", "session") = -0.2;
  constexpr int kSubjects = 100;
  std::array<Mean, 2> view;
  std::array<Mean, 2> session;
  int censored = 0;
  int find = 0;
  const std::vector<TrialRecord> records = generate(effects, kSubjects);
  for (size_t i = 0; i < records.size(); ++i) {
    if (records[i].plan.task != "find") {
      continue;
    }
    ++find;
    censored += records[i].outcome.censored ? 1 : 0;
    view[static_cast<size_t>(records[i].plan.view)].add(std::log(responseSecondsOf(records[i])));
    session[i / (records.size() / kSubjects / 2) % 2].add(std::log(responseSecondsOf(records[i])));
  }
  EXPECT_EQ(find, kSubjects * 2 * 8);
  EXPECT_LT(censored, find / 200);
  // Residuals and the subjects' own slopes: sqrt(2 * 0.45^2 / 800 + 0.1^2 / 100) = 0.025, four times.
  EXPECT_NEAR(view[1].value() - view[0].value(), effects.at("find", "graph"), 0.1);
  // Items differ between sessions: 0.35 * sqrt(2 / 4) = 0.25 for four items each, twice that.
  EXPECT_NEAR(session[1].value() - session[0].value(), effects.at("find", "session"), 0.5);
}

TEST(DataGenerator, timesAreCensoredAtTheLimit) {
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 5;
  for (const TrialRecord& record : generate(effects, 20)) {
    if (record.plan.task == "find" && record.outcome.censored) {
      EXPECT_EQ(responseSecondsOf(record), 60);
      EXPECT_EQ(record.outcome.answer, "");
    }
    EXPECT_LE(responseSecondsOf(record), 60);
  }
}

TEST(DataGenerator, accuraciesAreThoseOfItsLogits) {
  GeneratorEffects effects;
  effects.at("count", "right") = 0.4;
  effects.at("count", "graph") = 1.2;
  effects.at("count", "duplicates") = 0;
  effects.at("count", "doubled_exposure") = 0;
  effects.at("count", "session") = 0;
  effects.at("count", "subject_sd") = 0;
  effects.at("count", "item_sd") = 0;
  effects.at("path", "right") = -0.5;
  effects.at("path", "graph") = 0;
  effects.at("path", "session") = 0;
  effects.at("path", "subject_sd") = 0;
  effects.at("path", "item_sd") = 0;
  std::map<std::pair<std::string, TrialView>, Mean> right;
  for (const TrialRecord& record : generate(effects, 100)) {
    right[{record.plan.task, record.plan.view}].add(record.outcome.correct ? 1 : 0);
    if (record.plan.task == "count") {
      const int off = std::stoi(record.outcome.answer) - std::stoi(record.outcome.expected);
      EXPECT_EQ(std::abs(off), record.outcome.correct ? 0 : 1);
    }
  }
  const auto share = [](double logit) { return 1 / (1 + std::exp(-logit)); };
  // 800 and 400 trials: four standard errors of a share are at most 0.071 and 0.1.
  EXPECT_NEAR((right[{"count", TrialView::kReference}].value()), share(0.4), 0.071);
  EXPECT_NEAR((right[{"count", TrialView::kOther}].value()), share(1.6), 0.071);
  EXPECT_NEAR((right[{"path", TrialView::kReference}].value()), share(-0.5), 0.1);
}

TEST(DataGenerator, subjectsAndItemsDifferAsMuchAsTheyShould) {
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 1.5;
  effects.at("find", "graph") = 0;
  effects.at("find", "moving") = 0;
  effects.at("find", "session") = 0;
  effects.at("find", "subject_sd") = 0.6;
  effects.at("find", "subject_graph_sd") = 0;
  effects.at("find", "item_sd") = 0;
  effects.at("find", "residual_sd") = 0.1;
  constexpr int kSubjects = 100;
  const std::vector<TrialRecord> records = generate(effects, kSubjects);
  const size_t each = records.size() / kSubjects;
  Mean means;
  Mean squares;
  for (size_t subject = 0; subject < kSubjects; ++subject) {
    Mean own;
    for (size_t i = subject * each; i < (subject + 1) * each; ++i) {
      if (records[i].plan.task == "find") {
        own.add(std::log(responseSecondsOf(records[i])));
      }
    }
    means.add(own.value());
    squares.add(own.value() * own.value());
  }
  const double deviation = std::sqrt(squares.value() - means.value() * means.value());
  EXPECT_NEAR(deviation, 0.6, 4 * 0.6 / std::sqrt(2.0 * kSubjects));
}

/// Standard deviation over the cases of what their mean in the graph camera exceeds that in the pinhole.
template <class ValueOf>
double deviationOfViewEffects(const std::vector<TrialRecord>& records, size_t eachSession, const std::string& task,
                              const ValueOf& valueOf) {
  std::map<std::string, std::array<Mean, 2>> cases;
  for (size_t i = 0; i < records.size(); ++i) {
    if (records[i].plan.task == task) {
      const std::string item = records[i].info.label + (i / eachSession % 2 == 0 ? ", first" : ", second");
      cases[item][static_cast<size_t>(records[i].plan.view)].add(valueOf(records[i]));
    }
  }
  Mean means;
  Mean squares;
  for (const auto& [item, views] : cases) {
    const double effect = views[1].value() - views[0].value();
    means.add(effect);
    squares.add(effect * effect);
  }
  return std::sqrt(squares.value() - means.value() * means.value());
}

TEST(DataGenerator, casesDifferInTheEffectOfTheViewAsMuchAsTheyShould) {
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 1;
  effects.at("find", "subject_graph_sd") = 0;
  effects.at("find", "residual_sd") = 0.1;
  constexpr int kSubjects = 20;
  const auto deviation = [&](double itemViewSd) {
    effects.at("find", "item_view_sd") = itemViewSd;
    const std::vector<TrialRecord> records = generate(effects, kSubjects);
    return deviationOfViewEffects(records, records.size() / kSubjects / 2, "find",
                                  [](const TrialRecord& record) { return std::log(responseSecondsOf(record)); });
  };
  // Of residuals alone: 0.1 * sqrt(2 / 20) = 0.032.
  EXPECT_LT(deviation(0), 0.06);
  // Eight items: four standard errors of a deviation are 0.8 of it, upwards; it is well above that of residuals.
  EXPECT_GT(deviation(0.8), 0.3);
  EXPECT_LT(deviation(0.8), 1.44);
}

TEST(DataGenerator, effectsOfTheViewThatDifferLeaveTheOtherDrawsAsTheyAre) {
  GeneratorEffects effects;
  effects.at("find", "log_seconds") = 1.5;
  const std::vector<TrialRecord> alike = generate(effects, 2);
  effects.at("find", "item_view_sd") = 0.5;
  const std::vector<TrialRecord> differing = generate(effects, 2);
  std::map<std::pair<std::string, int>, double> halves;  // by case and session, of the first subject
  const size_t eachSession = alike.size() / 4;
  for (size_t i = 0; i < alike.size(); ++i) {
    if (alike[i].plan.task == "find") {
      const double half = (alike[i].plan.view == TrialView::kOther ? 1 : -1) *
                          (std::log(responseSecondsOf(differing[i])) - std::log(responseSecondsOf(alike[i])));
      const auto [place, isNew] = halves.try_emplace({alike[i].info.label, i / eachSession % 2}, half);
      // Times of 1 s and more in ticks of 1/240 s: four roundings of half a tick.
      EXPECT_NEAR(place->second, half, 4 * 0.5 / 240) << "the same for both views and all subjects";
    } else {
      EXPECT_EQ(alike[i].outcome.correct, differing[i].outcome.correct);
    }
  }
  EXPECT_EQ(halves.size(), 8U);
}

// Studies that were simulated by earlier versions go on with the same numbers: rows that are added to the registry come
// after those that were there, and draw after them.
TEST(DataGenerator, drawsWhatItDrewBeforeThereWasARegistry) {
  std::string text;
  for (const TrialRecord& record : generate({}, 3)) {
    text += record.plan.task + " " + record.outcome.answer + " " + std::to_string(record.outcome.responseTicks) + "\n";
  }
  EXPECT_EQ(sha256(text), "66d63beecc235f663efc3921beeb3e224aad29c5e6ac98f0b37b7cd82d45fe7a") << text.substr(0, 200);
}

TEST(DataGenerator, everyTaskHasRightAndWrongOutcomes) {
  Protocol protocol;
  protocol.name = "all";
  for (const test::TaskExample& example : test::taskExamples()) {
    protocol.blocks.push_back(blockOf(example.name, example.task, example.json));
  }
  for (const bool isGood : {true, false}) {
    GeneratorEffects effects;
    for (const TaskKind& kind : taskKinds()) {
      // Hardly any time and nearly always right, or the other way round.
      const bool isHigh = (kind.outcome == OutcomeKind::kAnswer) == isGood;
      effects.at(kind.name, kind.generator.effects.front().name) = isHigh ? 20 : -20;
      if (kind.outcome == OutcomeKind::kEstimate) {
        for (const GeneratorEffect& effect : kind.generator.effects) {
          effects.at(kind.name, effect.name) = 0;
        }
        effects.at(kind.name, kind.generator.effects.front().name) = isGood ? 0 : 4 * kind.generator.rightWithin;
      }
    }
    const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
    test::FakeSink sink;
    generateSession(protocol, {schedule, effects, 1, 1}, sink);
    for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
      SCOPED_TRACE(end.record.plan.task);
      const TrialOutcome& outcome = end.record.outcome;
      EXPECT_EQ(outcome.correct, isGood);
      EXPECT_EQ(outcome.correct, outcome.answer == outcome.expected);
      EXPECT_FALSE(outcome.expected.empty());
      EXPECT_EQ(outcome.censored, !isGood && taskKind(end.record.plan.task, "test").outcome == OutcomeKind::kTime);
      EXPECT_GT(outcome.responseTicks, 0);
    }
  }
}

TEST(DataGenerator, staircasesChooseTheCasesByTheAnswersDrawn) {
  const Protocol protocol = protocolFromJsonText(R"({"name": "steps", "title": "Steps",
    "mazes": {"hall": {"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]}},
    "blocks": [{"name": "nearer", "title": "Nearer", "task": "nearer", "maze": "hall",
      "start": {"row": 0, "column": 0, "heading": "east"}, "staircase": {"method": "up_down", "right_in_a_row": 1},
      "cases": [
        {"level": 0.5, "left": {"row": 0, "column": 2, "south": -0.2},
                       "right": {"row": 0, "column": 3, "south": 0.2}},
        {"level": 0.1, "left": {"row": 0, "column": 2, "south": -0.2},
                       "right": {"row": 0, "column": 2, "east": 0.15, "south": 0.2}}]}]})",
                                                 "test");
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
  test::FakeSink sink;
  generateSession(protocol, {schedule, {}, 1, 1}, sink);
  std::map<TrialView, std::optional<bool>> last;
  std::set<double> levels;
  for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
    // One down, one up: the lower of two levels after a right answer.
    std::optional<bool>& before = last[end.record.plan.view];
    const double level = before.value_or(false) ? 0.1 : 0.5;
    EXPECT_EQ(end.record.info.level, level);
    EXPECT_EQ(end.record.outcome.measures.at("level"), level);
    levels.insert(level);
    before = end.record.outcome.correct;
  }
  EXPECT_EQ(levels.size(), 2u);
}

TEST(DataGenerator, formsComeInTheSessionsThatThePersonWouldFillThemIn) {
  Protocol protocol = protocolOfAllTasks();
  protocol.consent = ProtocolPage{"Taking part", {"Go on if you agree."}};
  protocol.demographics = ProtocolForm{"demographics", "About you", "", {{"age", "How old are you?", {"20", "30"}}}};
  protocol.survey = ProtocolForm{"survey", "Survey", "", {{"easier", "Which was easier?", {"1", "2"}}}};
  const auto asked = [&](int session) {
    test::FakeSink sink;
    generateSession(protocol, {scheduleOf(protocol, 0, session, 1), {}, 1, 1}, sink);
    std::string forms = sink.all<ConsentRecord>().empty() ? "" : "consent ";
    for (const AnswerRecord& answer : sink.all<AnswerRecord>()) {
      forms += answer.form + " ";
    }
    return forms;
  };
  EXPECT_EQ(asked(1), "consent demographics ");
  EXPECT_EQ(asked(2), "survey ");
  protocol.surveyAfterLastSessionOnly = false;
  EXPECT_EQ(asked(1), "consent demographics survey ");
}

TEST(DataGenerator, aTaskThatIsUnknownIsAnError) {
  Protocol protocol = protocolOfAllTasks();
  protocol.blocks[1].taskName = "search";
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
  test::FakeSink sink;
  EXPECT_THROW(generateSession(protocol, {schedule}, sink), InputError);
}

}  // namespace
}  // namespace ocelli
