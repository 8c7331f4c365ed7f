// How feeds last saw each subject. Who stands in a frustum behind somebody that is erased from it would vanish with
// him: background takes the place of both. Such a subject is shown as it was seen last instead, by the same feed or,
// where that never saw it, by another one, moved to where it is now. Like the background, that is no live picture.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "oc_core/feeds/subject_tracks.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// How a feed saw a subject of which nobody hid much.
struct SubjectPortrait {
  size_t feed = 0;
  double seconds = 0;    ///< in the time of the place, here and below
  glm::ivec2 corner{0};  ///< feed pixels, the top left of its cells
  Image<uint8_t> cells;  ///< of the mask: 1 where it is seen
  int scale = 2;         ///< feed pixels a cell
  Image<Rgb8> pixels;    ///< of the feed
  glm::dvec3 light{1};   ///< of the frame, against that of the background, per channel
  glm::dvec2 middle{0};  ///< feed pixels, of the middle of the body
  double pixelsPerMetre = 1;
};

/// Those of one feed.
class SubjectPortraits {
 public:
  /// `graph` outlives it.
  SubjectPortraits(const FeedGraph& graph, size_t feed) : graph_(graph), feed_(feed) {}

  /// Looks at a frame, in which `tracks` has just told who is who. `light` is that of the frame, against the
  /// background.
  void look(const SubjectTracks& tracks, const Image<Rgb8>& frame, const glm::dvec3& light, double seconds);
  /// Null where there is none.
  const SubjectPortrait* of(uint64_t subject) const;

 private:
  const FeedGraph& graph_;
  size_t feed_;
  std::map<uint64_t, SubjectPortrait> portraits_;  ///< by the numbers of subjects
};

/// A pixel of a portrait.
struct PortraitPixel {
  size_t feed = 0;
  double seconds = 0;
  glm::ivec2 pixel{0};  ///< of the feed, then
};

/// Who stands in a frustum and is hidden, as portraits show them.
class HiddenSubjects {
 public:
  HiddenSubjects(const FeedGraph& graph, size_t frustum) : graph_(graph), frustum_(frustum) {}

  /// Finds them. `portraits` are those of all feeds, and stay as they are until the next update.
  void update(const SubjectTracks& tracks, const std::vector<SubjectPortraits>& portraits, double seconds);

  /// `background` with them in it; itself where there are none.
  const Image<Rgb8>& in(const Image<Rgb8>& background);
  /// What is shown of them at a pixel of the feed; nothing where the background is.
  std::optional<PortraitPixel> at(const glm::ivec2& pixel) const;

 private:
  /// A portrait where its subject is now.
  struct Shown {
    const SubjectPortrait* portrait;
    glm::dvec2 middle;  ///< feed pixels
    double ratio;       ///< pixels of the portrait a pixel
    double distance;    ///< metres from the camera of the frustum
    glm::ivec2 lower;   ///< its box in the feed
    glm::ivec2 upper;

    /// The pixel of the portrait.
    std::optional<glm::ivec2> source(const glm::ivec2& pixel) const;
  };

  void show(const SubjectPortrait& portrait, const glm::dvec2& middle, double pixelsPerMetre, double distance);

  const FeedGraph& graph_;
  size_t frustum_;
  std::vector<Shown> shown_;  ///< the farthest first
  Image<Rgb8> image_;
};

}  // namespace ocelli
