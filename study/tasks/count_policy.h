// How a simulated observer counts objects: it looks at the views one after the other, and in each from left to right at
// what stands out. It counts what it has not counted there yet. Of an object elsewhere, in another view or where
// nothing was seen before, it must judge whether it is one that it has counted: by shape and colour, as far as it
// remembers them, and by where it seems to be. How sure it is of places follows from the picture around each thing
// (picture_perspective.h): from its scale, and from how differently two places are shown. Its eyes follow a few of the
// things that move. Where time runs out it guesses for what it has not looked at.
#pragma once

#include "study/agent/task_policy.h"

namespace ocelli {

class CountPolicy final : public TaskPolicy {
 public:
  CountPolicy(const Vision& vision, uint64_t seed) : vision_(vision), random_(seed) {}

  bool wantsFloor() const override { return false; }
  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override;
  /// The share of what was not looked at, and of judgements between views, for each object.
  double effort(double seconds) const override;

 private:
  /// Something that was counted.
  struct Item {
    LandmarkShape shape;
    LandmarkColor color;
    int view = 0;                                     ///< in which it was seen
    glm::dvec2 onScreen{0};                           ///< there, pixels, last
    int64_t at = 0;                                   ///< when
    glm::dvec2 place{0};                              ///< where in the maze that was, metres
    glm::dvec2 seemsAt{0};                            ///< where it seemed to be
    std::optional<PicturePerspective> perspective{};  ///< in which it was seen
    int64_t metAt = -1;                               ///< when something elsewhere was taken for it
    bool moves = false;                               ///< it was seen to
    int64_t attendedAt = 0;                           ///< when one last looked at it
    int64_t followedAt = -1;  ///< when the eyes followed it there without having taken it in yet
  };
  /// Where one has to look: a view, or a piece of a large one.
  struct Region {
    glm::dvec2 middle{0};
    bool looked = false;
  };

  void layOutRegions(const Percept& seen);
  double regionsLeft() const;
  void noteMotion(const Percept& seen);
  void followWithEyes(const Percept& seen, int64_t from);
  double attend(const Percept& seen, int64_t from);
  void count(const Sighting& sighting, int64_t from);
  bool isThere(const Item& item, const Sighting& sighting, int64_t from) const;
  Item itemOf(const Sighting& sighting, int64_t from);
  bool seemsSame(const Item& item, const Item& seen);
  bool placesMatch(const Item& item, const Item& seen);
  void lookOn(const Percept& seen, int64_t from);
  bool isAttended(const Sighting& sighting, int64_t from) const;
  void answer(const Percept& seen, int64_t now, MotorModel& motor);

  Vision vision_;
  Random random_;
  std::optional<glm::dvec2> gaze_{};
  std::vector<Region> regions_{};
  bool moves_ = false;   ///< something does
  bool sawAll_ = false;  ///< all regions were looked at
  std::vector<Sighting> before_{};
  std::vector<Item> items_{};
  std::vector<Item> passed_{};  ///< sightings that were taken for an item in another view
  int judgements_ = 0;
  int64_t answersAgainAt_ = 0;
};

}  // namespace ocelli
