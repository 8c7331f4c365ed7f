#include "oc_core/focus/inset_focus.h"

namespace ocelli {
namespace {

class InsetFocusMap final : public FocusMap {
 public:
  InsetFocusMap(const GpcLayout& layout, const glm::ivec2& size)
      : places_(focusPlaces(layout, size)), contents_(focusContents(layout, size)) {}

  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override {
    for (size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].contains(picture)) {
        return contents_[i].center + (picture - places_[i].center) * (contents_[i].half / places_[i].half);
      }
    }
    return picture;
  }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override {
    for (size_t i = 0; i < places_.size(); ++i) {
      if (contents_[i].contains(plain)) {
        return places_[i].center + (plain - contents_[i].center) * (places_[i].half / contents_[i].half);
      }
      if (places_[i].contains(plain)) {
        return std::nullopt;  // covered
      }
    }
    return plain;
  }

 private:
  std::vector<FocusBox> places_;
  std::vector<FocusBox> contents_;
};

}  // namespace

std::unique_ptr<FocusMap> insetFocusMap(const GpcLayout& layout, const glm::ivec2& size) {
  return std::make_unique<InsetFocusMap>(layout, size);
}

}  // namespace ocelli
