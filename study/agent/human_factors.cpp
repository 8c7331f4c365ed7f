#include "study/agent/human_factors.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "study/agent/chance.h"

namespace ocelli {
namespace {

struct FactorRow {
  const char* name;
  double HumanFactors::*member;
  double deviation;  ///< between subjects; 0: all are alike
  double least;      ///< of subjects with the usual mean
  double greatest;
  double lower;  ///< what the mean can be
  double upper;
  double step = 0;  ///< subjects have multiples of it; 0: any value
};

using H = HumanFactors;

constexpr double kAny = 0;

/// In the order in which they are drawn and written.
constexpr std::array kFactorRows = {
    FactorRow{"fixation_seconds", &H::fixationSeconds, 0.03, 0.22, 0.38, 0.1, 2},
    FactorRow{"fixation_spread_seconds", &H::fixationSpread, 0, kAny, kAny, 0, 0.5},
    FactorRow{"saccade_seconds", &H::saccadeSeconds, 0, kAny, kAny, 0.01, 0.2},
    FactorRow{"useful_field_degrees", &H::usefulFieldDegrees, 1.5, 9, 16, 1, 60},
    FactorRow{"noticed_degrees", &H::noticedDegrees, 0.03, 0.08, 0.3, 0.01, 5},
    FactorRow{"doubling_degrees", &H::doublingDegrees, 0.5, 2, 4, 0.5, 60},
    FactorRow{"notice_seconds", &H::noticeSeconds, 0.04, 0.1, 0.35, 0.02, 2},
    FactorRow{"least_floor_degrees", &H::minFloorDegrees, 0, kAny, kAny, 0.01, 5},
    FactorRow{"item_seconds", &H::itemSeconds, 0.04, 0.22, 0.4, 0.02, 3},
    FactorRow{"group_seconds", &H::groupSeconds, 0.015, 0.04, 0.1, 0.01, 1},
    FactorRow{"group_items", &H::groupItems, 0.6, 3, 4, 1, 10, 1},
    FactorRow{"group_radius_degrees", &H::groupRadiusDegrees, 0, kAny, kAny, 1, 30},
    FactorRow{"tracked_items", &H::trackedItems, 0.8, 2, 6, 0, 20, 1},
    FactorRow{"working_memory_items", &H::workingMemoryItems, 0.8, 2.5, 6, 0, 100},
    FactorRow{"place_error_degrees", &H::placeErrorDegrees, 0.1, 0.2, 0.9, 0, 20},
    FactorRow{"turn_error_degrees", &H::turnErrorDegrees, 5, 8, 35, 0, 90},
    FactorRow{"reaction_seconds", &H::reactionSeconds, 0.03, 0.14, 0.3, 0.05, 2},
    FactorRow{"key_spread_seconds", &H::keySpread, 0.008, 0.012, 0.06, 0, 0.3},
    FactorRow{"mouse_share", &H::mouseShare, 0, kAny, kAny, 0, 1},
    FactorRow{"bits_per_second", &H::bitsPerSecond, 0.5, 3.2, 5.5, 0.5, 20},
    FactorRow{"click_seconds", &H::clickSeconds, 0.02, 0.08, 0.18, 0.02, 1},
    FactorRow{"hold_seconds", &H::holdSeconds, 0, kAny, kAny, 0.02, 0.5},
    FactorRow{"read_seconds", &H::readSeconds, 0.6, 1.2, 5, 0.1, 60},
    FactorRow{"decide_seconds", &H::decideSeconds, 0.2, 0.4, 1.6, 0.05, 20},
    FactorRow{"way_noise", &H::wayNoise, 0.05, 0.03, 0.35, 0, 2},
    FactorRow{"search_memory_seconds", &H::searchMemorySeconds, 12, 30, 100, 1, 3600},
    FactorRow{"forget_per_trial", &H::forgetPerTrial, 0.04, 0.01, 0.25, 0, 1},
    FactorRow{"forget_between_sessions", &H::forgetBetweenSessions, 0.12, 0.1, 0.8, 0, 1},
    FactorRow{"turn_lapse", &H::turnLapse, 0.03, 0.01, 0.18, 0, 1},
    FactorRow{"time_spread", &H::timeSpread, 0.03, 0.08, 0.25, 0, 1},
    FactorRow{"slip", &H::slip, 0, kAny, kAny, 0, 1},
    // These draw nothing, so that the subjects of a seed are who they were before there were such tasks.
    FactorRow{"length_error_share", &H::lengthErrorShare, 0, kAny, kAny, 0, 2},
    FactorRow{"pointing_error_degrees", &H::pointingErrorDegrees, 0, kAny, kAny, 0, 180},
};

}  // namespace

HumanFactors drawHumanFactors(uint64_t seed, const FactorMeans& means) {
  HumanFactors factors;
  factors.seed = seed;
  Random random(seedOf(seed, 0));
  for (const FactorRow& row : kFactorRows) {
    double& value = factors.*row.member;
    const double usual = value;
    if (row.deviation > 0) {
      value = normalWithin(random, usual, row.deviation, row.least, row.greatest);
    }
    if (const auto given = means.find(row.name); given != means.end()) {
      value = std::clamp(value * given->second / usual, row.lower, row.upper);
    }
    if (row.step > 0) {
      value = std::round(value / row.step) * row.step;
    }
  }
  factors.mouseShare = happens(random, factors.mouseShare) ? 1 : 0;
  return factors;
}

std::string jsonText(const HumanFactors& factors) {
  nlohmann::ordered_json json;
  for (const FactorRow& row : kFactorRows) {
    json[row.name] = factors.*row.member;
  }
  return json.dump();
}

FactorMeans readFactorMeans(const std::filesystem::path& file) {
  return readAs("docs/simulated_subjects.md", [&] {
    const JsonDocument document(readFile(file, kMaxTextBytes), file.string());
    JsonFields fields(document);
    FactorMeans means;
    for (const FactorRow& row : kFactorRows) {
      if (fields.has(row.name)) {
        means[row.name] = fields.number(row.name, row.lower, row.upper);
      }
    }
    fields.rejectUnknown();
    return means;
  });
}

}  // namespace ocelli
