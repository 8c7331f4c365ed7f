#include "oc_core/gl_rays/gl_rays.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

/// Of a work group: rays of a list fill one after the other.
constexpr size_t kTileSide = 8;
constexpr size_t kTile = kTileSide * kTileSide;
constexpr size_t kMaxTilesAcross = 128;

void uploadTexels(GlContext& context, const GlObject& texture, const Image<glm::vec4>& texels) {
  context.gl().TextureSubImage2D(texture.id(), 0, 0, 0, texels.width(), texels.height(), GL_RGBA, GL_FLOAT,
                                 texels.data());
}

}  // namespace

GlRays::GlRays(GlContext& context, int width, int height)
    : width_(width),
      height_(height),
      origins_(makeTexture(context, GL_RGBA32F, width, height)),
      steps_(makeTexture(context, GL_RGBA32F, width, height)) {}

GlRays::GlRays(GlContext& context, const Image<StraightRay>& rays) : GlRays(context, rays.width(), rays.height()) {
  Image<glm::vec4> origins(width_, height_);
  Image<glm::vec4> steps(width_, height_);
  for (size_t i = 0; i < rays.size(); ++i) {
    origins[i] = glm::vec4(rays[i].origin, rays[i].reach);
    steps[i] = glm::vec4(rays[i].step, 0);
  }
  uploadTexels(context, origins_, origins);
  uploadTexels(context, steps_, steps);
  context.check("uploading rays");
}

Image<StraightRay> rayImage(std::span<const StraightRay> rays) {
  const size_t tiles = std::max<size_t>((rays.size() + kTile - 1) / kTile, 1);
  const size_t across = std::min(tiles, kMaxTilesAcross);
  const size_t down = (tiles + across - 1) / across;
  Image<StraightRay> image(static_cast<int>(across * kTileSide), static_cast<int>(down * kTileSide));
  for (size_t i = 0; i < rays.size(); ++i) {
    image[rayTexel(image, i)] = rays[i];
  }
  return image;
}

size_t rayTexel(const Image<StraightRay>& image, size_t ray) {
  const auto width = static_cast<size_t>(image.width());
  const size_t tile = ray / kTile;
  const size_t across = width / kTileSide;
  const size_t x = tile % across * kTileSide + ray % kTileSide;
  const size_t y = tile / across * kTileSide + ray % kTile / kTileSide;
  return y * width + x;
}

}  // namespace ocelli
