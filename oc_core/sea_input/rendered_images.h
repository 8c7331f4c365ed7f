// The images of a sea rendered from a scene: panoramas, as omnidirectional cameras take them.
#pragma once

#include <string>
#include <vector>

#include "oc_core/image/srgb_encoder.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/sea/direction_table.h"
#include "oc_core/sea/sea_source.h"

namespace ocelli {

class RenderedImages final : public SeaSource {
 public:
  struct Options {
    SeaProjection projection;
    int samples = 2;          ///< a side of each pixel: its colour is the mean of samples x samples
    glm::vec3 background{0};  ///< linear: what rays see that meet nothing
  };

  /// The mesh must outlive it. `poses` are validated. `description` is the scene as the user wrote it.
  RenderedImages(std::string description, const Mesh& mesh, std::vector<SeaPose> poses, const Options& options);

  std::string description() const override { return description_; }
  const SeaProjection& projection() const override { return options_.projection; }
  const std::vector<SeaPose>& poses() const override { return poses_; }
  const std::vector<std::string>& names() const override { return names_; }
  Image<Rgb8> image(uint32_t index) const override;

 private:
  std::string description_;
  const Mesh& mesh_;
  RayScene rays_;
  std::vector<SeaPose> poses_;
  std::vector<std::string> names_;  ///< none
  Options options_;
  DirectionTable directions_;
  SrgbEncoder encoder_;
};

}  // namespace ocelli
