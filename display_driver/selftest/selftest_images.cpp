#include "display_driver/selftest/selftest_images.h"

#include <algorithm>
#include <cmath>

#include "display_sim/observing/observer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/image/png_file.h"

namespace ocelli {
namespace {

struct Place {
  PatternView view;
  const char* id;
  const char* name;
  glm::vec3 direction;
};

const float kHalf = static_cast<float>(std::sqrt(0.5));
const Place kPlaces[] = {
    {PatternView::kFront, "front", "From the front", {0, 0, 1}},
    {PatternView::kRaised, "raised", "From the front, 45 degrees up", {0, kHalf, kHalf}},
    {PatternView::kRight, "right", "From the right", {1, 0, 0}},
    {PatternView::kAbove, "above", "From above, the front at the bottom", {0, 1, 0}},
};

/// Holds the sphere around the display's cylinder.
double fovOfWholeDisplay(const DisplayProfile& profile) {
  constexpr double kMargin = 1.02;
  const double radius = std::hypot(1.0, profile.halfHeightRadii);
  return 2 * degreesFromRadians(std::asin(std::min(0.99, kMargin * radius / profile.viewingDistanceRadii())));
}

/// Brings the median of what is lit to a middle grey, so that faint parts show beside bright ones.
Image<Rgb8> toned(Image<glm::vec3> light) {
  constexpr double kMedian = 0.5;
  std::vector<float> lit;
  for (const glm::vec3& pixel : light) {
    if (const float most = std::max({pixel.r, pixel.g, pixel.b}); most > 0) {
      lit.push_back(most);
    }
  }
  if (!lit.empty()) {
    const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
    std::nth_element(lit.begin(), middle, lit.end());
    applyTone(light, {.gain = kMedian / *middle, .curve = ToneCurve::kReinhard});
  }
  return srgbFromLinear(light);
}

/// Pixels as squares of whole pixels, at least `side` wide where the image is smaller.
Image<Rgb8> enlarged(const Image<Rgb8>& image, int side) {
  const int factor = std::max(1, side / std::max(image.width(), image.height()));
  Image<Rgb8> large(image.width() * factor, image.height() * factor);
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) {
      large(x, y) = image(x / factor, y / factor);
    }
  }
  return large;
}

Image<Rgb8> seenFrom(const Place& place, const Volume& volume, int side) {
  ObserverOptions options;
  options.eye = static_cast<float>(volume.profile().viewingDistanceRadii()) * place.direction;
  options.width = side;
  options.height = side;
  options.fovVerticalDegrees = fovOfWholeDisplay(volume.profile());
  // A flat screen is dark from its edge; here the pattern is to be seen, wherever it lies.
  options.emission.model = EmissionModel::kEven;
  return toned(collectLight(volume, options));
}

}  // namespace

std::vector<SelftestImage> writeSelftestImages(const Volume& volume, const std::filesystem::path& folder,
                                               const std::string& name, int side) {
  std::vector<SelftestImage> images;
  for (const Place& place : kPlaces) {
    const std::string file = name + "-" + place.id + ".png";
    writePng(folder / file, seenFrom(place, volume, side));
    images.push_back({file, place.name, side, side});
  }
  const Image<Rgb8> first = enlarged(sliceImage(volume, 0), side);
  const std::string file = name + "-slice.png";
  writePng(folder / file, first);
  images.push_back({file, "Slice 0, as it is sent", first.width(), first.height()});
  return images;
}

std::vector<SelftestImage> writeWrongImages(const TestPattern& pattern, const DisplayProfile& profile,
                                            const std::filesystem::path& folder, int side) {
  const Volume sent = pattern.volume(profile);
  std::vector<SelftestImage> images;
  for (size_t i = 0; i < pattern.wrong.size(); ++i) {
    const WrongLook& wrong = pattern.wrong[i];
    images.emplace_back();
    if (wrong.shown != nullptr) {
      const Place& place = *std::ranges::find(kPlaces, wrong.view, &Place::view);
      const std::string file = pattern.name + "-wrong-" + std::to_string(i) + ".png";
      writePng(folder / file, seenFrom(place, wrong.shown(sent), side));
      images.back() = {file, place.name, side, side};
    }
  }
  return images;
}

}  // namespace ocelli
