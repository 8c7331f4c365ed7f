// Where subjects stand that are told by the blobs of feeds alone, and which frusta show a place (section 4.3.3): "The
// clipping planes which separate the PPC frusta are simulated by background subtraction. Deciding from which video feed
// to erase the subject is done based on the subject's location, which is inferred by triangulation between two or more
// cameras." A subject fades from one feed into the other "as the object traverses the separation plane".
//
// Each feed tells places of its own (body_peeling.h). Where two feeds see a subject from sides that differ, the
// crossing of both lines of sight, seen from above, tells its place better; else what is told more exactly counts for
// more. subject_tracks.h follows them from there.
#pragma once

#include <vector>

#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/feeds/feed_graph.h"

namespace ocelli {

struct SeenSubject {
  glm::dvec3 place{0};        ///< on the floor
  std::vector<size_t> feeds;  ///< that see it
  double error = 0;           ///< of the place, metres, about
};

/// The subjects that blobs of all feeds stand for. `known` is empty, or has one image a feed: cells that are not 0 are
/// those of subjects that need not be found again.
std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs,
                                        const std::vector<const Image<uint16_t>*>& known = {});

/// How much a frustum shows of what stands at a place, 0 to 1: 1 where the place is beyond its near face and those of
/// its parents, and before those of its children; in between where it fades across one.
double shareShown(const FeedGraph& graph, size_t frustum, const glm::dvec3& place);
/// How far in the frustum it is, 0 to 1: 1 beyond its near face and those of its parents. The rays of a frustum that
/// pass no later near face show all of that.
double shareEntered(const FeedGraph& graph, size_t frustum, const glm::dvec3& place);

}  // namespace ocelli
