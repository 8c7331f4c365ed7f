#include "oc_core/depth_views/depth_view.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/panorama_camera.h"

namespace ocelli {
namespace {

constexpr const char* kNextDepthView =
    "give colours and depths of a pinhole or a panorama, as ocelli ocri views and ocelli ocri build --camera di write";

bool isDisplaced(const ReferenceImage& image) {
  for (size_t pixel = 0; pixel < image.t.size(); ++pixel) {
    if (image.holds(pixel) && image.displacement[pixel] != glm::vec2(0)) {
      return true;
    }
  }
  return false;
}

/// Whether these show the same from the same place.
bool areSameView(const ReferenceImage& a, const ReferenceImage& b) {
  const PinholeCamera first = a.reference();
  const PinholeCamera second = b.reference();
  const float scale = glm::distance(first.view().target, first.eye());
  const float near = 1e-6f * scale;
  return a.isPlaced() == b.isPlaced() && glm::distance(first.eye(), second.eye()) <= near &&
         glm::distance(first.forward(), second.forward()) <= 1e-6f &&
         glm::distance(first.right(), second.right()) <= 1e-6f &&
         first.view().centerShift == second.view().centerShift &&
         std::abs(first.view().resolvedFovVerticalDegrees() - second.view().resolvedFovVerticalDegrees()) <= 1e-6;
}

}  // namespace

void requireDepthView(const ReferenceImage& image, const std::string& where) {
  const bool isPanorama = image.isPlaced() && image.wrapsAround;
  if ((image.isPlaced() && !isPanorama) || image.rows != ImageRows::kAligned || image.tileSide > 0 || image.layer > 0 ||
      !image.layout.regions.empty() ||
      (image.pinholeSize.x > 0 && image.pinholeSize != glm::ivec2(image.width(), image.height())) ||
      (!image.isPlaced() && isDisplaced(image))) {
    throw InputError("this is a reference image of camera \"" + image.camera + "\", and no view with depth", where,
                     kNextDepthView);
  }
  if (image.sampleCount() == 0) {
    throw InputError("this view has no depth at any pixel", where, "leave it out, or check its depth");
  }
}

void requireDifferentViews(const std::vector<DepthView>& views, const std::string& where) {
  if (views.empty()) {
    throw InputError("there are no views with depth", where, kNextDepthView);
  }
  for (size_t i = 0; i < views.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (areSameView(views[i].image, views[j].image)) {
        throw InputError(
            fmt::format("views \"{}\" and \"{}\" have the same place and direction", views[j].name, views[i].name),
            where, "leave one of them out, or correct its pose");
      }
    }
  }
}

Projection projectionOf(const ReferenceImage& image) {
  if (image.isPlaced()) {
    return [camera = PanoramaCamera(image.reference())](const glm::vec3& point) { return camera.project(point); };
  }
  return [camera = image.reference()](const glm::vec3& point) { return camera.project(point); };
}

float pixelAngle(const ReferenceImage& image) {
  return image.isPlaced() ? static_cast<float>(2 * kPi / image.width()) : 1 / image.reference().focalPixels();
}

size_t sampleCount(const std::vector<DepthView>& views) {
  size_t samples = 0;
  for (const DepthView& view : views) {
    samples += view.image.sampleCount();
  }
  return samples;
}

}  // namespace ocelli
