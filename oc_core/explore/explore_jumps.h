// How much a picture changes from one frame to the next, beside what the pinhole's does: no constructor may make it
// jump (section 4.3.1).
//
// A frame jumps where its picture changes by more than the pinhole's picture would, with the same step of the walker or
// with a turn at full speed for a frame, whichever is more: where the walker stands still, a camera may deploy as fast
// as people look around. The turn is that which changes most of those from eight headings at the walker's place (or at
// one at most half a metre away, as they take long). Changes are means of absolute differences of sRGB bytes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/explore/explore_renderer.h"
#include "oc_core/explore/explorer.h"

namespace ocelli {

/// The mean absolute difference of the bytes of two images of one size, 0 to 255.
double imageChange(const Image<Rgb8>& one, const Image<Rgb8>& other);

struct FrameChange {
  int frame = 0;
  double picture = 0;  ///< from the frame before
  double pinhole = 0;  ///< of the pinhole's picture, with the same step
  double turn = 0;     ///< of the pinhole's picture, with a turn of a frame, whatever way it looks

  double allowed() const { return pinhole > turn ? pinhole : turn; }
  bool jumps() const { return picture > allowed(); }
};

/// A table, a line a frame: frame,image,pinhole,turn,jumps.
std::string csvOf(const std::vector<FrameChange>& changes);

/// The images of the frame with the greatest share of what is allowed, and of that before it.
struct WorstFrame {
  FrameChange change;
  Image<Rgb8> before;
  Image<Rgb8> after;

  /// Black where both are the same.
  Image<Rgb8> difference() const;
};

/// Watches the frames of a session, each once, in their order.
class JumpMeasure {
 public:
  explicit JumpMeasure(const ExploreScene& scene) : renderer_(scene), scene_(scene) {}

  /// `picture` is that of the frame; `turnDegrees` is how far one turns in a frame.
  void add(const ExploreFrame& frame, const Image<Rgb8>& picture, double fovHorizontalDegrees, double turnDegrees);
  /// A place that one jumps to: the next frame has none before it.
  void cut() { last_.reset(); }

  const std::vector<FrameChange>& changes() const { return changes_; }
  /// Nothing where there is no frame with one before it.
  const std::optional<WorstFrame>& worst() const { return worst_; }

 private:
  struct Last {
    Image<Rgb8> picture;
    Image<Rgb8> pinhole;
    double turn = 0;
  };
  double turnAt(const ExploreFrame& frame, double fovHorizontalDegrees, double turnDegrees);

  ExploreRenderer renderer_;
  const ExploreScene& scene_;
  std::optional<Last> last_;
  struct Place {
    glm::dvec3 eye{0};
    double turn = 0;
  };
  std::optional<Place> place_;
  std::vector<FrameChange> changes_;
  std::optional<WorstFrame> worst_;
};

}  // namespace ocelli
