// A scene as an occlusion camera sees it from where the viewer's eye is, sliced anew whenever the eye has moved.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/pacing/eye_feed.h"
#include "display_driver/pacing/stage_times.h"
#include "display_driver/pacing/volume_source.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct EyesOptions {
  CameraChoice camera;
  int width = 720;
  int height = 480;
  SliceOptions slicing;
};

class EyesSource final : public VolumeSource {
 public:
  /// `mesh` is validated, its positions in display radii. The feed outlives the source. Throws InputError for a camera
  /// without images.
  EyesSource(const Mesh& mesh, const DisplayProfile& profile, EyesOptions options, EyeFeed& feed);
  ~EyesSource() override;

  /// Ends where the feed has ended and its last place has been shown. Eyes from which the scene cannot be seen (inside
  /// of it, or of the display) are left out, and the last volume stays.
  SourcedVolume volumeFor(HostTime seen) override;

  /// Whether anybody ever said where the eye is.
  bool eyeCame() const { return eye_.has_value(); }
  uint64_t eyesLeftOut() const { return leftOut_; }
  /// Why, for the first one; for people.
  const std::string& firstLeftOut() const { return firstLeftOut_; }

  struct Stage {
    const char* name = "";
    StageTimes times;
  };
  /// Of the last frames: building the reference image, its mesh, slicing.
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  SourcedVolume leaveOut(const std::string& why);

  const Mesh& mesh_;
  EyesOptions options_;
  EyeFeed& feed_;
  Slicer slicer_;
  std::optional<glm::vec3> eye_;
  std::vector<Stage> stages_;
  uint64_t leftOut_ = 0;
  std::string firstLeftOut_;
};

}  // namespace ocelli
