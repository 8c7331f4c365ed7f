#include "tests/analysis_dataset/made_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

struct Block {
  const char* name;
  const char* task;
  bool moving;
  int cases;
};
constexpr Block kBlocks[] = {{"find stationary", "find", false, 4},
                             {"find moving", "find", true, 3},
                             {"count stationary", "count", false, 4},
                             {"count moving", "count", true, 4},
                             {"path", "path", false, 4}};
constexpr double kLimit = 60;
constexpr double kTicks = 240;

double chance(double logit) {
  return 1 / (1 + std::exp(-logit));
}

void search(SampleTrial& trial, double slowness, RandomNumbers& random) {
  const bool graph = trial.view == "gc";
  const double logSeconds = 2.5 + slowness + 0.15 * trial.caseIndex - (graph ? std::log(1.5) : 0.0) -
                            0.15 * (trial.session - 1) - (*trial.moving ? 0.3 : 0) + 0.5 * random.normal();
  trial.response = std::round(std::min(std::exp(logSeconds), kLimit) * kTicks) / kTicks;
  trial.censored = trial.response >= kLimit;
  trial.correct = !trial.censored;
  trial.answer = trial.censored ? "" : "there";
  trial.expected = "there";
}

void count(SampleTrial& trial, double slowness, RandomNumbers& random) {
  trial.exposure = trial.caseIndex % 2 == 0 ? 5 : 10;
  trial.objects = 3 + trial.caseIndex;
  trial.duplicates = trial.caseIndex >= 2;
  trial.correct = random.uniform() < chance(0.2 + (trial.view == "gc" ? 1.0 : 0.0) - slowness);
  trial.expected = std::to_string(*trial.objects);
  trial.answer = std::to_string(*trial.objects + (trial.correct ? 0 : random.uniform() < 0.7 ? -1 : 1));
  trial.response = 2;
}

void path(SampleTrial& trial, double slowness, RandomNumbers& random) {
  trial.correct = random.uniform() < chance(0.8 - slowness);
  trial.expected = "map 1";
  trial.answer = trial.correct ? "map 1" : "map 2";
  trial.response = 3;
}

}  // namespace

const char* const kWholeProtocol = R"({
  "name": "rosen2010-whole", "title": "A whole study", "description": "All tasks.", "sessions": 3,
  "mazes": {"small": {"plan": ["+-+-+-+", "|     |", "+ +-+ +", "|   | |", "+ +-+-+"]}},
  "blocks": [
    {"name": "find stationary", "title": "Find", "task": "find", "maze": "small", "limit_seconds": 60,
     "cases": [{"label": "location 1", "row": 0, "column": 2}, {"label": "location 2", "row": 1, "column": 2},
               {"label": "location 3", "row": 1, "column": 0}, {"label": "location 4", "row": 0, "column": 1}]},
    {"name": "find moving", "title": "Find", "task": "find", "maze": "small", "limit_seconds": 60, "moving": {},
     "cases": [{"label": "location 1", "row": 0, "column": 2}, {"label": "location 2", "row": 1, "column": 2},
               {"label": "location 3", "row": 1, "column": 0}]},
    {"name": "count stationary", "title": "Count", "task": "count", "maze": "small", "cases": []},
    {"name": "count moving", "title": "Count", "task": "count", "maze": "small", "moving": {}, "cases": []},
    {"name": "path", "title": "Recognise", "task": "path", "maze": "small", "maps": 3, "cases": []}
  ],
  "survey": {"title": "Which view was easier?", "fields": [
    {"name": "easier_find", "question": "To find the object", "options": ["1", "2", "3", "4", "5"],
     "ends": ["plain view easier", "bent view easier"], "favors": ["ppc", "gc"]},
    {"name": "easier_count", "question": "To count the objects", "options": ["1", "2", "3", "4", "5"],
     "ends": ["plain view easier", "bent view easier"], "favors": ["ppc", "gc"]},
    {"name": "easier_path", "question": "To recognise the path", "options": ["1", "2", "3", "4", "5"],
     "ends": ["plain view easier", "bent view easier"], "favors": ["ppc", "gc"]}]},
  "exclusions": [{"what": "ending", "test": "is", "value": "unwell", "reason": "motion sickness"}]
})";

void fillWholeStudy(SampleStudy& study, const MadeStudy& made) {
  SQLite::Transaction transaction(study.database());
  for (int s = 0; s < made.subjects; ++s) {
    const int number = made.firstNumber + s;
    const std::string subject = fmt::format("S{:02}", number);
    RandomNumbers random(made.seed, static_cast<uint64_t>(number));
    const double slowness = 0.3 * random.normal();
    study.addSubject(subject, made.kind);
    for (int session = 1; session <= made.sessions; ++session) {
      study.addSession(subject, session);
      int plan = 0;
      for (size_t b = 0; b < std::size(kBlocks); ++b) {
        for (int i = 0; i < 2 * kBlocks[b].cases; ++i) {
          SampleTrial trial;
          trial.subject = subject;
          trial.session = session;
          trial.plan = plan++;
          trial.blockIndex = static_cast<int>(b);
          trial.block = kBlocks[b].name;
          trial.task = kBlocks[b].task;
          trial.moving = kBlocks[b].moving;
          trial.caseIndex = i / 2;
          trial.caseLabel = fmt::format("location {}", trial.caseIndex + 1);
          // Which view comes first changes from case to case, and from subject to subject.
          trial.view = (i + i / 2 + number) % 2 == 0 ? "ppc" : "gc";
          (trial.task == "find" ? search : trial.task == "count" ? count : path)(trial, slowness, random);
          if (!made.change || made.change(trial)) {
            study.addTrial(trial);
          }
        }
      }
    }
    study.addConsent(subject, true);
    study.addAnswer(subject, "demographics", "vision", "normal");
    for (const char* field : {"easier_find", "easier_count", "easier_path"}) {
      const std::string drawn = std::to_string(2 + random.below(4));
      study.addAnswer(subject, "survey", field, made.surveyAnswer.empty() ? drawn : made.surveyAnswer, made.sessions);
    }
  }
  transaction.commit();
}

}  // namespace ocelli::test
