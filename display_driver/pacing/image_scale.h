// How large reference images may be so that they are made in time: smaller ones as soon as time runs short, larger ones
// again when that has been possible for a while.
#pragma once

namespace ocelli {

class ImageScale {
 public:
  /// What is measured of making one may take `seconds`; scales are `minScale`, in (0, 1], to 1.
  ImageScale(double seconds, double minScale);

  /// Pixels each way, for each that were asked for.
  double next() const { return scale_; }
  /// What the last one took, which was made at `scale`. The first that is late makes the next one a step smaller, a
  /// second one soon after it as small as it has to be.
  void add(double scale, double seconds);

 private:
  double seconds_;
  double minScale_;
  double scale_ = 1;
  int inTime_ = 0;   ///< in a row, that would have been in time with the next larger scale
  int watched_ = 0;  ///< images until a late one is a hiccup again
};

}  // namespace ocelli
