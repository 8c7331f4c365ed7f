// A picture of what moves (moving_pictures.h), in a pane.
#pragma once

#include "display_sim/viewer/moving_pictures.h"
#include "display_sim/viewer/shown_picture.h"

namespace ocelli {

template <class Wanted>
class PicturePane {
 public:
  explicit PicturePane(GlContext& context) : shown_(context) {}

  /// Returns whether it drew: not where nothing has changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const MovingPictureStatus<Wanted>& status, const glm::ivec2& size) {
    const ReconstructionPane::Place place = placeOf(state, status, size);
    const Key key{status.picture, size, place.size};
    if (key == drawn_) {
      return false;
    }
    drawn_ = key;
    shown_.draw(status.picture ? &status.picture->image : nullptr, place, size);
    return true;
  }

  const PaneTarget& target() const { return shown_.target(); }

 private:
  /// Where all pictures of the user's eye lie; that of a camera whose image is of another shape, such as a panorama, by
  /// itself.
  static ReconstructionPane::Place placeOf(const ViewerState& state, const MovingPictureStatus<Wanted>& status,
                                           const glm::ivec2& size) {
    constexpr double kSameShape = 1.15;  // small pictures of the same shape are rounded to whole pixels
    const ReconstructionPane::Place place = picturePlace(state, size);
    if (!status.picture) {
      return place;
    }
    const Image<Rgb8>& image = status.picture->image;
    const double shape = static_cast<double>(image.width()) / image.height();
    const double change = shape * place.size.y / place.size.x;
    return change > kSameShape || change < 1 / kSameShape ? placesBeside(size, shape, 1).front() : place;
  }

  /// What the image was drawn for.
  struct Key {
    std::shared_ptr<const MovingPicture<Wanted>> picture;
    glm::ivec2 size{0};
    glm::ivec2 placed{0};
    bool operator==(const Key&) const = default;
  };
  ShownPicture shown_;
  std::optional<Key> drawn_;
};

}  // namespace ocelli
