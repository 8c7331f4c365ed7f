#include "oc_core/image_codecs/depth_prediction.h"

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Of a pixel whose neighbours above and to the left are known.
int predictionAt(const Image<uint16_t>& image, int x, int y) {
  const int a = x > 0 ? image(x - 1, y) : 0;
  const int b = y > 0 ? image(x, y - 1) : 0;
  const int c = x > 0 && y > 0 ? image(x - 1, y - 1) : 0;
  return medianPrediction(a, b, c);
}

}  // namespace

std::vector<std::byte> depthResiduals(const Image<uint16_t>& image) {
  const size_t count = image.size();
  std::vector<std::byte> planes(2 * count);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const auto signedRest = static_cast<int16_t>(static_cast<uint16_t>(image(x, y) - predictionAt(image, x, y)));
      const auto folded = static_cast<uint16_t>(signedRest >= 0 ? 2 * signedRest : -2 * signedRest - 1);
      const size_t pixel = image.index(x, y);
      planes[pixel] = static_cast<std::byte>(folded >> 8);
      planes[count + pixel] = static_cast<std::byte>(folded & 0xff);
    }
  }
  return planes;
}

Image<uint16_t> depthFromResiduals(std::span<const std::byte> residuals, glm::ivec2 size) {
  Image<uint16_t> image(size.x, size.y);
  const size_t count = image.size();
  OC_CHECK(residuals.size() == 2 * count, "there are two bytes for each pixel");
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const size_t pixel = image.index(x, y);
      const int folded = static_cast<int>(residuals[pixel]) << 8 | static_cast<int>(residuals[count + pixel]);
      const int rest = (folded & 1) == 0 ? folded >> 1 : -(folded >> 1) - 1;
      image(x, y) = static_cast<uint16_t>(predictionAt(image, x, y) + rest);
    }
  }
  return image;
}

}  // namespace ocelli
