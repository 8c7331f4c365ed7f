#include "tests/analysis_power/small_protocol.h"

namespace ocelli::test {

std::string smallProtocolText() {
  return R"({
  "name": "small", "title": "Small", "sessions": 1,
  "mazes": {"grid": {"plan": ["+-+-+-+-+", "|       |", "+ +-+ + +", "|     | |", "+ + +-+ +", "| |     |", "+ +-+ + +",
                              "|       |", "+-+ +-+-+"]}},
  "blocks": [
    {"name": "find", "title": "Find", "task": "find", "maze": "grid", "limit_seconds": 60,
     "cases": [{"label": "a", "row": 0, "column": 0}, {"label": "b", "row": 0, "column": 3},
               {"label": "c", "row": 2, "column": 1}, {"label": "d", "row": 1, "column": 2}]},
    {"name": "count", "title": "Count", "task": "count", "maze": "grid",
     "pinholes": {"rows": 1, "columns": 1, "views": [{"row": 2, "column": 0, "heading": "north"}]},
     "cases": [{"label": "a", "objects": 4, "exposure_seconds": 5}, {"label": "b", "objects": 5, "exposure_seconds": 10},
               {"label": "c", "objects": 6, "exposure_seconds": 5}, {"label": "d", "objects": 7, "exposure_seconds": 10}]},
    {"name": "path", "title": "Path", "task": "path", "maze": "grid", "turns": 3, "least_seconds": 5,
     "most_seconds": 40, "cases": [{}, {}, {}, {}]}]
})";
}

Protocol smallProtocol() {
  return protocolFromJsonText(smallProtocolText(), "small.json");
}

}  // namespace ocelli::test
