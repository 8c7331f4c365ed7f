#include "oc_core/feeds/subject_tracks.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr double kMaxUnseenSeconds = 0.3;
constexpr double kMaxHiddenSeconds = 3;  ///< while the feed that would show it sees somebody
constexpr double kMaxUnknownSeconds = 2.5;
constexpr double kMinSeenShare = 0.5;    ///< of a body, so that somebody is there
constexpr double kTrackReach = 0.8;      ///< metres between where a subject would be and where it is told
constexpr double kExactError = 0.3;      ///< metres: what is told so exactly is taken as it is
constexpr double kMinNewShare = 0.1;     ///< of what is told less exactly
constexpr double kMaxWalkSpeed = 3;      ///< metres a second
constexpr double kVelocityMemory = 0.4;  ///< seconds over which velocities are averaged
constexpr double kSureSeconds = 0.5;     ///< a subject told for less may be none

struct Match {
  size_t track = 0;
  size_t told = 0;
  double away = 0;
};

}  // namespace

std::vector<SeenSubject> SubjectTracks::update(const std::vector<SeenSubject>& told, const ShareSeen& shareSeen,
                                               double seconds) {
  std::vector<glm::dvec3> expected;
  std::vector<Match> matches;
  for (size_t k = 0; k < tracks_.size(); ++k) {
    expected.push_back(tracks_[k].place + tracks_[k].velocity * (seconds - tracks_[k].toldAt));
    for (size_t i = 0; i < told.size(); ++i) {
      if (const double away = glm::length(told[i].place - expected[k]); away < kTrackReach + told[i].error) {
        matches.push_back({k, i, away / (kTrackReach + told[i].error)});
      }
    }
  }
  std::sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.away < b.away; });
  std::vector<size_t> toldOfTrack(tracks_.size(), told.size());
  std::vector<bool> isTaken(told.size(), false);
  for (const Match& match : matches) {
    if (toldOfTrack[match.track] == told.size() && !isTaken[match.told]) {
      toldOfTrack[match.track] = match.told;
      isTaken[match.told] = true;
    }
  }
  std::vector<SeenSubject> subjects = told;
  std::vector<Track> next;
  for (size_t k = 0; k < tracks_.size(); ++k) {
    Track track = tracks_[k];
    if (toldOfTrack[k] < told.size()) {
      SeenSubject& subject = subjects[toldOfTrack[k]];
      const double share = std::clamp(kExactError / std::max(subject.error, kExactError), kMinNewShare, 1.0);
      subject.place = expected[k] + (subject.place - expected[k]) * share;
      next.push_back(movedTo(track, subject.place, seconds));
    } else if (goesOn(track, shareSeen(expected[k]), seconds)) {
      next.push_back(track);
      subjects.push_back({expected[k], {}});
    }
  }
  for (size_t i = 0; i < told.size(); ++i) {
    if (!isTaken[i]) {
      next.push_back({told[i].place, glm::dvec3(0), seconds, seconds, 0});
    }
  }
  tracks_ = std::move(next);
  return subjects;
}

SubjectTracks::Track SubjectTracks::movedTo(const Track& track, const glm::dvec3& place, double seconds) {
  const double since = seconds - track.toldAt;
  const glm::dvec3 moved = since > 0 ? (place - track.place) / since : track.velocity;
  glm::dvec3 velocity = track.velocity + (moved - track.velocity) * std::min(1.0, since / kVelocityMemory);
  if (const double speed = glm::length(velocity); speed > kMaxWalkSpeed) {
    velocity *= kMaxWalkSpeed / speed;
  }
  return {place, velocity, seconds, seconds, track.ageSeconds + since};
}

bool SubjectTracks::goesOn(Track& track, const std::optional<double>& shareSeen, double seconds) {
  const bool isSeen = shareSeen.value_or(0) >= kMinSeenShare;
  if (isSeen && track.ageSeconds >= kSureSeconds) {
    track.seenAt = seconds;
  }
  const double maxUnseen = shareSeen ? kMaxUnseenSeconds : kMaxUnknownSeconds;
  return seconds - track.seenAt <= maxUnseen && seconds - track.toldAt <= kMaxHiddenSeconds;
}

}  // namespace ocelli
