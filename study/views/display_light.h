// The light that a display sends to an eye before it, and whose objects' it is. The display holds a part of a scene, or
// a representation that is made of that part as from outside of the display: what is around in the scene, such as walls
// between the eye and the display, hides nothing, and neither does what is in it.
#pragma once

#include <optional>
#include <vector>

#include "display_sim/frames/volume.h"
#include "oc_core/scene/mesh.h"
#include "study/task/trial_layout.h"
#include "study/views/display_options.h"
#include "study/views/shown_objects.h"

namespace ocelli {

class DisplayLight {
 public:
  /// Keeps what is in the display of the mesh of the layout. `camera` is where the eye rests, with the size of the
  /// image. `options` must outlive it.
  DisplayLight(const DisplayViewOptions& options, const TrialLayout& layout, const PinholeCamera& camera);

  struct Seen {
    Image<glm::vec3> light;   ///< linear, without a gain
    Image<uint32_t> objects;  ///< of the object that gives half of a pixel's light or more; else nothing
  };
  Seen at(size_t pose);
  /// The gain of all poses.
  double gain();

 private:
  /// What the display shows: of all, then of each object.
  using Volumes = std::vector<std::optional<Volume>>;
  Volumes volumesMadeAt(const glm::vec3& eye) const;
  Mesh representationMadeAt(const glm::vec3& eye) const;
  const Volumes& volumesAt(size_t pose);
  Image<glm::vec3> lightOf(const std::optional<Volume>& volume, const glm::vec3& eye) const;
  glm::vec3 eyeAt(size_t pose) const { return options_.head.eyeOf(pose, rest_); }
  bool isForEach() const { return options_.camera && options_.head.moves() && options_.madeAt == MadeAt::kEach; }

  const DisplayViewOptions& options_;
  Mesh mesh_{};                     ///< of the scene, in the display's coordinates, as eyes are
  std::vector<uint32_t> objectOf_;  ///< of each of its triangles
  size_t objectCount_;
  ShownObjects objects_;
  PinholeCamera camera_;
  DisplayFrame frame_;
  glm::vec3 rest_;
  std::optional<Volumes> volumes_{};  ///< made where the eye rests, or at the pose below
  size_t madeAt_ = 0;
};

/// The gain with which the pixels of an image send, on average, that share of the luminance of white: what exceeds
/// white is cut off. Where that is more than the lit pixels can send, the gain that takes the mean to 99 % of what they
/// can.
double gainForMean(const Image<glm::vec3>& light, double mean);

}  // namespace ocelli
