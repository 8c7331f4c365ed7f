// Where subjects stand, from the blobs that they are in the feeds, and so which feeds show them (section 4.3.3): "The
// clipping planes which separate the PPC frusta are simulated by background subtraction. Deciding from which video feed
// to erase the subject is done based on the subject's location, which is inferred by triangulation between two or more
// cameras." A subject fades from one feed into the other "as the object traverses the separation plane".
//
// Each feed tells places of its own (body_peeling.h). Where two feeds see a subject from sides that differ, the
// crossing of both lines of sight, seen from above, tells its place better; else what is told more exactly counts for
// more. A pixel of a blob shows the nearest body that fills it, as the feed sees these.
#pragma once

#include <cstdint>
#include <optional>
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

/// Where a feed alone would place a subject. From there it looks as the feed sees it.
struct FeedTold {
  size_t feed = 0;
  glm::dvec3 place{0};
};

struct SeenSubject {
  glm::dvec3 place{0};         ///< on the floor
  std::vector<FeedTold> told;  ///< by feeds that see it
  double error = 0;            ///< of the place, metres, about
};

/// The subjects that blobs of all feeds stand for. `blobs` has one entry a feed of the setup.
std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs);

/// In [0, 1]: how much of a body at a place is no background in the feeds of the frusta that show it, by the one that
/// says least; nothing where they see less than half of it.
std::optional<double> shareSeen(const FeedGraph& graph, const std::vector<FeedBlobs>& blobs, const glm::dvec3& place);

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
