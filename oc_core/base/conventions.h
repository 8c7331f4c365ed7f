// The conventions of the whole toolkit, stated once.
//
// Space    Right-handed, y up. Lengths are in metres, except in a display's model space, whose unit is the radius of
//          the display: a fitted scene lies in the sphere of radius 1 around the origin. Angles are in radians inside,
//          in degrees at the boundary, and the name says which (`fovVerticalDegrees`).
// Views    A camera looks along its own -z, as in OpenGL. `z` of an image sample is nevertheless positive in front of
//          the eye: it is the distance along the reference view direction, and is interpolated as 1/z.
// Images   Origin at the top left, u to the right, v down, in pixels. The centre of pixel (i, j) is (i + 0.5, j + 0.5).
// Colour   Linear light in memory, 1 = full. sRGB only where bytes leave or enter: PNG, PLY, OBJ, textures.
// Names    Transforms read result first: `worldFromCamera * pCamera` is a world point.
// Absence  std::optional where a point has no image or a pixel has no ray. z = 0 marks an empty image sample.
// Seeds    are explicit, and the same input gives the same bytes whatever the number of threads.
#pragma once

#include <numbers>

namespace ocelli {

/// The reference display (dissertation section 3.5.5.6): a screen of radius 5 in, viewed from 50 in.
inline constexpr double kInchMetres = 0.0254;
inline constexpr double kReferenceDisplayRadiusMetres = 5 * kInchMetres;
/// Distance of the default eye, in display radii: 50 in / 5 in.
inline constexpr float kDefaultEyeDistance = 10.0f;

/// Image size of the published measurements (Table 3.5), pixels.
inline constexpr int kDefaultWidth = 720;
inline constexpr int kDefaultHeight = 480;

inline constexpr double kPi = std::numbers::pi;

constexpr double radiansFromDegrees(double degrees) {
  return degrees * kPi / 180;
}
constexpr double degreesFromRadians(double radians) {
  return radians * 180 / kPi;
}

}  // namespace ocelli
