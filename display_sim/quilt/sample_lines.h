// The rows of a reference image as lines of joined samples, each in the plane of its row: what a pinhole sees that has
// moved along the rows follows from each line alone.
//
// Neighbours in a row are joined to surfaces by the criteria of the image's mesh (sample_join.h). A sample at the end
// of a surface stands for the whole of its pixel: its line goes on by half the way to its neighbour.
//
// A ray that met nothing tells that nothing is there. It gets a point beyond all samples, so that what was seen to be
// empty is told from what was not seen.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// Points in the order of the image's columns.
struct SampleLine {
  std::vector<float> u;            ///< where the base pinhole sees each, pixels
  std::vector<float> inverseZ;     ///< along the view direction
  std::vector<glm::vec3> color;    ///< linear
  std::vector<uint8_t> joinsNext;  ///< whether there is a surface up to the next one; the last one has none

  size_t size() const { return u.size(); }
};

struct SampleLines {
  PinholeCamera base;
  std::vector<SampleLine> rows;
  float emptyInverseZ = 0;  ///< of points where nothing is; those of samples are larger
  bool knowsEmpty = false;  ///< whether there are such points
};

/// The far end of the ray of an empty pixel.
struct FarEnd {
  float u = 0;         ///< where the base pinhole sees it, pixels
  float inverseZ = 0;  ///< where it ends: 0 for one that goes on
};
/// Nothing where a pixel has no ray.
using FarEndOf = std::function<std::optional<FarEnd>(int column, int row)>;

/// What is known of where an image has no sample.
struct EmptyRays {
  FarEndOf farEnd{};           ///< empty: nothing is known
  bool beyondBorders = false;  ///< whether nothing is to the left and right of the image either
};

/// Of a pinhole's image.
FarEndOf straightRays();

/// The image displaces a pinhole's; its rows are those of the pinhole.
SampleLines sampleLines(const ReferenceImage& image, const EmptyRays& empty, const ImageMeshOptions& options = {});

}  // namespace ocelli
