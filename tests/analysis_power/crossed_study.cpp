#include "tests/analysis_power/crossed_study.h"

#include "analysis/power/simulated_dataset.h"

namespace ocelli::test {

Protocol crossedProtocol() {
  return protocolFromJsonText(R"({
  "name": "crossed", "title": "Crossed", "sessions": 1,
  "factors": [{"name": "camera", "levels": ["flat", "bent"]}, {"name": "height", "levels": ["low", "high"]},
              {"name": "size", "levels": ["small", "large"], "of": "cases"}],
  "conditions": [
    {"name": "flat-low", "view": "pinhole", "factors": {"camera": "flat", "height": "low"}},
    {"name": "flat-high", "view": "pinhole", "label": "flat, high", "factors": {"camera": "flat", "height": "high"}},
    {"name": "bent-low", "view": "graph", "factors": {"camera": "bent", "height": "low"}},
    {"name": "bent-high", "view": "graph", "label": "bent, high", "factors": {"camera": "bent", "height": "high"}}],
  "mazes": {"grid": {"plan": ["+-+-+-+-+", "|       |", "+ +-+ + +", "|     | |", "+ + +-+ +", "| |     |", "+ +-+ + +",
                              "|       |", "+-+ +-+-+"]}},
  "blocks": [
    {"name": "find", "title": "Find", "task": "find", "maze": "grid", "limit_seconds": 60,
     "cases": [{"row": 0, "column": 0, "factors": {"size": "small"}}, {"row": 0, "column": 3, "factors": {"size": "large"}},
               {"row": 2, "column": 1, "factors": {"size": "small"}}, {"row": 1, "column": 2, "factors": {"size": "large"}},
               {"row": 1, "column": 0, "factors": {"size": "small"}}, {"row": 1, "column": 1, "factors": {"size": "large"}},
               {"row": 2, "column": 0, "factors": {"size": "small"}}, {"row": 3, "column": 0, "factors": {"size": "large"}}]},
    {"name": "path", "title": "Path", "task": "path", "maze": "grid", "turns": 3, "least_seconds": 5,
     "most_seconds": 40, "cases": [{}, {}, {}, {}, {}, {}, {}, {}]}],
  "survey": {"title": "Survey", "fields": [{"name": "easier_find", "question": "Easier to find?",
    "options": ["1", "2", "3"], "ends": ["bent, low", "flat, high"], "favors": ["bent-low", "flat-high"]}]}
})",
                              "crossed.json");
}

AnalysisPlan crossedPlan() {
  return planFromJsonText(R"({
  "name": "crossed", "factors": ["camera", "height", "size"],
  "models": [
    {"name": "find-time", "task": "find", "kind": "log_normal_mixed", "terms": ["condition", "size"],
     "random": [{"group": "subject", "slopes": ["condition"]}, {"group": "case", "slopes": ["condition"]}]},
    {"name": "path-right", "task": "path", "kind": "binomial_mixed", "terms": ["condition"],
     "random": [{"group": "subject"}, {"group": "case", "slopes": ["condition"]}]}],
  "contrasts": [
    {"name": "find-pair", "model": "find-time", "family": "find", "conditions": ["bent-low", "flat-low"]},
    {"name": "find-weights", "model": "find-time", "family": "find",
     "weights": {"flat-low": -1, "bent-low": 0.5, "bent-high": 0.5}},
    {"name": "find-camera", "model": "find-time", "family": "find", "factors": {"camera": ["bent", "flat"]}},
    {"name": "find-height", "model": "find-time", "family": "find", "factors": {"height": ["high", "low"]}},
    {"name": "find-interaction", "model": "find-time", "family": "find",
     "factors": {"camera": ["bent", "flat"], "height": ["high", "low"]}},
    {"name": "path-pair", "model": "path-right", "statement": "Paths are recognised better with bent rays, low",
     "conditions": ["bent-low", "flat-low"]},
    {"name": "path-camera", "model": "path-right", "factors": {"camera": ["bent", "flat"]}}]
})",
                          "crossed plan", {"find", "path", "survey"});
}

const std::map<std::string, double>& crossedTruths() {
  // Of find: 0, 0.1, -0.3 and 0.05 against the first; of path: 0, 0, 0.6 and 0.2.
  static const std::map<std::string, double> kTruths{
      {"find-pair", -0.3},        {"find-weights", -0.125}, {"find-camera", -0.175}, {"find-height", 0.225},
      {"find-interaction", 0.25}, {"path-pair", 0.6},       {"path-camera", 0.4}};
  return kTruths;
}

Dataset crossedStudy(const Protocol& protocol, int subjects, uint64_t seed) {
  SimulationPlan plan;
  plan.kind = SubjectKind::kGenerator;
  plan.seed = seed;
  plan.sessions.assign(static_cast<size_t>(subjects), 1);
  plan.effects.setCondition("find", "flat-high", 0.1);
  plan.effects.setCondition("find", "bent-low", -0.3);
  plan.effects.setCondition("find", "bent-high", 0.05);
  plan.effects.at("find", kSubjectGraphSd) = 0.3;
  plan.effects.at("find", kItemViewSd) = 0.2;
  plan.effects.setCondition("path", "flat-high", 0);
  plan.effects.setCondition("path", "bent-low", 0.6);
  plan.effects.setCondition("path", "bent-high", 0.2);
  plan.effects.at("path", kItemViewSd) = 0.3;
  return simulatedDatasetWithoutAnswers(protocol, plan);
}

}  // namespace ocelli::test
