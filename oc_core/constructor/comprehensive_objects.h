// A comprehensive camera (comprehensive_constructor.h) that shows all objects of a maze. With any one choice of options
// a few objects stand wholly behind larger ones, or end up smaller than a pixel: 9 of 2,000 with the usual options, and
// with others others. So where an object is not seen, other choices are tried, from a table, and the one that leaves
// fewest unseen is taken: the first of those that are alike. Where the given options show all, they stay.
//
// An object is seen where the rays of pixels meet it before another object or a wall, as renderers have it. Pixels that
// a sample of points of its surface lies in are looked at.
#pragma once

#include <vector>

#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// In how many pixels the camera shows points of each object, by identity; of an object, about 256 points are looked
/// at. 0 for identities that no triangle has, and for 0, which is no object.
std::vector<size_t> pixelsOfObjects(const GraphCamera& camera, const GuidedScene& scene);

struct ComprehensiveChoice {
  ComprehensiveOptions options;
  std::vector<uint32_t> unseen;  ///< objects that take less than two pixels, by that count, with these options
};

/// For images of that size. Throws InputError where the scene has no maze, and as makeComprehensiveCamera() does for
/// the given options; other choices that do so are passed over.
ComprehensiveChoice chooseComprehensive(const GuidedScene& scene, const ComprehensiveOptions& options, int width,
                                        int height);

}  // namespace ocelli
