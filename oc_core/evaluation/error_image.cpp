#include "oc_core/evaluation/error_image.h"

namespace ocelli {
namespace {

constexpr float kDimmed = 0.45f;

/// Grey and dim, so that the false colours stand out.
Rgb8 dimmed(const Rgb8& c) {
  const float grey =
      0.299f * static_cast<float>(c.x) + 0.587f * static_cast<float>(c.y) + 0.114f * static_cast<float>(c.z);
  return Rgb8(static_cast<uint8_t>(kDimmed * grey));
}

}  // namespace

Image<Rgb8> errorImage(const ViewFrame& truth, const FrameComparison& comparison) {
  Image<Rgb8> image(truth.image.width(), truth.image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    if (comparison.wrongFronts[i] != 0) {
      image[i] = kWrongFrontColor;
    } else if (comparison.falseSkins[i] != 0) {
      image[i] = kFalseSkinColor;
    } else if (comparison.states[i] == SampleState::kMissingThick) {
      image[i] = kMissingThickColor;
    } else if (comparison.states[i] == SampleState::kMissing) {
      image[i] = kMissingColor;
    } else {
      image[i] = dimmed(truth.image[i]);
    }
  }
  return image;
}

}  // namespace ocelli
