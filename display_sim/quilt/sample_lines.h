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

/// Where the ray of an empty pixel ends in the base image, pixels along u; nothing where it has no ray.
using FarPosition = std::function<std::optional<float>(int column, int row)>;

/// Of a pinhole's image.
FarPosition straightRays();

/// Without `farPosition` nothing is known of empty pixels. The image displaces a pinhole's; its rows are those of the
/// pinhole.
SampleLines sampleLines(const ReferenceImage& image, const FarPosition& farPosition,
                        const ImageMeshOptions& options = {});

}  // namespace ocelli
