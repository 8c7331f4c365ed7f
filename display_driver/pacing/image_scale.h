// How large reference images may be so that they are made in time: smaller ones as soon as time runs short, larger ones
// again when that has been possible for a while.
#pragma once

namespace ocelli {

class ImageScale {
 public:
  /// Each stage of making one may take `stageSeconds`; scales are `minScale`, in (0, 1], to 1.
  ImageScale(double stageSeconds, double minScale);

  /// Pixels each way, for each that were asked for.
  double next() const { return scale_; }
  /// What the longest stage of the last one took, which was made at `scale`.
  void add(double scale, double longestStageSeconds);

 private:
  double stageSeconds_;
  double minScale_;
  double scale_ = 1;
  int inTime_ = 0;  ///< in a row, that would have been in time with the next larger scale
};

}  // namespace ocelli
