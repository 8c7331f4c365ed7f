#include "oc_core/gl/displacement_uniforms.h"

#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

DisplacementBlock blockFor(float longestDisplacement, const SubdivisionOptions& options) {
  DisplacementBlock block;
  block.clipMargin = longestDisplacement + 2;
  block.longestEdge = options.longestEdgePixels;
  block.shortestEdge = options.shortestEdgePixels;
  block.tornEdge = options.tornEdgePixels;
  return block;
}

}  // namespace

std::string displacementDefine(int model) {
  return "#define MODEL " + std::to_string(model) + "\n";
}

DisplacementBlock displacementBlock(const SpocCamera& camera, const SubdivisionOptions& options) {
  const SpocDistortion& d = camera.distortion();
  DisplacementBlock block = blockFor(camera.longestDisplacement(), options);
  block.pole = d.pole;
  block.displacedFrom = d.zNear;
  block.inverseNear = 1 / d.zNear;
  block.perInverseZ = 1 / (block.inverseNear - 1 / d.zFar);
  block.nearPixels = d.nearPixels;
  block.farPixels = d.farPixels;
  return block;
}

DisplacementBlock displacementBlock(const ReversePinholeCamera& camera, const SubdivisionOptions& options) {
  DisplacementBlock block = blockFor(camera.longestDisplacement(), options);
  block.sameImageDepth = camera.sameImageDepth();
  block.meetingDepth = camera.meetingDepth();
  return block;
}

DisplacementBlock displacementBlock(const DdocCamera& camera, const SubdivisionOptions& options) {
  DisplacementBlock block = blockFor(camera.longestDisplacement(), options);
  block.bilinear = camera.map().lookup() == DistortionMap::Lookup::kBilinear ? 1 : 0;
  return block;
}

GlObject distortionTexture(GlContext& context, const DdocCamera& camera) {
  static_assert(sizeof(DistortionSample) == 4 * sizeof(float), "a sample is a texel");
  GlObject map = makeTexture(context, GL_RGBA32F, camera.width(), camera.height());
  context.gl().TextureSubImage2D(map.id(), 0, 0, 0, camera.width(), camera.height(), GL_RGBA, GL_FLOAT,
                                 camera.map().samples().data());
  return map;
}

}  // namespace ocelli
