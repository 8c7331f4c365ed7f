#include "oc_core/antialiasing/antialias_view.h"

namespace ocelli {

ImageBox AntialiasView::movedBox(const ImageBox& inReference) const {
  ImageBox box = inReference;
  for (const GpcZone& zone : camera_->map().zones()) {
    const glm::vec2 lower(zone.center() - zone.outerHalf());
    const glm::vec2 upper(zone.center() + zone.outerHalf());
    if (glm::all(glm::lessThan(inReference.lower, upper)) && glm::all(glm::greaterThan(inReference.upper, lower))) {
      const ImageBox moved = zone.imageBox(inReference);
      box = {glm::min(box.lower, moved.lower), glm::max(box.upper, moved.upper)};
    }
  }
  return box;
}

AntialiasView::PixelArea AntialiasView::areaOf(int x, int y) const {
  const glm::dvec2 corner(x, y);
  if (!camera_) {
    return {true, corner, 1};
  }
  for (const GpcZone& zone : camera_->map().zones()) {
    const glm::dvec2 outer = zone.outerHalf();
    if (corner.x + 1 <= zone.center().x - outer.x || corner.x >= zone.center().x + outer.x ||
        corner.y + 1 <= zone.center().y - outer.y || corner.y >= zone.center().y + outer.y) {
      continue;
    }
    const glm::dvec2 inner = zone.half();
    const bool isInside = corner.x >= zone.center().x - inner.x && corner.x + 1 <= zone.center().x + inner.x &&
                          corner.y >= zone.center().y - inner.y && corner.y + 1 <= zone.center().y + inner.y;
    if (!isInside) {
      return {false, corner, 1};
    }
    return {true, zone.pinholeFromImage(corner), 1 / zone.profile().zoom()};
  }
  return {true, corner, 1};
}

}  // namespace ocelli
