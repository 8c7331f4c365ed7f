#include "oc_core/gl/pinhole_uniforms.h"

namespace ocelli {
namespace {

/// In the layout std140.
struct PinholeBlock {
  glm::vec3 eye;
  float zNear;
  glm::vec3 right;
  float zFar;
  glm::vec3 down;
  float focal;
  glm::vec3 forward;
  float unused;
  glm::vec2 center;
  glm::vec2 imageSize;
};

}  // namespace

GlObject pinholeUniforms(GlContext& context, const PinholeCamera& camera) {
  const PinholeBlock block{
      camera.eye(),          camera.view().zNear,
      camera.right(),        camera.view().zFar,
      camera.down(),         camera.focalPixels(),
      camera.forward(),      0,
      camera.centerPixels(), {static_cast<float>(camera.width()), static_cast<float>(camera.height())}};
  return makeBuffer(context, sizeof(block), &block);
}

}  // namespace ocelli
