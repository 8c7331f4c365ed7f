#include "display_sim/solidity/solidity.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "display_sim/observing/observer.h"
#include "display_sim/solidity/exposure_fit.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/evaluation/image_quality.h"
#include "oc_core/image/image_error.h"

namespace ocelli {
namespace {

double sumOf(const Image<glm::vec3>& light) {
  double sum = 0;
  for (const glm::vec3& pixel : light) {
    sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
  }
  return sum;
}

/// The vertical field of view just holds the unit sphere.
double pixelsPerDegree(const ObserverOptions& observer) {
  return observer.height / degreesFromRadians(2 * std::asin(1 / glm::length(glm::dvec3(observer.eye))));
}

Image<Rgb8> toned(Image<glm::vec3> light, double gain) {
  applyTone(light, {.gain = gain});
  return srgbFromLinear(light);
}

}  // namespace

SolidityErrors& SolidityErrors::operator+=(const SolidityErrors& other) {
  eyes += other.eyes;
  light += other.light;
  hiddenLight += other.hiddenLight;
  squaredError += other.squaredError;
  ssim += other.ssim;
  flip += other.flip;
  return *this;
}

double SolidityErrors::psnrDecibels() const {
  return ocelli::psnrDecibels(squaredError / static_cast<double>(eyes));
}

struct SolidityMeter::Impl {
  Impl(const SolidReference& solid, const SolidityOptions& given) : truth(solid), options(given) {
    OC_CHECK(!options.groups.empty() && !options.groups.front().eyes.empty(), "something is measured from somewhere");
    for (const EyeGroup& group : options.groups) {
      for (const glm::vec3& eye : group.eyes) {
        observers.push_back(observerAt(eye));
        checkObserverOptions(observers.back(), options.profile);
      }
    }
    opaque.resize(observers.size());
  }

  ObserverOptions observerAt(const glm::vec3& eye) const {
    const int side = options.imageSide > 0 ? options.imageSide : options.profile.height;
    return {.eye = eye, .width = side, .height = side};
  }

  const Image<Rgb8>& opaqueAt(size_t index) {
    if (opaque[index].empty()) {
      opaque[index] = truth.opaqueImage(observers[index]);
    }
    return opaque[index];
  }

  const SolidReference& truth;
  SolidityOptions options;
  std::vector<ObserverOptions> observers;  ///< of all groups, one behind the other
  std::vector<Image<Rgb8>> opaque;         ///< made when first asked for
};

SolidityMeter::SolidityMeter(const Mesh& scene, const SolidityOptions& options)
    : surfaces_(solidSurfaces(scene)), impl_(std::make_unique<Impl>(*surfaces_, options)) {}

SolidityMeter::SolidityMeter(const SolidReference& truth, const SolidityOptions& options)
    : impl_(std::make_unique<Impl>(truth, options)) {}

SolidityMeter::~SolidityMeter() = default;

SolidityFigures SolidityMeter::measure(const std::string& name, const Volume& volume, size_t triangles, Shown shown,
                                       const Progress& progress, const Visitor& visit) {
  OC_CHECK(volume.profile() == impl_->options.profile, "the volume is of another display");
  const std::unique_ptr<HiddenVoxels> voxels = impl_->truth.hiddenVoxels(volume);
  SolidityFigures figures{name, triangles, volume.litVoxels(), 0, {}};
  size_t index = 0;
  for (size_t group = 0; group < impl_->options.groups.size(); ++group) {
    figures.groups.emplace_back();
    for (size_t eye = 0; eye < impl_->options.groups[group].eyes.size(); ++eye, ++index) {
      report(progress, name, static_cast<double>(index) / static_cast<double>(impl_->observers.size()));
      const ObserverOptions& observer = impl_->observers[index];
      const Image<Rgb8>& opaque = impl_->opaqueAt(index);
      Image<glm::vec3> light = collectLight(volume, observer);
      Image<glm::vec3> hidden = collectLight(voxels->hiddenFrom(observer.eye), observer);
      if (shown == Shown::kVisibleOnly) {
        for (size_t i = 0; i < light.size(); ++i) {
          light[i] = glm::max(light[i] - hidden[i], glm::vec3(0));
        }
        hidden = Image<glm::vec3>(hidden.width(), hidden.height(), glm::vec3(0));
      }
      if (index == 0) {
        figures.gain = fittedGain(light, opaque);
      }
      SolidityErrors errors{.eyes = 1, .light = sumOf(light), .hiddenLight = sumOf(hidden)};
      const Image<Rgb8> observed = toned(std::move(light), figures.gain);
      errors.squaredError = meanSquaredError(opaque, observed);
      errors.ssim = ssim(opaque, observed);
      errors.flip = flip(opaque, observed, pixelsPerDegree(observer));
      figures.groups.back() += errors;
      if (visit) {
        const Image<Rgb8> shouldBeHidden = toned(std::move(hidden), figures.gain);
        visit({group, eye, opaque, observed, shouldBeHidden});
      }
    }
  }
  report(progress, name, 1);
  return figures;
}

}  // namespace ocelli
