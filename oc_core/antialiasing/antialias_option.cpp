#include "oc_core/antialiasing/antialias_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "oc_core/antialiasing/pixel_area.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

bool isSquareNumber(int samples) {
  const int side = static_cast<int>(std::lround(std::sqrt(samples)));
  return side >= 1 && side <= SamplePattern::kMaxSide && side * side == samples;
}

bool isMultisample(int samples) {
  return !multisamplePositions(samples).empty();
}

int sideOf(const AntialiasChoice& choice) {
  return static_cast<int>(std::lround(std::sqrt(choice.samples)));
}

std::shared_ptr<const SamplePattern> squarePattern(const AntialiasChoice& choice) {
  return std::make_shared<SamplePattern>(sideOf(choice), *choice.placement);
}

constexpr const char* kSquares = "a square number up to 4096";

/// As in ", 0 to 16"; empty where it is no number.
std::string rangeOf(const AntialiasKey& key) {
  return key.min < key.max ? fmt::format(", {:.10g} to {:.10g}", key.min, key.max) : "";
}

const AntialiasKey& keyNamed(std::string_view name) {
  const std::vector<AntialiasKey>& keys = antialiasKeys();
  return *std::find_if(keys.begin(), keys.end(), [&](const AntialiasKey& each) { return name == each.name; });
}

[[noreturn]] void failValue(const AntialiasKey& key, const std::string& value, const std::string& where) {
  throw InputError(fmt::format("\"{}\" is no value of {}", value, key.name), where,
                   fmt::format("give {}={}{}", key.name, key.values, rangeOf(key)));
}

bool isWithin(const AntialiasKey& key, double value) {
  return value >= key.min && value <= key.max;
}

void readPlacement(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value,
                   const std::string& where) {
  choice.placement = findSamplePlacement(value);
  if (choice.placement == nullptr) {
    failValue(key, value, where);
  }
}

void readExact(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where) {
  const std::optional<int> triangles = numberFromText<int>(value);
  if (!triangles || !isWithin(key, *triangles)) {
    failValue(key, value, where);
  }
  choice.maxExactTriangles = static_cast<size_t>(*triangles);
}

void readTile(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where) {
  const size_t cross = std::min(value.find('x'), value.size());
  const std::string_view text = value;
  // 0 where there is no number, which is no size either.
  const int width = numberFromText<int>(text.substr(0, cross)).value_or(0);
  const int height = numberFromText<int>(text.substr(std::min(cross + 1, text.size()))).value_or(0);
  if (!isWithin(key, width) || !isWithin(key, height)) {
    failValue(key, value, where);
  }
  if (int64_t{width} * height > AntialiasTile::kMaxSamples) {
    throw InputError(fmt::format("a tile of {} has {} samples", value, int64_t{width} * height), where,
                     fmt::format("give one of at most {}", AntialiasTile::kMaxSamples));
  }
  choice.tile = {width, height};
}

void readDense(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where) {
  const std::optional<double> dense = numberFromText<double>(value);
  if (!dense || !isWithin(key, *dense)) {
    failValue(key, value, where);
  }
  choice.dense = *dense;
}

void readRegions(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where) {
  if (value.ends_with(".json") || value.ends_with(".JSON")) {
    choice.requested = readRegionFile(value);
    choice.regions = "file";
  } else if (value == "auto" || value == "objects") {
    choice.regions = value;
  } else {
    failValue(key, value, where);
  }
}

void readOutside(const AntialiasKey& key, AntialiasChoice& choice, const std::string& value, const std::string& where) {
  const AntialiasChoice outside = antialiasChoice(value, where + ", outside=" + value);
  if (outside.method->hasRegions) {
    failValue(key, value, where);
  }
  choice.outside = std::make_shared<const AntialiasChoice>(outside);
}

PixelRule onePoint(const AntialiasChoice& /*choice*/) {
  return {std::make_shared<SamplePattern>(1, *findSamplePlacement("grid")), false, 0};
}

std::string methodNames() {
  std::string names;
  for (const AntialiasMethod& each : antialiasMethods()) {
    names += (names.empty() ? "" : ", ") + std::string(each.name) + (each.allows != nullptr ? "-N" : "");
  }
  return names;
}

const AntialiasMethod& methodIn(std::string_view text, AntialiasChoice& choice, const std::string& where) {
  const size_t dash = text.rfind('-');
  for (const AntialiasMethod& each : antialiasMethods()) {
    if (each.allows == nullptr && text == each.name) {
      return each;
    }
    if (each.allows != nullptr && text.substr(0, dash) == each.name) {
      const std::optional<int> samples =
          dash == std::string_view::npos ? std::nullopt : numberFromText<int>(text.substr(dash + 1));
      if (!samples || !each.allows(*samples)) {
        throw InputError(fmt::format("{} needs its number of samples a pixel: {}", each.name, each.allowed), where,
                         fmt::format("write {}-16, for example", each.name));
      }
      choice.samples = *samples;
      return each;
    }
  }
  throw InputError(fmt::format("there is no antialiasing \"{}\"", text), where, "use " + methodNames());
}

PixelBounds boxOfRequest(const RegionRequest& request, const AntialiasView& view, size_t number) {
  const glm::dvec2 size(view.width(), view.height());
  const glm::dvec2 lower = (request.center - request.extent / 2.0) * size;
  const glm::dvec2 upper = (request.center + request.extent / 2.0) * size;
  if (upper.x - lower.x < 1 || upper.y - lower.y < 1) {
    throw InputError(
        fmt::format("region {} is smaller than a pixel of an image of {}x{}", number, view.width(), view.height()),
        "--antialias", "make its \"extent\" larger");
  }
  // A pixel belongs to the region that holds any of it; what rounding adds does not count.
  constexpr double kRounded = 1e-6;
  return pixelsOf({glm::vec2(glm::floor(lower + kRounded)), glm::vec2(glm::ceil(upper - kRounded))}, view.width(),
                  view.height());
}

}  // namespace

const std::vector<AntialiasMethod>& antialiasMethods() {
  static const std::vector<AntialiasMethod> rows = {
      {"none", "one sample in the middle of each pixel", nullptr, "", {}, &onePoint},
      {"msaa",
       "multisampling as hardware does: N samples tell what covers a pixel, each triangle is shaded once in it",
       &isMultisample,
       "2, 4, 8 or 16",
       {},
       [](const AntialiasChoice& choice) {
         return PixelRule{std::make_shared<SamplePattern>(SamplePattern::multisample(choice.samples)), true, 0};
       }},
      {"uniform",
       "N samples in every pixel, with a colour each",
       &isSquareNumber,
       kSquares,
       {"placement"},
       [](const AntialiasChoice& choice) {
         return PixelRule{squarePattern(choice), false, 0};
       }},
      {"area",
       "exact areas where few triangles meet a pixel, N samples elsewhere",
       &isSquareNumber,
       kSquares,
       {"placement", "exact"},
       [](const AntialiasChoice& choice) {
         return PixelRule{squarePattern(choice), false, choice.maxExactTriangles};
       }},
      {"extreme",
       "as many samples in regions of many triangles as their off-screen tiles hold (section 5.2.3)",
       nullptr,
       "",
       {"tile", "regions", "dense", "placement", "exact", "outside"},
       [](const AntialiasChoice& choice) { return choice.outside->method->rule(*choice.outside); },
       true},
  };
  return rows;
}

const std::vector<AntialiasKey>& antialiasKeys() {
  static const std::vector<AntialiasKey> rows = {
      {"tile", "WIDTHxHEIGHT", "640x720", "size of each region's off-screen tile, samples a side", &readTile, 1,
       AntialiasTile::kMaxSide},
      {"regions", "auto|objects|FILE.json", "auto",
       "where triangles are dense, boxes around objects that are, or those of a file", &readRegions},
      {"dense", "NUMBER", "1", "triangles a pixel from which on there is a region, where no file says so", &readDense,
       0, 1e6},
      {"placement", "grid|sheared|slanted|multijittered|jittered", "slanted", "how samples lie in their pixel",
       &readPlacement},
      {"exact", "NUMBER", "4", "pixels that at most so many triangles meet are averaged by area", &readExact, 0,
       PixelArea::kMaxTriangles},
      {"outside", "METHOD", "area-16",
       "how pixels outside of the regions are drawn: another of these ways, without keys of its own", &readOutside},
  };
  return rows;
}

std::string describeAntialiasKey(const AntialiasKey& key) {
  return fmt::format("{}{}; {}", key.description, rangeOf(key), key.standard);
}

std::string antialiasHelp() {
  std::string help;
  for (const AntialiasMethod& each : antialiasMethods()) {
    help += fmt::format("\n  {}{}: {}", each.name, each.allows != nullptr ? "-N" : "", each.description);
    if (each.allows != nullptr) {
      help += fmt::format("; N is {}", each.allowed);
    }
    for (const char* key : each.keys) {
      help += fmt::format("{}{}", key == each.keys.front() ? " [" : ", ", key);
    }
    help += each.keys.empty() ? "" : "]";
  }
  for (const AntialiasKey& each : antialiasKeys()) {
    help += fmt::format("\n  {}={}: {}", each.name, each.values, describeAntialiasKey(each));
  }
  return help;
}

AntialiasChoice antialiasChoice(const std::string& text, const std::string& where) {
  AntialiasChoice choice;
  choice.text = text;
  const size_t nameEnd = std::min(text.find(','), text.size());
  choice.method = &methodIn(std::string_view(text).substr(0, nameEnd), choice, where);
  const std::vector<const char*>& keys = choice.method->keys;
  for (const char* name : keys) {
    const AntialiasKey& key = keyNamed(name);
    key.read(key, choice, key.standard, where);
  }
  std::vector<std::string> given;
  for (size_t start = nameEnd; start < text.size();) {
    const size_t end = std::min(text.find(',', start + 1), text.size());
    const std::string pair = text.substr(start + 1, end - start - 1);
    const std::string name = pair.substr(0, pair.find('='));
    const bool isKnown = std::any_of(keys.begin(), keys.end(), [&](const char* key) { return name == key; });
    if (!isKnown || pair.find('=') == std::string::npos) {
      std::string known;
      for (const char* key : keys) {
        known += (known.empty() ? "" : ", ") + std::string(key) + "=" + keyNamed(key).values;
      }
      throw InputError(fmt::format("\"{}\" is nothing that can be said of {}", pair, choice.method->name), where,
                       keys.empty() ? "leave it out" : "use " + known);
    }
    if (std::find(given.begin(), given.end(), name) != given.end()) {
      throw InputError(fmt::format("\"{}\" stands twice", name), where, "leave one of them out");
    }
    given.push_back(name);
    const AntialiasKey& key = keyNamed(name);
    key.read(key, choice, pair.substr(name.size() + 1), where);
    start = end;
  }
  if (choice.regions == "file" && std::find(given.begin(), given.end(), "dense") != given.end()) {
    throw InputError("a file says where its regions are, whatever is dense", where, "leave dense= or the file out");
  }
  return choice;
}

std::vector<AntialiasRegion> antialiasRegions(const AntialiasChoice& choice, const AntialiasScene& scene,
                                              const std::vector<uint32_t>& objectOfTriangle) {
  std::vector<AntialiasRegion> regions;
  if (!choice.method->hasRegions) {
    return regions;
  }
  for (size_t i = 0; i < choice.requested.size(); ++i) {
    const RegionRequest& request = choice.requested[i];
    regions.push_back(fittedRegion(scene, boxOfRequest(request, scene.view(), i + 1), choice.tile));
    regions.back().side = request.side > 0 ? request.side : regions.back().side;
  }
  if (choice.regions == "objects" &&
      std::all_of(objectOfTriangle.begin(), objectOfTriangle.end(), [](uint32_t object) { return object == 0; })) {
    throw InputError("no triangle of the scene is an object's: there is nothing to lay boxes around", "--antialias",
                     "use regions=auto, or regions=FILE.json");
  }
  if (choice.regions != "file") {
    for (const PixelBounds& box : choice.regions == "objects" ? objectRectangles(scene, objectOfTriangle, choice.dense)
                                                              : denseRectangles(scene, choice.dense)) {
      regions.push_back(fittedRegion(scene, box, choice.tile));
    }
  }
  int64_t samples = 0;
  for (const AntialiasRegion& each : regions) {
    samples += int64_t{each.box.x1 - each.box.x0} * (each.box.y1 - each.box.y0) * each.side * each.side;
  }
  if (samples > kMaxRegionSamples) {
    throw InputError(fmt::format("its {} regions have {} samples together", regions.size(), samples), "--antialias",
                     fmt::format("give fewer regions, fewer samples a side, or smaller tiles: at most {} samples",
                                 kMaxRegionSamples));
  }
  return regions;
}

AntialiasPlan antialiasPlan(const AntialiasChoice& choice, const AntialiasView& view,
                            const std::vector<AntialiasRegion>& regions) {
  const PixelRule rule = choice.method->rule(choice);
  return choice.method->hasRegions ? regionPlan(view, regions, *choice.placement, choice.maxExactTriangles, rule)
                                   : AntialiasPlan{{rule}, {}};
}

SamplePattern rayPattern(const AntialiasChoice& choice, const std::string& where) {
  const PixelRule rule = choice.method->rule(choice);
  if (choice.method->hasRegions || rule.shadesAtMiddle || rule.maxExactTriangles > 0) {
    throw InputError(fmt::format("{} is for pinholes and general pinholes that are rasterised", choice.method->name),
                     where, "use uniform-N, which casts N rays a pixel of any camera");
  }
  return *rule.pattern;
}

}  // namespace ocelli
