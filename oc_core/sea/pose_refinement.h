// The pose of an image refined so that least is left to say of it (section 3.5.4.2.2, warping optimization): that makes
// up for poses that are not exact, and partly for proxies that are not.
//
// The text takes Powell's method; here it is NLopt's BOBYQA, a later one of Powell's that takes bounds, and NLopt's
// Subplex for those who want to compare. As in the text, images of 256 pixels a side are compared.
//
// Recipe for a new one: a row of the table in oc_core/sea/pose_refinement.cpp.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/sea/sea_proxy.h"
#include "oc_core/sea/warped_image.h"

namespace ocelli {

struct PoseRefinementMethod {
  const char* name;
  const char* meaning;
  int algorithm;  ///< NLopt's number; -1: nothing is refined
};

std::span<const PoseRefinementMethod> poseRefinementMethods();
/// Throws InputError that lists them, naming `where`, for a name that none has.
const PoseRefinementMethod& requirePoseRefinement(const std::string& name, const std::string& where);

/// What movedBy() takes.
struct PoseOffset {
  glm::dvec3 translation{0};
  glm::dvec3 rotation{0};
};

/// Both images, their projection and poses, at the size that they are compared at.
struct PoseComparison {
  const SeaProxy& proxy;
  const SeaProjection& projection;
  const WarpReference& reference;
  SeaPose referencePose;
  const Image<Rgb8>& target;
  SeaPose targetPose;
};

/// The size that images are compared at.
inline constexpr int kRefinementSide = 256;

/// The mean absolute difference of luminance where the reference sees what the target sees, with the pose of the target
/// moved so; infinite where it sees less than a tenth.
double comparisonEnergy(const PoseComparison& comparison, const PoseOffset& offset);

/// The offset of least energy that was found; it is never worse than none. `reach` bounds the translation, world units;
/// rotations are bounded to 5 degrees. On the calling thread.
PoseOffset refinedPose(const PoseComparison& comparison, const PoseRefinementMethod& method, double reach);

/// Every pixel the mean of a block. Both sizes of `image` are at least those.
Image<Rgb8> reducedImage(const Image<Rgb8>& image, int width, int height);

}  // namespace ocelli
