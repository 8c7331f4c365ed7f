#include "study/live/live_status.h"

#include <nlohmann/json.hpp>

#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// What JSON can hold, whatever a protocol's names or the name of a device are made of.
Json clean(const std::string& text) {
  return cleanText(text);
}

}  // namespace

std::string jsonText(const LiveStatus& status, double ageSeconds) {
  Json trials = Json::array();
  for (const LiveTrial& trial : status.lastTrials) {
    Json row{{"trial", trial.number == 0 ? Json("practice") : Json(trial.number)},
             {"outcome", trial.outcome},
             {"response_s", trial.outcome == "broken off" ? Json() : Json(trial.responseSeconds)}};
    if (!status.hidesCondition) {
      row["condition"] = clean(trial.condition);
    }
    trials.push_back(std::move(row));
  }
  Json devices = Json::array();
  for (const LiveDevice& device : status.devices) {
    devices.push_back({{"name", clean(device.name)}, {"state", clean(device.state)}, {"trouble", device.hasTrouble}});
  }
  Json warnings = Json::array();
  for (const LiveWarning& warning : status.warnings) {
    warnings.push_back({{"at_s", warning.seconds}, {"text", clean(warning.text)}});
  }
  const Json json{{"age_s", ageSeconds},
                  {"state", status.state},
                  {"step", clean(status.step)},
                  {"condition", status.hidesCondition || status.condition.empty() ? Json() : clean(status.condition)},
                  {"hides_condition", status.hidesCondition},
                  {"trials_done", status.trialsDone},
                  {"trials", status.trials},
                  {"block", status.block},
                  {"blocks", status.blocks},
                  {"elapsed_s", status.elapsedSeconds},
                  {"left_s", status.secondsLeft},
                  {"left_by", status.leftByPace ? "pace" : "protocol"},
                  {"timing",
                   {{"frames", status.frames},
                    {"dropped", status.dropped},
                    {"last_dropped", status.lastDropped},
                    {"last_median_ms", status.lastMedianMilliseconds},
                    {"last_longest_ms", status.lastLongestMilliseconds},
                    {"verdicts", status.verdicts}}},
                  {"last_trials", std::move(trials)},
                  {"devices", std::move(devices)},
                  {"warnings", std::move(warnings)},
                  {"warning_count", status.warningCount}};
  return json.dump();
}

}  // namespace ocelli
