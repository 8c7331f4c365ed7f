// What one frame of a feed tells of where a subject is: its middle, across the line of sight; its feet on the floor and
// the top of its head, along it.
#pragma once

#include <optional>

#include "oc_core/feeds/subject_cells.h"
#include "oc_core/feeds/subject_motion.h"

namespace ocelli {

/// Whether enough is seen of a body to say that it is there.
bool isSeen(const BodySight& sight);

/// Tells `motion` what a feed sees of a body; nothing where it hardly sees it. `height` is the subject's, metres.
/// Returns how high it seems to be, where its place is known well and its head is seen.
std::optional<double> tellPlace(const FeedSetup& setup, size_t feed, const ExpectedBody& body, const BodySight& sight,
                                double height, SubjectMotion& motion);

}  // namespace ocelli
