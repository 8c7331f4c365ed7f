#include "oc_core/feeds/subject_tracks.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace ocelli {
namespace {

constexpr double kMaxHiddenSeconds = 2.5;
constexpr double kTrackReach = 0.8;      ///< metres between where a subject would be and where it is told
constexpr double kMaxWalkSpeed = 3;      ///< metres a second
constexpr double kVelocityMemory = 0.4;  ///< seconds over which velocities are averaged

}  // namespace

std::vector<SeenSubject> SubjectTracks::update(const std::vector<SeenSubject>& told, double seconds) {
  std::vector<SeenSubject> subjects = told;
  std::vector<bool> isTaken(told.size(), false);
  std::vector<Track> next;
  for (const Track& track : tracks_) {
    const double hidden = seconds - track.seenAt;
    if (hidden > kMaxHiddenSeconds) {
      continue;
    }
    const glm::dvec3 expected = track.place + track.velocity * hidden;
    size_t best = told.size();
    double least = kTrackReach;
    for (size_t i = 0; i < told.size(); ++i) {
      const double away = glm::length(told[i].place - expected);
      if (!isTaken[i] && away < least) {
        least = away;
        best = i;
      }
    }
    if (best == told.size()) {
      next.push_back(track);
      subjects.push_back({expected, {}});
      continue;
    }
    isTaken[best] = true;
    const double share = std::min(1.0, hidden / kVelocityMemory);
    const glm::dvec3 moved = hidden > 0 ? (told[best].place - track.place) / hidden : track.velocity;
    glm::dvec3 velocity = track.velocity + (moved - track.velocity) * share;
    if (const double speed = glm::length(velocity); speed > kMaxWalkSpeed) {
      velocity *= kMaxWalkSpeed / speed;
    }
    next.push_back({told[best].place, velocity, seconds});
  }
  for (size_t i = 0; i < told.size(); ++i) {
    if (!isTaken[i]) {
      next.push_back({told[i].place, glm::dvec3(0), seconds});
    }
  }
  tracks_ = std::move(next);
  return subjects;
}

}  // namespace ocelli
