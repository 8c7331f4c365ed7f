#include "tests/study_subject/simulated_sessions.h"

#include "tests/study_task/study_maze_plan.h"

namespace ocelli::test {

Protocol simulatedProtocol(bool withPractice) {
  const std::string practice = withPractice ? R"("practice": {"least_correct": 1, "most_trials": 2}, )" : "";
  const auto practiceCases = [&](const std::string& cases) {
    return withPractice ? "\"practice_cases\": [" + cases + "], " : std::string();
  };
  std::string text = R"({
    "name": "simulated", "title": "Simulated", "sessions": 2, "seed": 4,
    "mazes": {"small": {"plan": )";
  text += kStudyMazePlan;
  text += R"(}},
    "consent": {"title": "Taking part", "paragraphs": ["Go on if you agree."]},
    "demographics": {"title": "About you", "fields": [
      {"name": "vision", "question": "How is your vision?", "options": ["colour-blind", "normal"]}]},
    "exclusions": [{"what": "form:vision", "test": "is", "value": "colour-blind", "reason": "colours matter"}],
    "blocks": [
      {"name": "find", "title": "Find", "task": "find", "maze": "small", "limit_seconds": 20,
       "break_every_trials": 2, )";
  text += practice;
  text += practiceCases(R"({"row": 3, "column": 3})");
  text += R"("cases": [{"label": "near", "row": 3, "column": 3}, {"label": "far", "row": 2, "column": 5}]},
      {"name": "find moving", "title": "Find", "task": "find", "maze": "small", "limit_seconds": 20, "views": "one",
       "moving": {"meters_per_second": 0.8}, "feedback": true, "cases": [{"label": "a", "row": 2, "column": 3}]},
      {"name": "count", "title": "Count", "task": "count", "maze": "small", "answer_limit_seconds": 20,
       "pinholes": {"rows": 1, "columns": 2, "views": [{"row": 2, "column": 0, "heading": "east"},
                                                       {"row": 0, "column": 0, "heading": "east"}]}, )";
  text += practice;
  text += practiceCases(R"({"objects": 4, "exposure_seconds": 2})");
  text += R"("cases": [{"label": "few", "objects": 4, "exposure_seconds": 3}]},
      {"name": "path", "title": "Path", "task": "path", "maze": "small", "turns": 3, "least_seconds": 8,
       "most_seconds": 30, "views": "one", "cases": [{"label": "only"}]}],
    "break_seconds": 5,
    "survey": {"title": "Survey", "fields": [{"name": "easier_find", "question": "To find the object",
       "options": ["1", "2", "3", "4", "5"], "ends": ["plain view easier", "bent view easier"]}]}
  })";
  return protocolFromJsonText(text, "test protocol");
}

SimulationPlan observers(int subjects, int sessions) {
  SimulationPlan plan;
  plan.sessions.assign(static_cast<size_t>(subjects), sessions);
  plan.seed = 11;
  plan.screen = kSmallScreen;
  return plan;
}

}  // namespace ocelli::test
