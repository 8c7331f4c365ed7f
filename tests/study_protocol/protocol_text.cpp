#include "tests/study_protocol/protocol_text.h"

#include "oc_core/base/error.h"
#include "study/protocol/protocol.h"

namespace ocelli::test {

nlohmann::json smallProtocol() {
  return nlohmann::json::parse(R"({
    "name": "small", "title": "A small study", "description": "For tests", "sessions": 2, "seed": 5,
    "minutes_between_sessions": 10,
    "mazes": {"ring": {"plan": ["+-+-+-+", "|     |", "+ +-+ +", "|     |", "+ + + +", "|   | |", "+-+ +-+"]}},
    "consent": {"title": "Consent", "paragraphs": ["Do you agree?"]},
    "demographics": {"title": "You", "introduction": "Please tell.", "fields": [
      {"name": "vision", "question": "How is it?", "options": ["normal", "impaired"]}]},
    "welcome": [{"title": "Welcome", "paragraphs": ["Hello."], "picture": "controls"}],
    "blocks": [
      {"name": "find it", "title": "Find", "task": "find", "maze": "ring", "sessions": [1],
       "instructions": [{"title": "Find", "paragraphs": ["Find it."],
                         "picture": {"condition": "gc", "case": "seen"}}],
       "example_cases": [{"label": "seen", "row": 0, "column": 1}],
       "moving": {"meters_per_second": 1}, "start": {"row": 0, "column": 0, "heading": "east"},
       "object": {"shape": "cone", "color": "green"}, "portals": {"farthest": 10},
       "practice": {"least_correct": 1, "most_trials": 2}, "practice_cases": [{"row": 0, "column": 1}],
       "cases": [{"label": "here", "row": 0, "column": 2}, {"label": "there", "row": 2, "column": 2}]},
      {"name": "count them", "title": "Count", "task": "count", "maze": "ring", "order": "alternating", "views": "one",
       "comprehensive": {"eye_height": 3}, "places": [{"row": 0, "column": 0}, {"row": 0, "column": 1},
       {"row": 0, "column": 2}, {"row": 1, "column": 0}, {"row": 1, "column": 1}],
       "instructions": [{"title": "Count", "paragraphs": ["Count them."]}], "sessions": [1, 2],
       "practice": {}, "practice_cases": [{"objects": 4, "exposure_seconds": 5}],
       "example_cases": [{"objects": 4, "exposure_seconds": 5}], "variants": {"low": {"comprehensive": {"eye_height": 2}}},
       "pinholes": {"rows": 1, "columns": 2, "views": [{"row": 0, "column": 0, "heading": "east"}]},
       "cases": [{"objects": 5, "exposure_seconds": 5}]},
      {"name": "path", "title": "Path", "task": "path", "maze": "ring", "turns": 2, "least_seconds": 3,
       "most_seconds": 20, "maps": 2, "instructions": [{"title": "Path", "paragraphs": ["Watch."]}], "sessions": [2],
       "practice": {}, "practice_cases": [{}], "example_cases": [{}], "cases": [{"label": "one"}]}],
    "survey": {"title": "Survey", "fields": [
      {"name": "easier", "question": "Which?", "options": ["1", "2", "3"], "ends": ["this", "that"],
       "favors": ["gc", "ppc"]}]},
    "controls": {"forward": "W"}, "screen": {"refresh_hertz": 60}, "timing": {"late_factor": 1.2},
    "exclusions": [{"what": "form:vision", "test": "is", "value": "impaired", "reason": "cannot see"}]})");
}

std::string protocolError(const nlohmann::json& json) {
  try {
    protocolFromJsonText(json.dump(), "study.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
