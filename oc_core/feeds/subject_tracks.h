// Subjects from frame to frame: one that is hidden by another goes on as it walked, as long as the feed that would show
// it sees no background there.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oc_core/feeds/subject_places.h"

namespace ocelli {

class SubjectTracks {
 public:
  /// How much of a body at a place is no background; nothing where that is not known.
  using ShareSeen = std::function<std::optional<double>(const glm::dvec3&)>;

  /// The subjects that are told now, and those that were told before, where they would be now; these have no feeds.
  /// `seconds` grows from call to call.
  std::vector<SeenSubject> update(const std::vector<SeenSubject>& told, const ShareSeen& shareSeen, double seconds);

 private:
  struct Track {
    glm::dvec3 place{0};
    glm::dvec3 velocity{0};  ///< metres a second
    double toldAt = 0;       ///< seconds
    double seenAt = 0;       ///< when somebody was told or seen there
    double ageSeconds = 0;   ///< between the first and the last time that it was told
  };

  static Track movedTo(const Track& track, const glm::dvec3& place, double seconds);
  static bool goesOn(Track& track, const std::optional<double>& shareSeen, double seconds);

  std::vector<Track> tracks_;
};

}  // namespace ocelli
