// A walk through a sea of images, without a window: where one stands, where one looks, and the picture that is seen.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "oc_core/sea/sea_between.h"
#include "oc_core/sea/sea_cache.h"
#include "oc_core/sea/sea_file.h"

namespace ocelli {

class SeaVisit {
 public:
  /// Begins at the first image, and looks as its camera did. `sea` must outlive it; `woken` as SeaCache has it.
  explicit SeaVisit(const SeaFile& sea, std::function<void()> woken = {});

  const std::vector<glm::dvec3>& positions() const { return positions_; }
  /// From one image to the nearest other one, in the median.
  double spacing() const { return spacing_; }

  const glm::dvec3& place() const { return place_; }
  double yaw() const { return yaw_; }      ///< radians, to the left of -z
  double pitch() const { return pitch_; }  ///< upwards
  double fovVertical() const { return fovVertical_; }
  /// The one that is nearest.
  uint32_t nearest() const { return neighbors_.front().image; }
  const std::vector<SeaNeighbor>& neighbors() const { return neighbors_; }

  /// To a place; where that is farther from all images than three spacings, to the nearest one of these.
  void goTo(const glm::dvec3& place);
  void goToImage(uint32_t image) { goTo(positions_[image]); }
  /// Metres ahead and to the right of where one looks, level.
  void walk(double ahead, double right);
  void turn(double left, double up);
  void zoom(double steps);

  /// What is seen: the nearest images that are there, blended. With `waits` the nearest three are decoded first. Throws
  /// what decoding throws. Pixels are square.
  Image<Rgb8> picture(int width, int height, bool waits);
  /// Whether picture() would show something else than the last time, as far as decoding is.
  bool isComplete() const { return isComplete_; }

 private:
  struct ShownImage {
    uint32_t image = 0;
    double weight = 0;
    std::shared_ptr<const WarpReference> reference;
  };

  SeaCamera camera(int width, int height) const;

  const SeaFile& sea_;
  SeaDecoder decoder_;
  std::vector<glm::dvec3> positions_;
  std::vector<SeaPose> poses_;
  double spacing_ = 0;
  glm::dvec3 place_{0};
  double yaw_ = 0;
  double pitch_ = 0;
  double fovVertical_;
  std::vector<SeaNeighbor> neighbors_;
  SeaCache cache_;
  std::vector<ShownImage> shown_;
  bool isComplete_ = false;
};

}  // namespace ocelli
