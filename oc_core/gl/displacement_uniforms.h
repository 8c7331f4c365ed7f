// How the occlusion cameras displace the image of their pinhole, as shaders/displaced.glsl takes it.
#pragma once

#include <string>

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {

/// The models, as the shader numbers them.
inline constexpr int kSpocModel = 1;
inline constexpr int kReversePinholeModel = 2;
inline constexpr int kDdocModel = 3;

/// "#define MODEL 1\n".
std::string displacementDefine(int model);

/// In the layout std140.
struct DisplacementBlock {
  glm::vec2 pole{0};
  float displacedFrom = 0;
  float inverseNear = 0;
  float perInverseZ = 0;
  float nearPixels = 0;
  float farPixels = 0;
  float sameImageDepth = 0;
  float meetingDepth = 0;
  float clipMargin = 0;
  uint32_t bilinear = 0;
  float longestEdge = 0;
  float shortestEdge = 0;
  float tornEdge = 0;
  glm::vec2 unused{0};
};

/// `options` are for shaders that split triangles.
DisplacementBlock displacementBlock(const SpocCamera& camera, const SubdivisionOptions& options = {});
DisplacementBlock displacementBlock(const ReversePinholeCamera& camera, const SubdivisionOptions& options = {});
DisplacementBlock displacementBlock(const DdocCamera& camera, const SubdivisionOptions& options = {});

/// The distortion map, for texture unit 1. Hold a GlScope.
GlObject distortionTexture(GlContext& context, const DdocCamera& camera);

}  // namespace ocelli
