#include "oc_core/render/identity_image.h"

#include <algorithm>
#include <array>
#include <map>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kHues = 7;
/// The palette of Okabe and Ito (2008) without black, which the background has.
constexpr std::array<Rgb8, kHues> kPalette{Rgb8{230, 159, 0},  Rgb8{86, 180, 233}, Rgb8{0, 158, 115},
                                           Rgb8{240, 228, 66}, Rgb8{0, 114, 178},  Rgb8{213, 94, 0},
                                           Rgb8{204, 121, 167}};
constexpr std::array<int, 2> kBrightnesses{100, 60};  // percent, of sRGB bytes
constexpr Rgb8 kStructureColor{40, 40, 40};

bool isObject(uint32_t identity) {
  return identity != kStructure && identity != kNothing;
}

Rgb8 falseColorOf(uint32_t identity) {
  if (!isObject(identity)) {
    return identity == kStructure ? kStructureColor : Rgb8(0);
  }
  const Rgb8& full = kPalette[(identity - 1) % kHues];
  const int brightness = kBrightnesses[(identity - 1) / kHues % kBrightnesses.size()];
  Rgb8 color;
  for (int channel = 0; channel < 3; ++channel) {
    color[channel] = static_cast<uint8_t>(full[channel] * brightness / 100);
  }
  return color;
}

/// The regions of equal objects: trees of pixels, whose roots stand for them.
class Regions {
 public:
  explicit Regions(size_t pixels) : parents_(pixels) {
    for (size_t i = 0; i < pixels; ++i) {
      parents_[i] = i;
    }
  }

  size_t rootOf(size_t pixel) {
    while (parents_[pixel] != pixel) {
      parents_[pixel] = parents_[parents_[pixel]];
      pixel = parents_[pixel];
    }
    return pixel;
  }
  void join(size_t a, size_t b) {
    const size_t rootA = rootOf(a);
    const size_t rootB = rootOf(b);
    parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }

 private:
  std::vector<size_t> parents_;
};

/// Joins each pixel of an object to those above it and to its left that show the same; the others stay alone.
Regions regionsOf(const Image<uint32_t>& identities) {
  constexpr std::array<glm::ivec2, 4> kBefore{{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Regions regions(identities.size());
  for (int y = 0; y < identities.height(); ++y) {
    for (int x = 0; x < identities.width(); ++x) {
      if (!isObject(identities(x, y))) {
        continue;
      }
      for (const glm::ivec2& step : kBefore) {
        if (identities.contains(x + step.x, y + step.y) && identities(x + step.x, y + step.y) == identities(x, y)) {
          regions.join(identities.index(x, y), identities.index(x + step.x, y + step.y));
        }
      }
    }
  }
  return regions;
}

}  // namespace

Image<uint32_t> identityImage(const FragmentImage& fragments, const std::vector<uint32_t>& objectOfTriangle) {
  Image<uint32_t> identities(fragments.width(), fragments.height(), kNothing);
  parallelFor(fragments.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (fragments[i].covered()) {
        OC_CHECK(fragments[i].triangle < objectOfTriangle.size(), "the image is of a mesh with more triangles");
        identities[i] = objectOfTriangle[fragments[i].triangle];
      }
    }
  });
  return identities;
}

std::vector<ObjectSighting> sightings(const Image<uint32_t>& identities) {
  Regions regions = regionsOf(identities);
  std::map<uint32_t, ObjectSighting> found;
  for (int y = 0; y < identities.height(); ++y) {
    for (int x = 0; x < identities.width(); ++x) {
      const size_t pixel = identities.index(x, y);
      if (!isObject(identities[pixel])) {
        continue;
      }
      const auto [place, isNew] = found.try_emplace(identities[pixel]);
      ObjectSighting& sighting = place->second;
      if (isNew) {
        sighting = {identities[pixel], 0, 0, {x, y}, {x, y}};
      }
      ++sighting.pixels;
      sighting.regions += regions.rootOf(pixel) == pixel;
      sighting.lower = {std::min(sighting.lower.x, x), std::min(sighting.lower.y, y)};
      sighting.upper = {std::max(sighting.upper.x, x), std::max(sighting.upper.y, y)};
      sighting.centroid += glm::dvec2(x + 0.5, y + 0.5);
    }
  }
  std::vector<ObjectSighting> sightings;
  for (auto& [object, sighting] : found) {
    sighting.centroid /= static_cast<double>(sighting.pixels);
    sighting.atBorder = sighting.lower.x == 0 || sighting.lower.y == 0 || sighting.upper.x == identities.width() - 1 ||
                        sighting.upper.y == identities.height() - 1;
    sightings.push_back(sighting);
  }
  return sightings;
}

Image<Rgb8> identityColors(const Image<uint32_t>& identities) {
  Image<Rgb8> image(identities.width(), identities.height());
  std::transform(identities.begin(), identities.end(), image.begin(), falseColorOf);
  return image;
}

}  // namespace ocelli
