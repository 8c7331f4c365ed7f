#include "oc_core/remote/remote_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"
#include "oc_core/camera/gpc_layout.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote/row_names.h"

namespace ocelli {
namespace {

/// A value of the settings, with whatever type it has.
template <class Settings, class Body>
auto visitValue(const RemoteOption& option, Settings& settings, const Body& body) {
  return std::visit([&](auto member) { return body(settings.*member); }, option.place);
}

struct ValueJson {
  nlohmann::ordered_json operator()(const auto& value) const { return value; }
};

}  // namespace

RemoteSettings::RemoteSettings() : color(findColorCodec("webp_lossless") != nullptr ? "webp_lossless" : "png") {}

std::span<const RemoteOption> remoteOptions() {
  static const std::vector<RemoteOption> kOptions{
      {.name = "reach",
       .unit = "",
       .meaning = "How much wider and higher than the screen the image is, so that the view may turn",
       .place = &RemoteSettings::reach,
       .min = 1,
       .max = 8},
      {.name = "size",
       .unit = "",
       .meaning = "Pixels of the image by those of the screen, along either axis",
       .place = &RemoteSettings::size,
       .min = 0.1,
       .max = 4},
      {.name = "zoom",
       .unit = "",
       .meaning = "How much denser the samples lie in the middle of the image; 1: nowhere",
       .place = &RemoteSettings::zoom,
       .min = 1,
       .max = 16},
      {.name = "middle",
       .unit = "",
       .meaning = "Width and height of that middle region, shares of the image; the transition reaches to its borders",
       .place = &RemoteSettings::middle,
       .min = 0.1,
       .max = 0.9},
      {.name = "sampling",
       .unit = "",
       .meaning = "How samples spread around the regions",
       .place = &RemoteSettings::sampling,
       .words = [] { return rowNames(gpcSamplings()); }},
      {.name = "color",
       .unit = "",
       .meaning = "The format of colours",
       .place = &RemoteSettings::color,
       .words = [] { return rowNames(colorCodecs()); }},
      {.name = "quality",
       .unit = "",
       .meaning = "Of colours in a lossy format",
       .place = &RemoteSettings::quality,
       .min = 0,
       .max = 100},
      {.name = "depth",
       .unit = "",
       .meaning = "The format of depths",
       .place = &RemoteSettings::depth,
       .words = [] { return rowNames(depthCodecs()); }},
      {.name = "translation",
       .unit = "",
       .meaning = "How far the eye is expected to move, by the distance of the nearest sample",
       .place = &RemoteSettings::translation,
       .min = 0,
       .max = 1},
      {.name = "depth_error",
       .unit = "pixels",
       .meaning = "By how much rounded depths may displace a sample after that translation, where samples lie densest",
       .place = &RemoteSettings::depthError,
       .min = 0.001,
       .max = 16},
      {.name = "samples",
       .unit = "",
       .meaning = "Rays along either axis of a pixel, whose colours are averaged",
       .place = &RemoteSettings::samples,
       .min = 1,
       .max = 8},
  };
  return kOptions;
}

std::string valueText(const RemoteOption& option, const RemoteSettings& settings) {
  return visitValue(option, settings, [](const auto& value) { return fmt::format("{}", value); });
}

void validate(const RemoteSettings& settings, const std::string& where) {
  for (const RemoteOption& option : remoteOptions()) {
    if (const auto* word = std::get_if<std::string RemoteSettings::*>(&option.place)) {
      const std::vector<std::string> words = option.words();
      if (std::ranges::find(words, settings.**word) == words.end()) {
        throw InputError(fmt::format("\"{}\" is no {}", settings.**word, option.name), where,
                         fmt::format("take one of: {}", fmt::join(words, ", ")));
      }
      continue;
    }
    const double value = std::holds_alternative<int RemoteSettings::*>(option.place)
                             ? settings.*std::get<int RemoteSettings::*>(option.place)
                             : settings.*std::get<double RemoteSettings::*>(option.place);
    if (!(value >= option.min && value <= option.max)) {
      throw InputError(fmt::format("\"{}\" must be a number from {} to {}", option.name, option.min, option.max), where,
                       "change it");
    }
  }
}

std::string jsonText(const RemoteSettings& settings) {
  nlohmann::ordered_json json;
  for (const RemoteOption& option : remoteOptions()) {
    json[option.name] = visitValue(option, settings, ValueJson{});
  }
  return textOfJson(json);
}

namespace {

void readValue(JsonFields& fields, const RemoteOption& option, double& value) {
  value = fields.number(option.name, option.min, option.max, value);
}
void readValue(JsonFields& fields, const RemoteOption& option, int& value) {
  value = fields.integer(option.name, static_cast<int>(option.min), static_cast<int>(option.max), value);
}
void readValue(JsonFields& fields, const RemoteOption& option, std::string& value) {
  value = fields.choice(option.name, option.words(), value);
}

}  // namespace

RemoteSettings remoteSettingsFromJson(const std::string& text, const std::string& where) {
  return readAs("docs/remote_protocol.md", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    RemoteSettings settings;
    for (const RemoteOption& option : remoteOptions()) {
      visitValue(option, settings, [&](auto& value) { readValue(fields, option, value); });
    }
    fields.rejectUnknown();
    return settings;
  });
}

}  // namespace ocelli
