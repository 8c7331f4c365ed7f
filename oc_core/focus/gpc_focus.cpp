#include "oc_core/focus/gpc_focus.h"

#include "oc_core/camera/gpc_map.h"

namespace ocelli {
namespace {

class GpcFocusMap final : public FocusMap {
 public:
  GpcFocusMap(const GpcLayout& layout, const glm::ivec2& size) : map_(layout, size.x, size.y) {}

  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override { return map_.pinholeFromImage(picture); }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override {
    return map_.imageFromPinhole(plain);
  }

 private:
  GpcMap map_;
};

}  // namespace

std::unique_ptr<FocusMap> gpcFocusMap(const GpcLayout& layout, const glm::ivec2& size) {
  return std::make_unique<GpcFocusMap>(layout, size);
}

}  // namespace ocelli
