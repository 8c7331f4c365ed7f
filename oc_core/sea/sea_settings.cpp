#include "oc_core/sea/sea_settings.h"

#include <fmt/format.h>

#include <array>

#include "oc_core/base/json_fields.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/sea/pose_refinement.h"

namespace ocelli {
namespace {

constexpr int kMaxSpacing = 64;
constexpr int kMaxCell = 64;
constexpr int kMaxHiddenViews = 1000;

constexpr std::array<std::pair<SeaProjectionKind, const char*>, 2> kProjectionNames{
    {{SeaProjectionKind::kPanorama, "panorama"}, {SeaProjectionKind::kPinhole, "pinhole"}}};

void requireCodec(const std::string& name, const std::string& where) {
  if (findColorCodec(name) == nullptr) {
    std::string known;
    for (const ColorCodec& codec : colorCodecs()) {
      known += known.empty() ? codec.name : std::string(", ") + codec.name;
    }
    throw InputError(fmt::format("no codec is called \"{}\"", name), where, "choose one of " + known);
  }
}

SeaProjection readProjection(JsonFields fields) {
  SeaProjection projection;
  const std::string kind = fields.choice("kind", {kProjectionNames[0].second, kProjectionNames[1].second});
  projection.kind = kind == kProjectionNames[0].second ? kProjectionNames[0].first : kProjectionNames[1].first;
  projection.width = fields.integer("width", 1, kMaxCodedSide);
  projection.height = fields.integer("height", 1, kMaxCodedSide);
  if (projection.kind == SeaProjectionKind::kPinhole) {
    const std::vector<double> focal = fields.numbers("focal", 2, 0, 1e9);
    const std::vector<double> center = fields.numbers("center", 2, -1e9, 1e9);
    projection.focal = {focal[0], focal[1]};
    projection.center = {center[0], center[1]};
  }
  fields.rejectUnknown();
  return projection;
}

nlohmann::ordered_json jsonOf(const SeaProjection& projection) {
  nlohmann::ordered_json json;
  for (const auto& [kind, name] : kProjectionNames) {
    if (kind == projection.kind) {
      json["kind"] = name;
    }
  }
  json["width"] = projection.width;
  json["height"] = projection.height;
  if (projection.kind == SeaProjectionKind::kPinhole) {
    json["focal"] = {projection.focal.x, projection.focal.y};
    json["center"] = {projection.center.x, projection.center.y};
  }
  return json;
}

}  // namespace

void validate(const SeaSettings& settings, const std::string& where) {
  validate(settings.projection, where);
  requireCodec(settings.iCodec, where);
  requireCodec(settings.pCodec, where);
  requirePoseRefinement(settings.refinement, where);
  const auto isQuality = [](double quality) { return quality >= 1 && quality <= 100; };
  if (!isQuality(settings.iQuality) || !isQuality(settings.pQuality) || !isQuality(settings.hiddenQuality)) {
    throw InputError("the quality of a codec is from 1 to 100", where, "the text takes 75 for I-nodes, 65 for P-nodes");
  }
  if (!(settings.adaptive >= 0 && settings.adaptive < 1)) {
    throw InputError("the share by which quality is lowered is from 0 to less than 1", where, "the text takes 0.3");
  }
  if (settings.spacing < 0 || settings.spacing > kMaxSpacing) {
    throw InputError(fmt::format("I-nodes are 0 to {} levels apart", kMaxSpacing), where, "the text takes 4");
  }
  if (settings.warpCell < 2 || settings.warpCell > kMaxCell) {
    throw InputError(fmt::format("rays of warps are 2 to {} pixels apart", kMaxCell), where,
                     fmt::format("leave it out for {}", kWarpCell));
  }
  if (settings.hiddenViews < 1 || settings.hiddenViews > kMaxHiddenViews) {
    throw InputError(fmt::format("hidden samples are seen by at least 1 to {} images", kMaxHiddenViews), where,
                     "leave it out for 3");
  }
}

std::string jsonText(const SeaSettings& settings) {
  nlohmann::ordered_json json{{"source", settings.source},      {"projection", jsonOf(settings.projection)},
                              {"way", nameOf(settings.way)},    {"i_spacing", settings.spacing},
                              {"i_codec", settings.iCodec},     {"p_codec", settings.pCodec},
                              {"i_quality", settings.iQuality}, {"p_quality", settings.pQuality},
                              {"adaptive", settings.adaptive},  {"refinement", settings.refinement},
                              {"warp_cell", settings.warpCell}};
  // Seas without hidden samples are what they were before there were any.
  if (settings.hasHidden()) {
    json["hidden"] = settings.hidden;
    json["hidden_quality"] = settings.hiddenQuality;
    json["hidden_views"] = settings.hiddenViews;
  }
  return textOfJson(json, 2) + "\n";
}

SeaSettings seaSettingsFromJson(const std::string& text, const std::string& where) {
  return readAs("docs/sea_format.md", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    SeaSettings settings;
    settings.source = fields.text("source");
    settings.projection = readProjection(fields.inner("projection"));
    settings.way = fields.choiceOf("way", allSeaWays());
    settings.spacing = fields.integer("i_spacing", 0, kMaxSpacing);
    settings.iCodec = fields.text("i_codec");
    settings.pCodec = fields.text("p_codec");
    settings.iQuality = fields.number("i_quality", 1, 100);
    settings.pQuality = fields.number("p_quality", 1, 100);
    settings.adaptive = fields.number("adaptive", 0, 1);
    settings.refinement = fields.text("refinement");
    settings.warpCell = fields.integer("warp_cell", 2, kMaxCell);
    if (fields.has("hidden")) {
      settings.hidden = fields.text("hidden");
      settings.hiddenQuality = fields.number("hidden_quality", 1, 100);
      settings.hiddenViews = fields.integer("hidden_views", 1, kMaxHiddenViews);
    }
    fields.rejectUnknown();
    validate(settings, where);
    return settings;
  });
}

}  // namespace ocelli
