#include "oc_core/feeds_measure/feed_truth.h"

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/feeds_measure/feed_rigs.h"
#include "oc_core/feeds_measure/simulate_feeds.h"

namespace ocelli {
namespace {

using TruthJson = nlohmann::ordered_json;

constexpr size_t kMaxFrames = 10'000'000;

FeedTruth readFeedTruth(JsonFields& fields) {
  FeedTruth truth;
  truth.name = fields.text("name");
  truth.clockOffsetSeconds = fields.number("clock_offset_seconds", 0, 1e6);
  truth.phase = fields.number("phase", 0, 1);
  truth.exposurePeriod = fields.number("exposure_period", 1e-3, 1e6);
  truth.exposurePhase = fields.number("exposure_phase", -1e3, 1e3);
  truth.frozenFromSeconds = fields.number("frozen_from_seconds", -1, 1e6);
  const nlohmann::json& dropped = fields.value("dropped");
  if (!dropped.is_array()) {
    fields.fail("dropped", "must be an array of whole numbers");
  }
  for (const nlohmann::json& frame : dropped) {
    if (!frame.is_number_unsigned() || frame.get<size_t>() > kMaxFrames) {
      fields.fail("dropped", "must be an array of whole numbers");
    }
    truth.dropped.push_back(frame.get<size_t>());
  }
  return truth;
}

}  // namespace

double FeedTruth::exposureAt(double seconds, double swing) const {
  return 1 + swing * std::sin(2 * kPi * seconds / exposurePeriod + exposurePhase);
}

Walkers SimulationTruth::makeWalkers() const {
  return {feedRigOf(scene).ways(), walkers, seconds, seed};
}

std::string jsonText(const SimulationTruth& truth, const FeedSetup& setup) {
  TruthJson feeds = TruthJson::array();
  for (size_t i = 0; i < truth.feeds.size(); ++i) {
    const FeedTruth& feed = truth.feeds[i];
    const FeedLens& lens = setup.feeds[i].lens;
    const FeedPose& pose = setup.feeds[i].pose;
    feeds.push_back({{"name", feed.name},
                     {"clock_offset_seconds", feed.clockOffsetSeconds},
                     {"phase", feed.phase},
                     {"exposure_period", feed.exposurePeriod},
                     {"exposure_phase", feed.exposurePhase},
                     {"frozen_from_seconds", feed.frozenFromSeconds},
                     {"dropped", feed.dropped},
                     {"lens",
                      {{"focal", {lens.focal.x, lens.focal.y}},
                       {"center", {lens.center.x, lens.center.y}},
                       {"distortion", {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}}}},
                     {"eye", {pose.eye.x, pose.eye.y, pose.eye.z}},
                     {"target", {pose.target.x, pose.target.y, pose.target.z}}});
  }
  const Walkers walkers = truth.makeWalkers();
  TruthJson frames = TruthJson::array();
  const auto count = static_cast<size_t>(std::llround(truth.seconds * truth.framesPerSecond));
  for (size_t k = 0; k < count; ++k) {
    const double seconds = static_cast<double>(k) / truth.framesPerSecond;
    TruthJson places = TruthJson::array();
    for (size_t w = 0; w < walkers.count(); ++w) {
      const WalkerState state = walkers.at(w, seconds);
      places.push_back({state.place.x, state.place.y, state.heading});
    }
    frames.push_back({{"seconds", seconds}, {"walkers", places}});
  }
  const TruthJson json{{"scene", truth.scene},
                       {"seed", truth.seed},
                       {"walkers", truth.walkers},
                       {"seconds", truth.seconds},
                       {"frames_per_second", truth.framesPerSecond},
                       {"exposure_swing", truth.exposureSwing},
                       {"noise_levels", truth.noiseLevels},
                       {"rolling_seconds", truth.rollingSeconds},
                       {"feeds", feeds},
                       {"frames", frames}};
  return textOfJson(json) + "\n";
}

SimulationTruth readSimulationTruth(const std::filesystem::path& path) {
  const JsonDocument document(readFile(path), path.string());
  return readAs("docs/feeds.md", [&] {
    JsonFields fields(document, UnknownFields::kIgnored);
    SimulationTruth truth;
    truth.scene = fields.text("scene");
    truth.seed = static_cast<uint64_t>(fields.number("seed", 0, 9e15));
    truth.walkers = static_cast<size_t>(fields.integer("walkers", 0, 100));
    truth.seconds = fields.number("seconds", 0, 1e6);
    truth.framesPerSecond = fields.number("frames_per_second", 1, 1000);
    truth.exposureSwing = fields.number("exposure_swing", 0, 1);
    truth.noiseLevels = fields.number("noise_levels", 0, 255);
    truth.rollingSeconds = fields.number("rolling_seconds", 0, kMaxRollingSeconds, 0);
    fields.forEach("feeds", 1, kMaxFeeds, [&](JsonFields& each) { truth.feeds.push_back(readFeedTruth(each)); });
    return truth;
  });
}

}  // namespace ocelli
