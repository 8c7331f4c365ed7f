// Which object is at each pixel: what an observer who knows every object would make out in an image. The simulated
// subject of a study (chapter 7) sees through it, and tests count with it how often an image shows an object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/image/png_file.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

inline constexpr uint32_t kStructure = 0;          ///< floors, walls and what no one asks for (scene.h)
inline constexpr uint32_t kNothing = 0xffffffffu;  ///< where the background shows

/// The object of the triangle that each pixel shows. `objectOfTriangle` is that of the mesh that was drawn.
Image<uint32_t> identityImage(const FragmentImage& fragments, const std::vector<uint32_t>& objectOfTriangle);

/// Where one object shows in an image.
struct ObjectSighting {
  uint32_t object = 0;
  size_t pixels = 0;
  size_t regions = 0;   ///< pixels that touch at a side or a corner are in one
  glm::ivec2 lower{0};  ///< the pixel columns and rows that it spans, the last ones included
  glm::ivec2 upper{0};
  glm::dvec2 centroid{0};  ///< of its pixels' centres, pixels
  bool atBorder = false;   ///< of the image: there may be more of it

  bool operator==(const ObjectSighting&) const = default;
};

/// Of each object that shows, in the order of their identities; structure and background are none.
std::vector<ObjectSighting> sightings(const Image<uint32_t>& identities);

/// False colours for people, sRGB. Two objects whose identities differ by less than 14 have different colours, which
/// differ to every kind of colour vision for those of one brightness; structure is grey, background black.
Image<Rgb8> identityColors(const Image<uint32_t>& identities);

}  // namespace ocelli
