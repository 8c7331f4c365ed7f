// The pictures of the volume pane, on the CPU: those of `ocelli render` with the same camera, view, size, transfer
// function and clip planes, to the byte, before black. What a picture has in common with the one before is kept: the
// volume prepared for rays.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "display_sim/viewer/background_work.h"
#include "oc_core/base/progress.h"
#include "oc_core/image/png_file.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

struct VolumeWanted {
  bool shows = false;                             ///< whether pictures are wanted: not of a pane that is hidden
  std::shared_ptr<const LoadedScene> scene = {};  ///< null: none yet
  View view;
  glm::ivec2 size{0};  ///< of the picture, pixels
  CameraChoice camera;
  uint64_t cameraRevision = 0;                              ///< another one where `camera` is another
  std::string rays = {};                                    ///< as in VolumeShown
  std::shared_ptr<const VolumeAppearance> appearance = {};  ///< another pointer where it is another
  std::array<glm::dvec2, 3> kept = VolumeShown::kWhole;

  bool canBePainted() const { return shows && scene != nullptr && scene->volume != nullptr && appearance != nullptr; }
  bool operator==(const VolumeWanted& other) const {
    return shows == other.shows && scene == other.scene && view == other.view && size == other.size &&
           cameraRevision == other.cameraRevision && rays == other.rays && appearance == other.appearance &&
           kept == other.kept;
  }
};

class VolumePainter {
 public:
  static constexpr std::array kScales{1.0, 0.5, 0.25, 0.125};
  static constexpr bool kStartsSmall = true;
  /// Samples of pictures that are smaller than wanted stand so much farther apart.
  static constexpr double kPreviewStep = 2;

  /// As large as the camera's image, which is of another size than `size` where the camera is. Throws InputError for
  /// views that are none, and as volumeCamera() does (oc_core/volume_camera), and what `progress` throws.
  Image<Rgb8> paint(const VolumeWanted& wanted, const glm::ivec2& size, const Progress& progress = {});

 private:
  void prepare(const VolumeWanted& wanted, bool isPreview);

  std::shared_ptr<const LoadedVolume> volume_;  ///< that the following is of
  std::optional<VolumeRenderer> renderer_;
  std::shared_ptr<const VolumeAppearance> appearance_;
  std::array<glm::dvec2, 3> kept_{};
};

}  // namespace ocelli
