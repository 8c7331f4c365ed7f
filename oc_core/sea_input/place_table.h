// Tables of places (CSV): where images were, or are to be taken.
//
// The first row names the columns: x, y, z; and if there are any: file; yaw (degrees, to the left), or qw, qx, qy, qz,
// a unit quaternion that turns the camera's axes (x right, y up, -z forward) into the world's. Others are not looked
// at.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oc_core/sea/sea_projection.h"

namespace ocelli {

struct PlaceTable {
  std::vector<SeaPose> poses;
  std::vector<std::string> files;  ///< as long as the poses where there is such a column, otherwise empty
};

/// Throws InputError with the line for what is no number, columns that are missing, and quaternions that are not of
/// length 1 (to 1e-3; they are normalised).
PlaceTable placesFromCsv(std::string_view bytes, const std::string& where);

}  // namespace ocelli
