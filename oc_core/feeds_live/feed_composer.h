// From the last frame of each feed to the image of the graph camera: backgrounds, subjects, places, image.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/feeds/feed_compose.h"
#include "oc_core/feeds/subject_memory.h"
#include "oc_core/feeds/subject_tracks.h"
#include "oc_core/feeds_background/feed_background.h"

namespace ocelli {

class FeedComposer {
 public:
  /// Reads the backgrounds that the setup names. Throws InputError where one is no image of the size of its feed.
  explicit FeedComposer(const FeedGraph& graph, const FeedBackgroundOptions& options = {});
  /// Whether subjects that are hidden by who is erased are shown as they were (subject_memory.h); by default they are.
  void setShowsHidden(bool showsHidden) { showsHidden_ = showsHidden; }
  FeedComposer(const FeedComposer&) = delete;
  FeedComposer& operator=(const FeedComposer&) = delete;

  const FeedGraph& graph() const { return graph_; }
  const FeedMap& map() const { return map_; }

  /// Whether what the feed shows from now on is old: those in it are nowhere, and are erased from its picture.
  void setStale(size_t feed, bool isStale) { isStale_[feed] = isStale; }
  /// Takes frames for feeds, by index; empty ones stand for no new frame, as do those of feeds that are stale, which
  /// would become background. Works on all cores.
  void take(std::vector<Image<Rgb8>>& frames);
  /// Sets `image` to what the feeds show at `seconds`, which grow from call to call. All have the mean of their lights,
  /// so that exposures of their own make no seams.
  void compose(double seconds, ErasedLook erased, Image<Rgb8>& image);

  /// Of the last call of compose().
  const SubjectTracks& subjects() const { return tracks_; }
  const FeedMarks& marks(size_t frustum) const { return marks_[frustum]; }
  const HiddenSubjects& hidden(size_t frustum) const { return hidden_[frustum]; }
  /// The last frame of a feed, by index; empty where there is none yet.
  const Image<Rgb8>& frame(size_t feed) const { return frames_[feed]; }
  /// Whether what a feed shows is hardly anything of the place.
  bool isCovered(size_t feed) const { return backgrounds_[feed]->isCovered(); }
  bool hasFrame(size_t feed) const { return !frames_[feed].empty(); }

 private:
  glm::dvec3 commonLight() const;

  FeedGraph graph_;
  FeedMap map_;
  std::vector<std::unique_ptr<FeedBackground>> backgrounds_;  ///< of each feed
  std::vector<Image<Rgb8>> frames_;
  std::vector<char> isStale_;
  std::vector<FeedBlobs> blobs_;
  SubjectTracks tracks_;
  std::vector<FeedMarks> marks_;  ///< of each frustum, as the next ones
  std::vector<HiddenSubjects> hidden_;
  std::vector<SubjectPortraits> portraits_;  ///< of each feed
  bool showsHidden_ = true;
};

}  // namespace ocelli
