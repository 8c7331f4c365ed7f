// How deep an image is split between the perspectives of a maze camera, averaged over frames (section 4.3.1.4): "Since
// the visibility of split lines can change abruptly from frame to frame, the depth of each split is averaged over 30
// frames."
//
// A split is told from others by its name, which must stay the same from frame to frame. What its depth is a length of
// (pixels of the cut, metres along a wall) is the caller's matter; 0 is no split at all. The mean is over the last
// frames, those before the first one left out. A frame without a split counts as one of depth 0, so a split that comes
// up opens from 0 on, and one that comes back after a while goes on from what is left of it. So from frame to frame the
// mean changes by at most the range of the depths over the number of frames, but in the first frames.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace ocelli {

struct SplitDepth {
  std::string name;
  double depth = 0;  ///< finite; in the caller's unit

  bool operator==(const SplitDepth&) const = default;
};

/// The state that whoever draws frame after frame keeps, one for each camera.
class SplitDepths {
 public:
  static constexpr size_t kUsualFrames = 30;

  /// `frames` is at least 1; 1 averages nothing.
  explicit SplitDepths(size_t frames = kUsualFrames);

  /// Takes the depths of the next frame, each name at most once, and returns their means, in the same order. A split
  /// of depth 0 may be named or not.
  std::vector<SplitDepth> next(std::span<const SplitDepth> depths);

  /// The mean of the last frames; 0 for a split that none of them had.
  double depth(const std::string& name) const;

  /// Forgets all frames, as after a jump of the eye: the next one is the first.
  void clear();

 private:
  size_t frames_;
  std::deque<std::map<std::string, double>> last_;  ///< at most frames_, the latest at the back
};

}  // namespace ocelli
