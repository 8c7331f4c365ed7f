// What is drawn with antialiasing, as a pinhole whose pixels lie elsewhere: the pinhole itself, or a general pinhole,
// whose samples are rays of the same eye. Triangles are tested in the image of the reference pinhole, where their edges
// are straight.
#pragma once

#include <memory>

#include "oc_core/camera/gpc_camera.h"

namespace ocelli {

class AntialiasView {
 public:
  /// NOLINTNEXTLINE(google-explicit-constructor): a camera is such a view.
  AntialiasView(const PinholeCamera& camera) : reference_(camera) {}
  /// NOLINTNEXTLINE(google-explicit-constructor)
  AntialiasView(const GpcCamera& camera)
      : reference_(camera.reference()), camera_(std::make_shared<const GpcCamera>(camera)) {}

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const PinholeCamera& reference() const { return reference_; }

  /// Around the image of what the reference shows in a box; never too small. Pixels.
  ImageBox imageBox(const ImageBox& inReference) const { return camera_ ? movedBox(inReference) : inReference; }
  /// The point of the reference's image that a point of the image shows.
  glm::dvec2 referencePoint(const glm::dvec2& image) const {
    return camera_ ? camera_->map().pinholeFromImage(image) : image;
  }

  /// What a pixel shows, in pixels of the reference.
  struct PixelArea {
    bool isSquare = true;  ///< with edges along the axes; otherwise bent, and the rest says nothing
    glm::dvec2 corner{0};  ///< at the top left
    double side = 1;
  };
  PixelArea areaOf(int x, int y) const;

 private:
  ImageBox movedBox(const ImageBox& inReference) const;

  PinholeCamera reference_;
  std::shared_ptr<const GpcCamera> camera_;  ///< none for the pinhole itself
};

}  // namespace ocelli
