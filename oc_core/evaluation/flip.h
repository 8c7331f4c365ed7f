// LDR-FLIP: how visible the difference is when two images take each other's place on a screen (Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020).
//
// Colour: both images are blurred in an opponent space as the eye's contrast sensitivity does at this distance, and
// compared with the HyAB distance in Hunt-adjusted L*a*b*; the distance is raised to 0.7 and mapped so that green
// against blue, the farthest pair of colours, gives 1. Features: edges and points of the luminance, found with
// derivatives of Gaussians, are compared, and a difference makes that of the colours count more.
#pragma once

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// A screen of 3840 pixels over 0.7 m, seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67;

/// The error of each pixel, from 0 to 1. Images are sRGB-encoded, of the same size. Symmetric.
Image<float> flipMap(const Image<Rgb8>& a, const Image<Rgb8>& b, double pixelsPerDegree = kFlipPixelsPerDegree);

/// The mean of the map. Both images have pixels.
double flip(const Image<Rgb8>& a, const Image<Rgb8>& b, double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace ocelli
