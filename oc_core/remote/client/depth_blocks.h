// The depth of an image as few flat pieces: blocks of samples that lie on one plane, halved where they do not, down to
// single samples. They give the depth of each pixel of a view from elsewhere in a fraction of the time that a mesh of
// all samples takes, and stand for no surface between samples that are none: each block ends where its pixels do.
//
// In the pinhole's image 1/z is linear over a plane, so a block is a plane of 1/z, fitted to its samples. It is flat
// where no sample lies farther from it than moves it by 0.2 pixels, for an eye as far away as is covered.
#pragma once

#include <array>
#include <vector>

#include "oc_core/camera/gpc_map.h"
#include "oc_core/ocri/reference_image.h"

namespace ocelli {

class DepthBlocks {
 public:
  /// Of an image of a pinhole or a general one. `tolerance` is by how much 1/z of a sample may differ from its block.
  DepthBlocks(const ReferenceImage& image, const GpcMap& map, float tolerance);

  /// 1/z of the nearest surface at each pixel of a view, z along its view direction; 0 where there is none.
  Image<float> inverseDepth(const PinholeCamera& view) const;
  size_t size() const { return blocks_.size(); }

 private:
  /// Directions of the four corners in the world, with a length of 1 along the view direction of the image, and 1/z.
  struct Block {
    std::array<glm::vec4, 4> corners;
  };

  glm::vec3 eye_;
  std::vector<Block> blocks_;
};

/// That of images with these near samples (image_cover.h), for views of 720 lines.
float blockTolerance(double nearZ, double farZ);

}  // namespace ocelli
