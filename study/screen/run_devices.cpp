#include "study/screen/run_devices.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/window/gamepads.h"
#include "oc_core/window/monitors.h"

namespace ocelli {
namespace {

std::string textOf(const ResponseState& state) {
  return fmt::format("{}: {}{} presses, {} not known, {} bounces", state.device, state.connected ? "" : "gone, ",
                     state.counts.presses, state.counts.unknown, state.bounces);
}

std::string textOf(const GazeCounts& counts) {
  return fmt::format("{} samples, {} of them valid, {} malformed lines, {} lost", counts.samples, counts.valid,
                     counts.malformed, counts.lost);
}

/// What stands before the colon: the name of a file may have that of the subject in it.
std::string deviceKindOf(const std::string& place) {
  return place.substr(0, place.find(':'));
}

}  // namespace

RunDevices::RunDevices(const Protocol& protocol, const StudyRunOptions& options) : options_(options) {
  std::vector<std::unique_ptr<ResponseDevice>> devices;
  for (const std::string& each : options.responses) {
    devices.push_back(openResponseDevice(each, {[] {
                                           initializeGlfw();
                                           return readFirstGamepad();
                                         }}));
  }
  responses_ = std::make_unique<ResponseInput>(std::move(devices), options.debounceMilliseconds);
  if (!options.gaze.empty()) {
    if (!protocol.gaze) {
      throw InputError("the protocol does not say that gaze is recorded, so its consent cannot have told the subject",
                       "--gaze " + options.gaze,
                       "say it in the consent, and set the field \"gaze\" of the protocol to true");
    }
    gazeBytes_ = openGazeBytes(options.gaze);
  }
}

void RunDevices::report(SessionFlow& flow, const std::string& what, const std::string& detail) const {
  flow.report(what, detail);
  if (options_.tell) {
    options_.tell(fmt::format("{:<9} {}", what, detail));
  }
}

void RunDevices::begin(SessionFlow& flow, const TrialScreen& screen) {
  for (const ResponseState& state : responses_->states()) {
    const std::string text = fmt::format("{}, debounced {} ms", state.device, responses_->debounceMilliseconds());
    if (state.device == "keyboard") {
      flow.report("responses", text);  // which it always is
    } else {
      report(flow, "responses", text);
    }
  }
  if (gazeBytes_ != nullptr) {
    report(flow, "gaze", options_.gaze);
    gaze_ = std::make_unique<GazeInput>(std::move(gazeBytes_),
                                        GazeLines(gazeUnitOf(options_.gaze), screen.width, screen.height));
  }
}

void RunDevices::end(SessionFlow& flow) {
  for (const ResponseState& state : responses_->states()) {
    if (state.device != "keyboard") {
      report(flow, "responses", textOf(state));
    } else if (state.bounces > 0) {
      report(flow, "responses", fmt::format("keyboard: {} bounces", state.bounces));
    }
  }
  if (gaze_ != nullptr) {
    const GazeCounts counts = gaze_->counts();
    report(flow, counts.lost > 0 ? "gaze_lost" : "gaze", fmt::format("{}: {}", options_.gaze, textOf(counts)));
  }
}

std::vector<LiveDevice> RunDevices::liveDevices(const std::vector<std::string>& markers,
                                                const std::vector<MarkerCounts>& counts) const {
  std::vector<LiveDevice> list;
  for (const ResponseState& state : responses_->states()) {
    if (state.device == "keyboard") {
      list.push_back({"keyboard", fmt::format("{} bounces", state.bounces), false});
    } else {
      list.push_back({state.device,
                      fmt::format("{}{} presses, {} bounces", state.connected ? "" : "gone, ", state.counts.presses,
                                  state.bounces),
                      !state.connected});
    }
  }
  for (size_t i = 0; i < markers.size(); ++i) {
    list.push_back({"markers " + deviceKindOf(markers[i]),
                    fmt::format("{} sent, {} lost", counts[i].sent, counts[i].lost), counts[i].lost > 0});
  }
  if (gaze_ != nullptr) {
    const GazeCounts gaze = gaze_->counts();
    list.push_back({"gaze " + deviceKindOf(options_.gaze), textOf(gaze),
                    gaze.lost > 0 || gaze.malformed > 0 || gaze.samples == 0});
  }
  return list;
}

}  // namespace ocelli
