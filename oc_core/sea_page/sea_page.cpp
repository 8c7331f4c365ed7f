#include "oc_core/sea_page/sea_page.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <span>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/utf8.h"
#include "oc_core/image_codecs/jpeg_codec.h"
#include "oc_core/page/page_colors.h"
#include "oc_core/sea_page/embedded_sea_page.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// A frame whose y axis is the mean of all ups, for a map seen from above.
struct MapFrame {
  glm::dvec3 x{1, 0, 0};
  glm::dvec3 y{0, 1, 0};
  glm::dvec3 z{0, 0, 1};

  Json of(const glm::dvec3& v) const {
    // Seven digits after the point serve metres and unit spheres.
    const auto rounded = [](double value) { return std::round(value * 1e7) / 1e7; };
    return {rounded(glm::dot(x, v)), rounded(glm::dot(y, v)), rounded(glm::dot(z, v))};
  }
};

[[noreturn]] void refusePlace(size_t index, const std::string& problem, const std::string& next) {
  throw InputError(problem, fmt::format("place {} of the sea", index), next);
}

void validatePlaces(const SeaPage& page) {
  if (page.places.empty()) {
    throw InputError("this sea has no places", page.title, "give one with images");
  }
  for (size_t k = 0; k < page.places.size(); ++k) {
    const SeaPagePlace& place = page.places[k];
    if (!isFinite(place.eye) || !isFinite(place.forward) || !isFinite(place.up)) {
      refusePlace(k, "its numbers are not finite", "give its position and axes as numbers");
    }
    const double across = glm::length(glm::cross(place.forward, place.up));
    if (!(across > 1e-6 * glm::length(place.forward) * glm::length(place.up))) {
      refusePlace(k, "its directions forward and up are parallel, or one has no length",
                  "give two directions across each other");
    }
    if (page.proxy && !contains(*page.proxy, glm::vec3(place.eye))) {
      refusePlace(k, "it lies outside of the proxy", "give a box that holds all places, or none");
    }
  }
}

MapFrame mapFrameOf(const SeaPage& page) {
  glm::dvec3 up(0);
  for (const SeaPagePlace& place : page.places) {
    up += glm::normalize(place.up);
  }
  if (!(glm::length(up) > 0.1 * static_cast<double>(page.places.size()))) {
    throw InputError("the directions up of its images have nothing in common", page.title,
                     "turn the poses so that up is up");
  }
  MapFrame frame;
  frame.y = glm::normalize(up);
  const glm::dvec3 start = std::abs(frame.y.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  frame.x = glm::normalize(start - frame.y * glm::dot(start, frame.y));
  frame.z = glm::cross(frame.x, frame.y);
  return frame;
}

/// The mean distance from each place to the next.
double meanSpacing(const std::vector<SeaPagePlace>& places) {
  double sum = 0;
  for (size_t k = 0; k + 1 < places.size(); ++k) {
    sum += glm::distance(places[k].eye, places[k + 1].eye);
  }
  return places.size() > 1 ? sum / static_cast<double>(places.size() - 1) : 0;
}

Json describe(const SeaPage& page) {
  const MapFrame frame = mapFrameOf(page);
  Json places = Json::array();
  for (const SeaPagePlace& place : page.places) {
    const glm::dvec3 forward = glm::normalize(place.forward);
    const glm::dvec3 up = glm::normalize(place.up - forward * glm::dot(forward, place.up));
    places.push_back({{"eye", frame.of(place.eye)}, {"forward", frame.of(forward)}, {"up", frame.of(up)}});
  }
  Json proxy = nullptr;
  if (page.proxy) {
    // Its axes in the frame of the map: the box is that of the scene.
    proxy = {{"lower", {page.proxy->lower.x, page.proxy->lower.y, page.proxy->lower.z}},
             {"upper", {page.proxy->upper.x, page.proxy->upper.y, page.proxy->upper.z}},
             {"axes", {frame.of({1, 0, 0}), frame.of({0, 1, 0}), frame.of({0, 0, 1})}}};
  }
  return {
      {"title", cleanText(page.title)}, {"spacing", meanSpacing(page.places)}, {"places", places}, {"proxy", proxy}};
}

std::string base64Of(std::span<const std::byte> bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t three = 0;
    for (size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<uint32_t>(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

void writeText(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

void writeSeaPage(const SeaPage& page, const std::function<Image<Rgb8>(size_t)>& imageOf,
                  const std::filesystem::path& folder, const Progress& progress) {
  validatePlaces(page);
  const Json description = describe(page);
  makeFolder(folder / "images");
  for (const EmbeddedFile& file : embeddedSeaPage()) {
    const std::string colors = file.name.ends_with(".css") ? pageColorsStyle(PageScheme::kDark) : std::string();
    writeText(folder / file.name, colors + std::string(file.bytes));
  }
  writeText(folder / "sea.js", "ocelliSea.open(" + description.dump() + ");\n");
  const size_t count = page.places.size();
  for (size_t k = 0; k < count; ++k) {
    report(progress, "writing the page", static_cast<double>(k) / static_cast<double>(count));
    const Image<Rgb8> image = imageOf(k);
    if (image.empty()) {
      refusePlace(k, "its image has no pixels", "give an image for each place");
    }
    writeText(folder / "images" / fmt::format("{:05}.js", k),
              fmt::format("ocelliSea.take({}, \"data:image/jpeg;base64,{}\");\n", k,
                          base64Of(encodeJpeg(image, page.quality))));
  }
  report(progress, "writing the page", 1);
}

}  // namespace ocelli
