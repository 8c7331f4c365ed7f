// Blocks of voxels, all lit, to try dithers on: what they should show is known everywhere, so what they do show can be
// scored and looked at.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "display_sim/dither/slice_options.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// The dithers and their names on the command line.
struct NamedDither {
  std::string_view name;
  ColorReduction colors;
};
inline constexpr NamedDither kNamedDithers[] = {{"ordered", ColorReduction::kDither},
                                                {"blue-noise", ColorReduction::kBlueNoise},
                                                {"diffusion", ColorReduction::kDiffusion},
                                                {"none", ColorReduction::kNearest}};

/// Sizes are multiples of those of a block of dither_score.h. The first column lies at the axis of a display of 198
/// slices a half turn, the last at its rim.
struct DitherField {
  std::string name;
  int columns = 0;
  int rows = 0;
  int slices = 0;
  std::function<glm::vec3(int column, int row, int slice)> color;  ///< in [0, 1]

  size_t index(int column, int row, int slice) const {
    return static_cast<size_t>((slice * rows + row) * columns + column);
  }
  size_t voxels() const { return static_cast<size_t>(columns * rows * slices); }
};

/// Grey that rises from dark at the first column to full light at the last.
DitherField rampField();
/// A grey ball in front of black, whose light turns with the slices.
DitherField greySphereField();
/// Hues around, from white in the middle to full colours at the edge, in front of black.
DitherField colorWheelField();
/// The three above.
std::vector<DitherField> ditherFields();

/// The light that every voxel of the field shows, in the order of DitherField::index().
std::vector<glm::vec3> shownLight(const DitherField& field, ColorReduction colors, int bitsPerChannel);

}  // namespace ocelli
