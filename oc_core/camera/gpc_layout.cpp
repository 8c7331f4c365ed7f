#include "oc_core/camera/gpc_layout.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/camera/gpc_fold.h"

namespace ocelli {
namespace {

/// Floats that meet at an edge, as 0.25 + 0.25 and 0.5 do, may be rounded apart: a hundredth of a pixel at most.
constexpr double kTouch = 1e-6;

struct Extent {
  glm::dvec2 lower;
  glm::dvec2 upper;
};

Extent withTransition(const GpcRegion& region) {
  const glm::dvec2 half = glm::dvec2(region.extent) / 2.0 * region.outer();
  return {glm::dvec2(region.center) - half, glm::dvec2(region.center) + half};
}

std::string named(const std::string& where, size_t region) {
  return where + fmt::format(", region {}", region + 1);
}

void checkRange(double value, double least, double most, const char* what, const std::string& where) {
  if (!(value >= least && value <= most)) {
    throw InputError(fmt::format("its {} must be a number from {} to {}", what, least, most), where, "change it");
  }
}

void validateAlone(const GpcRegion& region, const GpcSampling& sampling, const std::string& where) {
  for (int axis = 0; axis < 2; ++axis) {
    checkRange(static_cast<double>(region.center[axis]), 0, 1, "\"center\"", where);
    checkRange(static_cast<double>(region.extent[axis]), GpcRegion::kMinExtent, 1, "\"extent\"", where);
  }
  checkRange(static_cast<double>(region.zoom), GpcRegion::kMinZoom, GpcRegion::kMaxZoom, "\"zoom\"", where);
  checkRange(static_cast<double>(region.transitionWidth), GpcRegion::kMinTransition - 1e-9, GpcRegion::kMaxTransition,
             "\"transition_width\"", where);
  const Extent whole = withTransition(region);
  if (glm::min(whole.lower.x, whole.lower.y) < -kTouch || glm::max(whole.upper.x, whole.upper.y) > 1 + kTouch) {
    throw InputError(fmt::format("with its transition it reaches from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g}) of the "
                                 "image, whose corners are (0, 0) and (1, 1)",
                                 whole.lower.x, whole.lower.y, whole.upper.x, whole.upper.y),
                     where, "move it, or make its \"extent\" or \"transition_width\" smaller");
  }
  const auto zoom = static_cast<double>(region.zoom);
  if (!GpcProfile(sampling, zoom, region.outer()).isIncreasing()) {
    throw InputError(fmt::format("its transition is too narrow for a zoom of {:g}: samples would fold", zoom), where,
                     fmt::format("widen \"transition_width\", or zoom by more than {:.4g}",
                                 leastUnfoldedZoom(sampling, region.outer())));
  }
}

nlohmann::ordered_json regionsJson(const GpcLayout& layout) {
  nlohmann::ordered_json regions = nlohmann::ordered_json::array();
  for (const GpcRegion& each : layout.regions) {
    regions.push_back({{"center", {each.center.x, each.center.y}},
                       {"extent", {each.extent.x, each.extent.y}},
                       {"zoom", each.zoom},
                       {"transition_width", each.transitionWidth}});
  }
  return regions;
}

}  // namespace

void validate(const GpcLayout& layout, const std::string& where) {
  if (layout.regions.size() > GpcLayout::kMaxRegions) {
    throw InputError(fmt::format("it has {} regions", layout.regions.size()), where,
                     fmt::format("give at most {}", GpcLayout::kMaxRegions));
  }
  for (size_t i = 0; i < layout.regions.size(); ++i) {
    validateAlone(layout.regions[i], *layout.sampling, named(where, i));
    const Extent a = withTransition(layout.regions[i]);
    for (size_t k = 0; k < i; ++k) {
      const Extent b = withTransition(layout.regions[k]);
      const glm::dvec2 common = glm::min(a.upper, b.upper) - glm::max(a.lower, b.lower);
      if (common.x > kTouch && common.y > kTouch) {
        throw InputError(fmt::format("with their transitions it and region {} overlap by {:.4g} x {:.4g} of the image",
                                     k + 1, common.x, common.y),
                         named(where, i), "move one of them, or make them smaller");
      }
    }
  }
}

void readGpcLayout(JsonFields& fields, GpcLayout& layout) {
  if (fields.has("sampling")) {
    std::vector<std::string> names;
    for (const GpcSampling& each : gpcSamplings()) {
      names.emplace_back(each.name);
    }
    layout.sampling = findGpcSampling(fields.choice("sampling", names).c_str());
  }
  if (fields.has("regions")) {
    layout.regions.clear();
    fields.forEach("regions", 1, GpcLayout::kMaxRegions, [&](JsonFields& each) {
      GpcRegion region;
      const auto pair = [&](const char* name, double least, const glm::vec2& otherwise) {
        if (!each.has(name)) {
          return otherwise;
        }
        const std::vector<double> values = each.numbers(name, 2, least, 1);
        return glm::vec2(static_cast<float>(values[0]), static_cast<float>(values[1]));
      };
      region.center = pair("center", 0, region.center);
      region.extent = pair("extent", GpcRegion::kMinExtent, region.extent);
      region.zoom = static_cast<float>(
          each.number("zoom", GpcRegion::kMinZoom, GpcRegion::kMaxZoom, static_cast<double>(region.zoom)));
      region.transitionWidth =
          static_cast<float>(each.number("transition_width", GpcRegion::kMinTransition, GpcRegion::kMaxTransition,
                                         static_cast<double>(region.transitionWidth)));
      layout.regions.push_back(region);
    });
  }
  validate(layout, fields.where());
}

std::string gpcSamplingText(const GpcLayout& layout) {
  return textOfJson(layout.sampling->name);
}

std::string gpcRegionsText(const GpcLayout& layout) {
  return textOfJson(regionsJson(layout));
}

std::string jsonText(const GpcLayout& layout) {
  return textOfJson(nlohmann::ordered_json{{"sampling", layout.sampling->name}, {"regions", regionsJson(layout)}});
}

std::string gpcSamplingSchema() {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const GpcSampling& each : gpcSamplings()) {
    names.push_back(each.name);
  }
  return textOfJson({{"enum", names}, {"default", GpcLayout().sampling->name}});
}

std::string gpcRegionsSchema() {
  const GpcRegion usual;
  const auto pair = [](const char* description, double least, const glm::vec2& value) {
    return nlohmann::ordered_json{{"description", description},
                                  {"type", "array"},
                                  {"minItems", 2},
                                  {"maxItems", 2},
                                  {"items", {{"type", "number"}, {"minimum", least}, {"maximum", 1}}},
                                  {"default", {value.x, value.y}}};
  };
  const auto number = [](const char* description, double least, double most, float value) {
    return nlohmann::ordered_json{
        {"description", description}, {"type", "number"}, {"minimum", least}, {"maximum", most}, {"default", value}};
  };
  const nlohmann::ordered_json properties{
      {"$schema", {{"type", "string"}}},
      {"comment", {{"type", "string"}}},
      {"center",
       pair("Where its middle is, in shares of the image's width and height from the top left", 0, usual.center)},
      {"extent", pair("Its width and height, in the same shares", GpcRegion::kMinExtent, usual.extent)},
      {"zoom", number("Samples for each one of a pinhole, along either axis", GpcRegion::kMinZoom, GpcRegion::kMaxZoom,
                      usual.zoom)},
      {"transition_width",
       number("From its edge to where the image is the pinhole's again, as a share of half its extent",
              GpcRegion::kMinTransition, GpcRegion::kMaxTransition, usual.transitionWidth)}};
  return textOfJson({{"type", "array"},
                     {"minItems", 1},
                     {"maxItems", GpcLayout::kMaxRegions},
                     {"items", {{"type", "object"}, {"additionalProperties", false}, {"properties", properties}}},
                     {"default", regionsJson(GpcLayout())}});
}

}  // namespace ocelli
