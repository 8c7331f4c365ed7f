#include "study/agent/human_factors.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/agent/chance.h"

namespace ocelli {

HumanFactors drawHumanFactors(uint64_t seed) {
  HumanFactors factors;
  factors.seed = seed;
  Random random(seedOf(seed, 0));
  const auto draw = [&](double& value, double deviation, double least, double most) {
    value = normalWithin(random, value, deviation, least, most);
  };
  draw(factors.fixationSeconds, 0.03, 0.22, 0.38);
  draw(factors.usefulFieldDegrees, 1.5, 9, 16);
  draw(factors.noticedDegrees, 0.03, 0.08, 0.3);
  draw(factors.doublingDegrees, 0.5, 2, 4);
  draw(factors.noticeSeconds, 0.04, 0.1, 0.35);
  draw(factors.itemSeconds, 0.04, 0.22, 0.4);
  draw(factors.groupSeconds, 0.015, 0.04, 0.1);
  factors.groupItems = happens(random, 0.5) ? 4 : 3;
  draw(factors.workingMemoryItems, 0.8, 2.5, 6);
  draw(factors.placeErrorMeters, 0.1, 0.2, 0.9);
  draw(factors.crossViewErrorMeters, 0.8, 1, 5);
  draw(factors.reactionSeconds, 0.03, 0.14, 0.3);
  draw(factors.keySpread, 0.008, 0.012, 0.06);
  factors.turnsByMouse = happens(random, 0.8);
  draw(factors.bitsPerSecond, 0.5, 3.2, 5.5);
  draw(factors.clickSeconds, 0.02, 0.08, 0.18);
  draw(factors.readSeconds, 0.6, 1.2, 5);
  draw(factors.decideSeconds, 0.2, 0.4, 1.6);
  draw(factors.wayNoise, 0.05, 0.03, 0.35);
  draw(factors.searchMemorySeconds, 12, 30, 100);
  draw(factors.forgetPerTrial, 0.04, 0.01, 0.25);
  draw(factors.forgetBetweenSessions, 0.12, 0.1, 0.8);
  draw(factors.turnLapse, 0.03, 0.01, 0.18);
  draw(factors.timeSpread, 0.03, 0.08, 0.25);
  return factors;
}

std::string jsonText(const HumanFactors& f) {
  const nlohmann::ordered_json json{{"fixation_seconds", f.fixationSeconds},
                                    {"fixation_spread_seconds", f.fixationSpread},
                                    {"saccade_seconds", f.saccadeSeconds},
                                    {"useful_field_degrees", f.usefulFieldDegrees},
                                    {"noticed_degrees", f.noticedDegrees},
                                    {"doubling_degrees", f.doublingDegrees},
                                    {"notice_seconds", f.noticeSeconds},
                                    {"least_floor_degrees", f.minFloorDegrees},
                                    {"item_seconds", f.itemSeconds},
                                    {"group_seconds", f.groupSeconds},
                                    {"group_items", f.groupItems},
                                    {"group_radius_degrees", f.groupRadiusDegrees},
                                    {"working_memory_items", f.workingMemoryItems},
                                    {"place_error_meters", f.placeErrorMeters},
                                    {"cross_view_error_meters", f.crossViewErrorMeters},
                                    {"reaction_seconds", f.reactionSeconds},
                                    {"key_spread_seconds", f.keySpread},
                                    {"turns_by_mouse", f.turnsByMouse},
                                    {"bits_per_second", f.bitsPerSecond},
                                    {"click_seconds", f.clickSeconds},
                                    {"hold_seconds", f.holdSeconds},
                                    {"read_seconds", f.readSeconds},
                                    {"decide_seconds", f.decideSeconds},
                                    {"way_noise", f.wayNoise},
                                    {"search_memory_seconds", f.searchMemorySeconds},
                                    {"forget_per_trial", f.forgetPerTrial},
                                    {"forget_between_sessions", f.forgetBetweenSessions},
                                    {"turn_lapse", f.turnLapse},
                                    {"time_spread", f.timeSpread},
                                    {"slip", f.slip}};
  return json.dump();
}

}  // namespace ocelli
