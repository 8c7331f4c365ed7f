#include "display_sim/quilt/panel_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

using Json = nlohmann::json;

class CalibrationReader {
 public:
  CalibrationReader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
    if (!json.is_object()) {
      throw InputError("a calibration is an object of fields", where_, kNext);
    }
  }

  std::optional<double> find(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end()) {
      return std::nullopt;
    }
    const Json& value = found->is_object() && found->contains("value") ? (*found)["value"] : *found;
    if (!value.is_number()) {
      throw InputError(fmt::format("\"{}\" is no number", name), where_, kNext);
    }
    return value.get<double>();
  }
  double number(const char* name, double min, double max) const {
    const std::optional<double> value = find(name);
    if (!value) {
      throw InputError(fmt::format("\"{}\" is missing", name), where_, kNext);
    }
    if (!(*value >= min && *value <= max)) {
      throw InputError(fmt::format("\"{}\" must be between {:g} and {:g}", name, min, max), where_, kNext);
    }
    return *value;
  }

 private:
  static constexpr const char* kNext = "give the calibration file of the display, such as visual.json";
  const Json& json_;
  std::string where_;
};

/// What panelPicture() takes for granted.
struct FixedField {
  const char* name;
  double value;
};
constexpr std::array<FixedField, 4> kFixedFields{
    {{"flipImageX", 0}, {"flipImageY", 0}, {"flipSubp", 0}, {"invView", 1}}};

/// Between the four pixels of a tile around a place in it, of one channel.
uint8_t colorIn(const Image<Rgb8>& quilt, const glm::ivec2& origin, const glm::ivec2& size, double u, double v,
                int channel) {
  const auto along = [](double share, int count) { return std::clamp(share * count - 0.5, 0.0, count - 1.0); };
  const double x = along(u, size.x);
  const double y = along(v, size.y);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, size.x - 1);
  const int y1 = std::min(y0 + 1, size.y - 1);
  const auto at = [&](int px, int py) { return static_cast<double>(quilt(origin.x + px, origin.y + py)[channel]); };
  const double fx = x - x0;
  const double upper = at(x0, y0) + (at(x1, y0) - at(x0, y0)) * fx;
  const double lower = at(x0, y1) + (at(x1, y1) - at(x0, y1)) * fx;
  return static_cast<uint8_t>(std::lround(upper + (lower - upper) * (y - y0)));
}

}  // namespace

PanelCalibration calibrationFromJsonText(const std::string& text, const std::string& where) {
  const Json json = parseJson(text, where);
  const CalibrationReader reader(json, where);
  PanelCalibration panel;
  panel.pitch = reader.number("pitch", 1e-6, 1e6);
  panel.slope = reader.number("slope", -1e6, 1e6);
  panel.center = reader.number("center", -1e6, 1e6);
  panel.dotsPerInch = reader.number("DPI", 1, 1e5);
  panel.width = static_cast<int>(reader.number("screenW", 1, kMaxQuiltSide));
  panel.height = static_cast<int>(reader.number("screenH", 1, kMaxQuiltSide));
  if (panel.slope == 0) {
    throw InputError("\"slope\" is 0: lenses that lie along the rows show no views", where,
                     "give the slope of the lenses");
  }
  if (reader.find("viewCone")) {
    panel.coneDegrees = reader.number("viewCone", kMinConeDegrees, kMaxConeDegrees);
  }
  for (const FixedField& field : kFixedFields) {
    if (const std::optional<double> value = reader.find(field.name); value && *value != field.value) {
      panel.unused.push_back(fmt::format("\"{}\": {:g}", field.name, *value));
    }
  }
  return panel;
}

PanelCalibration readCalibration(const std::filesystem::path& path) {
  return calibrationFromJsonText(readJsonFile(path).dump(), path.string());
}

QuiltDisplay withCone(QuiltDisplay display, const std::optional<PanelCalibration>& calibration,
                      std::optional<double> coneDegrees) {
  if (!coneDegrees && calibration) {
    coneDegrees = calibration->coneDegrees;
  }
  display.coneDegrees = coneDegrees.value_or(display.coneDegrees);
  validate(display, "display \"" + display.name + "\"");
  return display;
}

double viewShareOf(const PanelCalibration& panel, double x, double y, int channel) {
  const double across = x + channel / (3.0 * panel.width) + y * panel.height / (panel.width * panel.slope);
  const double lenses = across * panel.pitch * panel.width / panel.dotsPerInch * std::cos(std::atan(1 / panel.slope));
  const double place = lenses - panel.center;
  return 1 - (place - std::floor(place));
}

Image<Rgb8> panelPicture(const Image<Rgb8>& quilt, const QuiltDisplay& display, const PanelCalibration& panel) {
  OC_CHECK(quilt.width() == display.width && quilt.height() == display.height, "the quilt is that of the display");
  Image<Rgb8> picture(panel.width, panel.height);
  const glm::ivec2 size(display.tileWidth(), display.tileHeight());
  parallelFor(static_cast<size_t>(panel.height), 8, [&](size_t begin, size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      const double v = (row + 0.5) / panel.height;  // downwards
      for (int column = 0; column < panel.width; ++column) {
        const double u = (column + 0.5) / panel.width;
        for (int channel = 0; channel < 3; ++channel) {
          const double share = viewShareOf(panel, u, 1 - v, channel);
          const int view = std::min(static_cast<int>(share * display.viewCount()), display.viewCount() - 1);
          picture(column, row)[channel] = colorIn(quilt, tileOriginOf(display, view), size, u, v, channel);
        }
      }
    }
  });
  return picture;
}

}  // namespace ocelli
