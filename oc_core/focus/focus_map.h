// What a picture that shows foci in their context has to do with the plain view of the same eye: a map between the two
// images. Nothing else of a way to show foci is known to what measures and draws it.
//
// The plain view is a pinhole's image. A lens (a region of a general pinhole's layout, gpc_layout.h) says what is in
// focus, and how large it is to be: the rectangle around its centre that is 1 / zoom as large as the region, and that
// is shown as large as the region, in its place. All of the plain view that is in no focus is context.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "oc_core/camera/gpc_layout.h"

namespace ocelli {

/// Both images have the same size; places are in pixels from the top left corner.
class FocusMap {
 public:
  virtual ~FocusMap() = default;

  /// What the picture shows at a place, as a place of the plain view.
  virtual glm::dvec2 plainFromPicture(const glm::dvec2& picture) const = 0;
  /// Where the picture shows a place of the plain view; nothing where it does not.
  virtual std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const = 0;
};

/// A rectangle in pixels.
struct FocusBox {
  glm::dvec2 center{0};
  glm::dvec2 half{0};

  bool contains(const glm::dvec2& p) const {
    const glm::dvec2 off = p - center;
    return std::max(off.x, -off.x) <= half.x && std::max(off.y, -off.y) <= half.y;
  }
};

/// The regions of the layout: where pictures show their foci. Pixels of an image of this size.
std::vector<FocusBox> focusPlaces(const GpcLayout& layout, const glm::ivec2& size);
/// What is in focus, in the plain view.
std::vector<FocusBox> focusContents(const GpcLayout& layout, const glm::ivec2& size);

/// Throws InputError where the layout has no regions, or one with a zoom of at most 1: which is no focus.
void requireFoci(const GpcLayout& layout, const std::string& where);

}  // namespace ocelli
