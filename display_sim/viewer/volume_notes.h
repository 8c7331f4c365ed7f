// What the volume pane says in words.
#pragma once

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// For the header: "di, 640 x 427".
std::string volumeDetail(const ViewerState& state, const VolumeStatus& status);
/// What the pane says, from the longest to the shortest form.
std::vector<std::string> volumeNotes(const ViewerFacts& facts);

}  // namespace ocelli
