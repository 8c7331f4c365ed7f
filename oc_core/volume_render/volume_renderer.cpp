#include "oc_core/volume_render/volume_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/render/pixel_tiles.h"
#include "oc_core/render/raycast.h"
#include "oc_core/volume/gradient_light.h"
#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume_render/march_kernel.h"
#include "oc_core/volume_render/optical_table.h"
#include "oc_core/volume_render/ray_pieces.h"
#include "oc_core/volume_render/ray_tile.h"
#include "oc_core/volume_render/volume_occupancy.h"

namespace ocelli {
namespace {

/// Voxels: of samples' places, which are in single precision.
constexpr double kRounding = 1e-2;
/// By so much of a voxel may rays be off that are made from their neighbours.
constexpr double kTileDeviation = 0.001;

}  // namespace

struct VolumeRenderer::Impl {
  VolumeScene scene;
  VolumeRenderOptions options;
  VolumeBricks bricks;
  ValueRange range;
  std::unique_ptr<RayScene> surfaces;
  VolumeExtent extent;
  // Of the appearance and the options:
  std::optional<OpticalTable> table;
  std::optional<VolumeOccupancy> occupancy;
  MarchSetup setup;
  std::optional<TileSight> sight;  ///< none: what shows nothing is not left out
  TileBall ball;
  double tileDeviation;

  Impl(VolumeScene itsScene, const VolumeRenderOptions& itsOptions)
      : scene(std::move(itsScene)),
        options(itsOptions),
        bricks(*scene.volume),
        range(rangeOf(bricks)),
        surfaces(scene.surfaces.triangles.empty() ? nullptr : std::make_unique<RayScene>(scene.surfaces)),
        extent(scene),
        ball(ballAround()),
        tileDeviation(kTileDeviation * leastSpacing()) {
    prepare();
  }

  void prepare() {
    OC_CHECK(options.step > 0 && options.depthOpacity > 0 && options.depthOpacity < 1,
             "steps are positive, and the opacity of the depth lies in (0, 1)");
    OC_CHECK(scene.volume->scale() != 0, "a volume has values");
    table.emplace(scene.appearance.transfer, range);
    occupancy.emplace(bricks, *table);
    const ScalarVolume& volume = *scene.volume;
    setup.volume = &volume;
    setup.firstNumber = (table->firstValue() - volume.offset()) / volume.scale();
    setup.entriesByNumber = static_cast<float>(table->entriesByValue() * volume.scale());
    setup.entries = table->entries().data();
    setup.distances = options.skipEmpty ? occupancy->distances().data() : nullptr;
    setup.bricks = occupancy->size();
    sight.reset();
    if (options.skipEmpty) {
      sight.emplace(*occupancy, glm::inverse(scene.worldFromIndex), kRounding);
    }
    extent.setSeen(options.skipEmpty ? seenBox() : IndexBox::everywhere());
    setup.step = static_cast<float>(options.step * volume.grid().meanSpacing());
    setup.endTransmittance = static_cast<float>(options.endTransmittance);
    setup.depthOpacity = static_cast<float>(options.depthOpacity);
    const VolumeShading& shading = scene.appearance.shading;
    setup.isShaded = shading.isOn;
    setup.light = singleLight(gradientLight(scene.worldFromIndex, shading, range), volume.scale());
  }

  /// Of voxels, in the scene's world.
  double leastSpacing() const {
    const glm::dmat3 m(scene.worldFromIndex);
    return std::min({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  }

  /// All voxels, and as much again as rays may be off.
  TileBall ballAround() const {
    const glm::dvec3 half = glm::dvec3(scene.volume->grid().size) * 0.5;
    const glm::dvec3 center(scene.worldFromIndex * glm::dvec4(half - 0.5, 1));
    double radius = 0;
    for (const double x : {-half.x, half.x}) {
      for (const double y : {-half.y, half.y}) {
        radius = std::max(radius, glm::length(glm::dmat3(scene.worldFromIndex) * glm::dvec3(x, y, half.z)));
      }
    }
    return {center, radius * 1.01};
  }

  /// Around the bricks that show something.
  IndexBox seenBox() const {
    IndexBox box = IndexBox::everywhere();
    for (int axis = 0; axis < 3; ++axis) {
      // The outermost bricks reach as far as the volume does.
      if (occupancy->firstSeen()[axis] > 0) {
        box.lower[axis] = occupancy->firstSeen()[axis] * VolumeBricks::kEdge - kRounding;
      }
      if (occupancy->endSeen()[axis] < occupancy->size()[axis]) {
        box.upper[axis] = occupancy->endSeen()[axis] * VolumeBricks::kEdge + kRounding;
      }
    }
    return box;
  }

  /// Whether rays in these pieces see nothing.
  bool misses(const HullPieces& hull) const { return surfaces == nullptr && extent.misses(hull); }

  /// The rays of pixels from `first` to before `end`, row by row. None where they see nothing.
  void makeRays(const glm::ivec2& first, const glm::ivec2& end, const RayTile::Rays& rayPath, const RayHull& hull,
                bool isSmooth, std::vector<RayPath>& rays) const {
    if (hull && misses(hull(glm::dvec2(first), glm::dvec2(end)))) {
      return;
    }
    RayTile tile;
    const bool isFit = isSmooth && surfaces == nullptr &&
                       tile.fit(rayPath, glm::vec2(first) + 0.5f, glm::vec2(end) - 0.5f, ball, tileDeviation);
    if (isFit && sight && !sight->meets(tile)) {
      return;
    }
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        rays.push_back(isFit ? tile.at(pixel) : rayPath(pixel));
      }
    }
  }

  void trace(std::span<const RayPath> rays, std::span<VolumePixel> pixels, bool stopsAtDepth) const {
    OC_CHECK(rays.size() == pixels.size(), "one pixel a ray");
    std::vector<std::optional<Hit>> hits(surfaces ? rays.size() : 0);
    if (surfaces) {
      surfaces->hits(rays, hits);
    }
    const auto surfaceOf = [&](size_t i) { return surfaces && hits[i] ? &*hits[i] : nullptr; };
    std::vector<MarchResult> results(rays.size());
    march(
        setup,
        [&](size_t i, VolumeExtent::Pieces& pieces) {
          const Hit* surface = surfaceOf(i);
          return extent.cut(
              rays[i], surface != nullptr ? static_cast<double>(surface->t) : std::numeric_limits<double>::infinity(),
              pieces);
        },
        stopsAtDepth, results);
    for (size_t i = 0; i < rays.size(); ++i) {
      const Hit* surface = surfaceOf(i);
      const MarchResult& result = results[i];
      VolumePixel& pixel = pixels[i];
      pixel = {};
      pixel.color = {result.color[0], result.color[1], result.color[2], 1 - result.transmittance};
      pixel.samples = result.samples;
      if (result.isDeep) {
        pixel.t = result.t;
      }
      if (surface != nullptr && !(stopsAtDepth && result.isDeep)) {
        pixel.surfaceT = surface->t;
        pixel.color += glm::vec4(surface->color, 1) * result.transmittance;
      }
    }
  }
};

VolumeRenderer::VolumeRenderer(VolumeScene scene, const VolumeRenderOptions& options)
    : impl_(std::make_unique<Impl>(std::move(scene), options)) {}
VolumeRenderer::~VolumeRenderer() = default;
VolumeRenderer::VolumeRenderer(VolumeRenderer&&) noexcept = default;
VolumeRenderer& VolumeRenderer::operator=(VolumeRenderer&&) noexcept = default;

const VolumeScene& VolumeRenderer::scene() const {
  return impl_->scene;
}
const VolumeRenderOptions& VolumeRenderer::options() const {
  return impl_->options;
}
void VolumeRenderer::setAppearance(const VolumeAppearance& appearance) {
  impl_->scene.appearance = appearance;
  impl_->prepare();
}
void VolumeRenderer::setClips(std::vector<ClipPlane> clips) {
  impl_->scene.clips = std::move(clips);
}
void VolumeRenderer::setOptions(const VolumeRenderOptions& options) {
  impl_->options = options;
  impl_->prepare();
}

VolumePixel VolumeRenderer::pixel(const RayPath& ray) const {
  VolumePixel pixel;
  pixels(std::span(&ray, 1), std::span(&pixel, 1));
  return pixel;
}
void VolumeRenderer::pixels(std::span<const RayPath> rays, std::span<VolumePixel> pixels) const {
  impl_->trace(rays, pixels, false);
}
void VolumeRenderer::firstHits(std::span<const RayPath> rays, std::span<VolumePixel> pixels) const {
  impl_->trace(rays, pixels, true);
}

VolumeImage VolumeRenderer::render(int width, int height, const std::function<RayPath(const glm::vec2&)>& rayPath,
                                   const Progress& progress, const RayHull& hull, bool isSmooth) const {
  // Bands of rows, so that progress can be told between them. Without it there is one.
  constexpr int kBand = 64;
  VolumeImage image(width, height);
  const int band = progress ? kBand : std::max(height, 1);
  for (int first = 0; first < height; first += band) {
    report(progress, "rendering the volume", static_cast<double>(first) / height);
    const int rows = std::min(band, height - first);
    const VolumeImage part = castTiles<VolumePixel>(
        width, rows,
        [&](const glm::ivec2& begin, const glm::ivec2& end, std::vector<RayPath>& rays) {
          impl_->makeRays({begin.x, begin.y + first}, {end.x, end.y + first}, rayPath, hull, isSmooth, rays);
        },
        [&](std::span<const RayPath> rays, std::span<VolumePixel> pixels) { impl_->trace(rays, pixels, false); });
    std::copy(part.begin(), part.end(), image.begin() + static_cast<std::ptrdiff_t>(image.index(0, first)));
  }
  report(progress, "rendering the volume", 1);
  return image;
}

}  // namespace ocelli
