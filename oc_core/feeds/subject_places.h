// Where subjects stand, from the blobs that they are in the feeds, and so which feeds show them (section 4.3.3): "The
// clipping planes which separate the PPC frusta are simulated by background subtraction. Deciding from which video feed
// to erase the subject is done based on the subject's location, which is inferred by triangulation between two or more
// cameras." A subject fades from one feed into the other "as the object traverses the separation plane".
//
// The lowest point of a blob is where its subject stands on the floor. Where two feeds see a subject from sides that
// differ, the crossing of both lines of sight, seen from above, tells its place better; else the nearer camera counts
// for more. Blobs whose feet are out of the image take the place of a subject whose body, as that camera sees it,
// covers them.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/feeds/feed_graph.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// One connected region of a feed that is not its background. Feed pixels.
struct SubjectBlob {
  glm::dvec2 lower{0};  ///< its box: the top left corner
  glm::dvec2 upper{0};
  glm::dvec2 foot{0};       ///< the middle of its lowest row
  bool isCutBelow = false;  ///< reaches the lower border of the image, so that its feet may be out of it
};

/// The subjects of one frame of a feed. A pixel of the masks is kMaskScale pixels of the feed a side; 0 is background,
/// k is blob k - 1.
struct FeedBlobs {
  static constexpr int kMaskScale = 2;

  std::vector<SubjectBlob> blobs;
  Image<uint16_t> core;  ///< what surely is a subject
  Image<uint16_t> wide;  ///< with its blurred rim: what is erased
};

struct SeenSubject {
  glm::dvec3 place{0};        ///< on the floor
  std::vector<size_t> feeds;  ///< that told it
};

/// The subjects that blobs of all feeds stand for. `blobs` has one entry a feed of the setup.
std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs);

/// In [0, 1]: how much of a subject at a place a frustum shows: 1 within it, 0 outside, and between these over the
/// width in which subjects fade around a near face. Where a subject passes from a frustum to its child both add up
/// to 1.
double shareShown(const FeedGraph& graph, size_t frustum, const glm::dvec3& place);

/// What becomes of the pixels of a mask, 255 is all: how much background stands for them, and how much of them is shown
/// where the picture shows a later frustum.
struct FeedMark {
  uint8_t erased = 0;
  uint8_t shown = 0;

  bool operator==(const FeedMark&) const = default;
};

/// The marks of the feed of a frustum.
Image<FeedMark> markSubjects(const FeedGraph& graph, size_t frustum, const FeedBlobs& blobs,
                             const std::vector<SeenSubject>& subjects);

}  // namespace ocelli
