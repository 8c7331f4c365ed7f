// Subjects from frame to frame: where each is, how it walks, what it looks like, and so which cells of which feed show
// it. One that is hidden by another goes on as it walked, as long as the feed that would show it sees no background
// there. One that comes out elsewhere is found anew, and recognized by its colours.
//
// Each frame: subjects go on to where they should be; each feed tells which of its cells show whom (subject_cells.h);
// feet, heads and middles of what is seen tell places (subject_motion.h); and bodies in what is left of the blobs are
// new subjects (subject_places.h).
#pragma once

#include <vector>

#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds/subject_cells.h"
#include "oc_core/feeds/subject_motion.h"

namespace ocelli {

class SubjectTracks {
 public:
  /// `graph` outlives them.
  explicit SubjectTracks(const FeedGraph& graph);

  /// `blobs` has one entry a feed of the setup. `seconds` grows from call to call.
  void update(const std::vector<FeedBlobs>& blobs, double seconds);

  size_t count() const { return tracks_.size(); }
  /// On the floor.
  glm::dvec3 place(size_t subject) const;
  /// That no other subject has or had.
  uint64_t number(size_t subject) const { return tracks_[subject].number; }
  double height(size_t subject) const { return tracks_[subject].height; }  ///< metres
  /// What a feed sees of a subject; null where it has no blobs, or the subject is out of its image or new.
  const BodySight* sight(size_t feed, size_t subject) const;
  /// What the cells of a feed show; empty where it has no blobs.
  const SubjectCells& cells(size_t feed) const { return cells_[feed]; }

 private:
  struct Track {
    uint64_t number;
    SubjectMotion motion;
    double height;
    std::vector<SubjectColors> colors;  ///< by feed; then of all together
    double foundAt = 0;                 ///< seconds
    double toldAt = 0;                  ///< seconds: when a feed last saw it
    double expectedAt = 0;              ///< when last the feed that would show it did not miss it
    bool isHidden = false;              ///< from the feed that would show it
    bool isRecognized = false;          ///< a newer one has turned out to be this one
  };

  void tellCellsOf(const std::vector<FeedBlobs>& blobs);
  void tellPlaces();
  void learnColors();
  void judge();
  void recognize();
  /// The one that is not seen where it should be, and may be that new one; null where there is none.
  Track* lostLike(const Track& found);
  bool goesOn(const Track& track) const;
  void forget();
  /// After some were forgotten: `numbers` has for each old index plus 1 the new one plus 1.
  void renumber(const std::vector<uint16_t>& numbers);
  void addNew(const std::vector<FeedBlobs>& blobs);

  const FeedGraph& graph_;
  std::vector<Track> tracks_;
  std::vector<std::vector<ExpectedBody>> bodies_;  ///< by feed
  std::vector<SubjectCells> cells_;
  double seconds_ = 0;
  uint64_t nextNumber_ = 0;
};

}  // namespace ocelli
