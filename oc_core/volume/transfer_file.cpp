#include "oc_core/volume/transfer_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/image/color.h"
#include "oc_core/image/color_text.h"
#include "oc_core/volume/volume_percentiles.h"

namespace ocelli {
namespace {

using TransferJson = nlohmann::ordered_json;

/// Percentiles that stand for 0 and 1 (transferScales()).
constexpr double kLowPercentile = 1;
constexpr double kHighPercentile = 99;

ValueRange absoluteValues(const ScalarVolume& /*volume*/) {
  return {0, 1};
}

ValueRange percentileRange(const ScalarVolume& volume) {
  const std::vector<double> values = percentilesOf(volume, std::array{kLowPercentile, kHighPercentile});
  // A mask, say, whose foreground is less than 1 % of its voxels.
  return values[0] < values[1] ? ValueRange{values[0], values[1]} : valueRange(volume);
}

const TransferScale& scaleOf(const std::string& name) {
  const auto found = std::ranges::find(transferScales(), name, &TransferScale::name);
  OC_CHECK(found != transferScales().end(), "a description has one of the scales");
  return *found;
}

std::vector<std::string> scaleNames() {
  std::vector<std::string> names;
  for (const TransferScale& scale : transferScales()) {
    names.emplace_back(scale.name);
  }
  return names;
}

glm::dvec3 readColor(JsonFields& fields) {
  if (!fields.has("color")) {
    return TransferPoint().color;
  }
  if (fields.value("color").is_string()) {
    const std::optional<glm::vec3> color = linearFromColorText(fields.text("color"));
    if (!color) {
      fields.fail("color", "must be of the form \"#rrggbb\", in hexadecimal digits");
    }
    return *color;
  }
  if (!fields.value("color").is_array()) {
    fields.fail("color", "must be a text \"#rrggbb\", or an array of 3 numbers between 0 and 1 (sRGB)");
  }
  const std::vector<double> encoded = fields.numbers("color", 3, 0, 1);
  return linearFromSrgb(glm::vec3(encoded[0], encoded[1], encoded[2]));
}

/// As bytes of sRGB where these stand for it, to a float's precision; else as numbers.
TransferJson jsonOfColor(const glm::dvec3& linear) {
  std::array<uint8_t, 3> bytes{};
  bool isExact = true;
  TransferJson numbers = TransferJson::array();
  for (int channel = 0; channel < 3; ++channel) {
    const auto value = static_cast<float>(linear[channel]);
    const uint8_t byte = srgbByteFromLinear(value);
    bytes[static_cast<size_t>(channel)] = byte;
    isExact = isExact && std::abs(linearFromSrgbByte(byte) - value) <= 1e-6f;
    numbers.push_back(std::round(double(srgbFromLinear(std::clamp(value, 0.0f, 1.0f))) * 1e6) / 1e6);
  }
  if (!isExact) {
    return numbers;
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

/// With 9 digits: 0.1 + 0.2 is written as 0.3.
double shortened(double value) {
  if (value == 0) {
    return 0;
  }
  const double unit = std::pow(10, 8 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(unit) && unit > 0 ? std::round(value * unit) / unit : value;
}

VolumeShading readShading(JsonFields& fields) {
  using Limits = TransferDescription;
  VolumeShading shading;
  shading.isOn = fields.boolean("on", true);
  shading.ambient = fields.number("ambient", 0, Limits::kMaxShade, shading.ambient);
  shading.diffuse = fields.number("diffuse", 0, Limits::kMaxShade, shading.diffuse);
  shading.specular = fields.number("specular", 0, Limits::kMaxShade, shading.specular);
  shading.shininess = fields.number("shininess", Limits::kMinShininess, Limits::kMaxShininess, shading.shininess);
  fields.rejectUnknown();
  return shading;
}

TransferPoint readPoint(JsonFields& fields) {
  TransferPoint point;
  point.value = fields.number("value", -TransferDescription::kMaxValue, TransferDescription::kMaxValue);
  point.color = readColor(fields);
  point.opacity = fields.number("opacity", 0, 1);
  return point;
}

}  // namespace

const std::vector<TransferScale>& transferScales() {
  static const std::vector<TransferScale> scales{
      {"absolute", "what voxels mean: Hounsfield units where the volume is a CT", absoluteValues},
      {"range", "0 is the least value of the volume, and 1 the greatest", valueRange},
      {"percentiles", "0 is the value that 1 % of the voxels lie below, and 1 the one that 99 % lie below",
       percentileRange}};
  return scales;
}

TransferDescription transferFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/volume/transfer_function.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    TransferDescription description;
    description.scale = fields.choice("values", scaleNames(), description.scale);
    if (fields.has("opacity_length")) {
      description.opacityLength = fields.number("opacity_length", TransferDescription::kMinOpacityLength,
                                                TransferDescription::kMaxOpacityLength);
    }
    if (fields.has("shading")) {
      JsonFields shading = fields.inner("shading");
      description.shading = readShading(shading);
    }
    if (!fields.has("points")) {
      fields.fail("points", "is missing");
    }
    fields.forEach("points", 1, TransferDescription::kMaxPoints, [&](JsonFields& each) {
      description.points.push_back(readPoint(each));
      const size_t count = description.points.size();
      if (count > 1 && description.points[count - 1].value < description.points[count - 2].value) {
        each.fail("value", "is less than that of the point before: put the points in the order of their values");
      }
    });
    fields.rejectUnknown();
    return description;
  });
}

TransferDescription readTransferFile(const std::filesystem::path& path) {
  return transferFromJsonText(readFile(path, kMaxTextBytes), path.string());
}

std::string transferToJsonText(const TransferDescription& description) {
  TransferJson points = TransferJson::array();
  for (const TransferPoint& point : description.points) {
    points.push_back({{"value", shortened(point.value)},
                      {"color", jsonOfColor(point.color)},
                      {"opacity", shortened(point.opacity)}});
  }
  TransferJson file{{"values", description.scale}};
  if (description.opacityLength) {
    file["opacity_length"] = shortened(*description.opacityLength);
  }
  file["points"] = points;
  const VolumeShading& shading = description.shading;
  file["shading"] = {{"on", shading.isOn},
                     {"ambient", shortened(shading.ambient)},
                     {"diffuse", shortened(shading.diffuse)},
                     {"specular", shortened(shading.specular)},
                     {"shininess", shortened(shading.shininess)}};
  return textOfJson(file, 2) + "\n";
}

VolumeAppearance appearanceOf(const TransferDescription& description, const ScalarVolume& volume, double meanSpacing) {
  const ValueRange scale = scaleOf(description.scale).zeroAndOne(volume);
  std::vector<TransferPoint> points = description.points;
  for (TransferPoint& point : points) {
    point.value = scale.least + point.value * (scale.greatest - scale.least);
    if (!(scale.least < scale.greatest)) {
      point.opacity = 0;
    }
  }
  return {TransferFunction(std::move(points), description.opacityLength.value_or(meanSpacing)), description.shading};
}

bool hasScaleFor(const TransferDescription& description, const ScalarVolume& volume) {
  const ValueRange scale = scaleOf(description.scale).zeroAndOne(volume);
  return scale.least < scale.greatest;
}

TransferDescription describe(const VolumeAppearance& appearance) {
  return {.points = appearance.transfer.points(),
          .opacityLength = appearance.transfer.opacityLength(),
          .shading = appearance.shading};
}

}  // namespace ocelli
