// What rounding may amount to where rays of cameras are cut into parts: coordinates of 1e4 in double precision, with a
// margin for chains of bends.
#pragma once

namespace ocelli {

inline constexpr double kPixelRounding = 1e-7;    ///< pixels
inline constexpr double kHeightRounding = 1e-10;  ///< above a plane, relative to the scene

}  // namespace ocelli
