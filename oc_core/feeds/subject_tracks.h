// Subjects from frame to frame: one that is hidden for a while by another goes on as it walked.
#pragma once

#include <vector>

#include "oc_core/feeds/subject_places.h"

namespace ocelli {

class SubjectTracks {
 public:
  /// The subjects that are told now, and those that were told a short time ago, where they would be now; these have no
  /// feeds. `seconds` grows from call to call.
  std::vector<SeenSubject> update(const std::vector<SeenSubject>& told, double seconds);

 private:
  struct Track {
    glm::dvec3 place{0};
    glm::dvec3 velocity{0};  ///< metres a second
    double seenAt = 0;       ///< seconds
  };
  std::vector<Track> tracks_;
};

}  // namespace ocelli
