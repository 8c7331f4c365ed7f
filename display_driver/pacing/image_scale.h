// How large reference images may be so that they are made in time: small at first and larger with each one until the
// first that is late; from then on smaller ones as soon as time runs short, larger ones again when there is room.
#pragma once

#include "display_driver/pacing/stage_times.h"

namespace ocelli {

class ImageScale {
 public:
  /// What is measured of making one may take `seconds`; scales are `minScale`, in (0, 1], to 1.
  ImageScale(double seconds, double minScale);

  /// Pixels each way, for each that were asked for.
  double next() const { return scale_; }
  /// What the last one took, which was made at `scale`. One late image is a hiccup; after a second one soon after it
  /// the next are as small as they have to be.
  void add(double scale, double seconds);

 private:
  void shrink(double scale, double seconds);
  void grow();

  double seconds_;
  double minScale_;
  double scale_;
  bool starting_ = true;  ///< none was late so far
  StageTimes times_;      ///< of those at this scale
  int inTime_ = 0;        ///< of these
  int watched_ = 0;       ///< images until a late one is a hiccup again
  int patience_;          ///< images in time before the next step up
};

}  // namespace ocelli
