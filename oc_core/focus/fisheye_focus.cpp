#include "oc_core/focus/fisheye_focus.h"

#include <glm/geometric.hpp>

namespace ocelli {
namespace {

class FisheyeFocusMap final : public FocusMap {
 public:
  FisheyeFocusMap(const GpcLayout& layout, const glm::ivec2& size) {
    const std::vector<FocusBox> places = focusPlaces(layout, size);
    for (size_t i = 0; i < places.size(); ++i) {
      const double outer = layout.regions[i].outer();
      lenses_.push_back({places[i].center, places[i].half * outer,
                         fisheyeDistortion(static_cast<double>(layout.regions[i].zoom), outer)});
    }
  }

  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override {
    for (const Lens& lens : lenses_) {
      const glm::dvec2 off = picture - lens.center;
      if (const double y = glm::length(off / lens.half); y < 1) {
        return lens.center + off / (lens.distortion + 1 - lens.distortion * y);  // x / y
      }
    }
    return picture;
  }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override {
    for (const Lens& lens : lenses_) {
      const glm::dvec2 off = plain - lens.center;
      if (const double x = glm::length(off / lens.half); x < 1) {
        return lens.center + off * ((lens.distortion + 1) / (lens.distortion * x + 1));  // g(x) / x
      }
    }
    return plain;
  }

 private:
  struct Lens {
    glm::dvec2 center;
    glm::dvec2 half;  ///< of the ellipse
    double distortion;
  };
  std::vector<Lens> lenses_;
};

}  // namespace

double fisheyeDistortion(double zoom, double outer) {
  return (zoom - 1) * outer / (outer - 1);
}

std::unique_ptr<FocusMap> fisheyeFocusMap(const GpcLayout& layout, const glm::ivec2& size) {
  return std::make_unique<FisheyeFocusMap>(layout, size);
}

}  // namespace ocelli
