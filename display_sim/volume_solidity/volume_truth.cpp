#include "display_sim/volume_solidity/volume_truth.h"

#include <algorithm>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/solidity/opaque_image.h"
#include "display_sim/volume_slicing/swept_light.h"
#include "display_sim/volume_solidity/volume_sight.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

class HiddenInVolume final : public HiddenVoxels {
 public:
  HiddenInVolume(const Volume& volume, const VolumeRenderer& renderer) : volume_(volume), renderer_(renderer) {}

  Volume hiddenFrom(const glm::vec3& eye) const override {
    const VolumeSight sight(renderer_, {eye}, volume_.height());
    const SweepGeometry sweep(volume_.profile());
    Volume hidden(volume_.profile());
    parallelFor(static_cast<size_t>(volume_.slices()), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const int slice = static_cast<int>(i);
        forEachLevel(volume_, slice, [&](int column, int row, const Rgb8& levels) {
          const double side = std::max({sweep.columnWidth(), sweep.rowHeight(), sweptThickness(sweep, column)});
          if (!sight.sees(sweep.voxelCenter(slice, column, row), side)) {
            hidden.raise(slice, column, row, levels);
          }
        });
      }
    });
    return hidden;
  }

 private:
  const Volume& volume_;
  const VolumeRenderer& renderer_;
};

class SolidVolume final : public SolidReference {
 public:
  explicit SolidVolume(const VolumeRenderer& renderer) : renderer_(renderer) {}

  Image<Rgb8> opaqueImage(const ObserverOptions& options) const override {
    const PinholeCamera camera(viewOfObserver(options), kOpaqueSamplesASide * options.width,
                               kOpaqueSamplesASide * options.height);
    const VolumeImage pixels = renderVolume(camera, renderer_);
    Image<glm::vec3> samples(camera.width(), camera.height());
    for (size_t i = 0; i < pixels.size(); ++i) {
      samples[i] = glm::vec3(pixels[i].color);
    }
    return meanOfSamples(samples);
  }

  std::unique_ptr<HiddenVoxels> hiddenVoxels(const Volume& volume) const override {
    return std::make_unique<HiddenInVolume>(volume, renderer_);
  }

 private:
  const VolumeRenderer& renderer_;
};

}  // namespace

std::unique_ptr<SolidReference> solidVolume(const VolumeRenderer& renderer) {
  return std::make_unique<SolidVolume>(renderer);
}

}  // namespace ocelli
