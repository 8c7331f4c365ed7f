// Where rays leave glass, from an image of its back faces (section 3.5.2.3.1: "a first rendering pass to store depth
// and surface normals for back-facing surfaces, which are then used by a second pass to compute the ray emerging after
// a second refraction"). The text takes the approximation of its reference [171], which this follows: the way inside is
// as long as a mean of two lengths that are known beforehand, along the view ray and along the normal, weighted by how
// far the ray is bent; where it ends, the image of the back faces says the normal.
//
// DEVIATION: [171] stores the length along the normal with each vertex; here it is found by one ray a pixel inside of
// the object. Where the back face says that the ray cannot leave, [171] has no answer: it goes on as it is.
// Ours, beside it, uses the depth that the image holds as well, and searches where the ray leaves.
#pragma once

#include "oc_core/shade/secondary_rays.h"

namespace ocelli {

/// How long the way inside of the glass is.
enum class BackFaceExit {
  kExpected,  ///< as [171] has it
  kSearched,  ///< until the depth of the back faces says that the ray has left: a walk of 16 pieces, and halving
};

/// As refractedRays(), the same pixels in the same order.
SecondaryRays refractedRaysByBackFaces(const FirstSurfaces& surfaces, const PinholeCamera& camera, BackFaceExit by);

/// Degrees between the directions of two rays, a mean over all; 0 for none. They are of the same pixels.
double meanDegreesBetween(const SecondaryRays& a, const SecondaryRays& b);

}  // namespace ocelli
