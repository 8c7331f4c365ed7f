#include "oc_core/gl/displacement_uniforms.h"

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>
#include <vector>

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

DisplacementBlock displacementBlock(const GpcCamera& camera, const SubdivisionOptions& options) {
  return blockFor(camera.longestDisplacement(), options);
}

GlObject distortionTexture(GlContext& context, const DdocCamera& camera) {
  static_assert(sizeof(DistortionSample) == 4 * sizeof(float), "a sample is a texel");
  GlObject map = makeTexture(context, GL_RGBA32F, camera.width(), camera.height());
  context.gl().TextureSubImage2D(map.id(), 0, 0, 0, camera.width(), camera.height(), GL_RGBA, GL_FLOAT,
                                 camera.map().samples().data());
  return map;
}

GlObject zoneTexture(GlContext& context, const GpcCamera& camera) {
  constexpr size_t kTexels = 3;  // of a zone
  std::vector<glm::vec4> texels;
  for (const GpcZone& zone : camera.map().zones()) {
    const GpcProfile& profile = zone.profile();
    const std::array<double, 4>& c = profile.coefficients();
    texels.insert(texels.end(),
                  {glm::vec4(zone.center(), zone.half()),
                   glm::vec4(1 / profile.zoom(), profile.outer(), profile.leastRate(), profile.greatestRate()),
                   glm::vec4(c[0], c[1], c[2], c[3])});
  }
  texels.resize(std::max(texels.size(), kTexels), glm::vec4(0));
  const auto rows = static_cast<int>(texels.size() / kTexels);
  GlObject zones = makeTexture(context, GL_RGBA32F, static_cast<int>(kTexels), rows);
  context.gl().TextureSubImage2D(zones.id(), 0, 0, 0, static_cast<int>(kTexels), rows, GL_RGBA, GL_FLOAT,
                                 texels.data());
  return zones;
}

}  // namespace ocelli
