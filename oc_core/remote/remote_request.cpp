#include "oc_core/remote/remote_request.h"

#include <fmt/format.h>

#include <limits>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr const char* kLook = "message \"look\"";

GpcRegion readLens(JsonFields& fields) {
  const auto pair = [&](const char* name, double least) {
    const std::vector<double> values = fields.numbers(name, 2, least, 1);
    return glm::vec2(static_cast<float>(values[0]), static_cast<float>(values[1]));
  };
  GpcRegion lens;
  lens.center = pair("center", 0);
  lens.extent = pair("extent", GpcRegion::kMinExtent);
  lens.zoom = static_cast<float>(fields.number("zoom", GpcRegion::kMinZoom, GpcRegion::kMaxZoom));
  lens.transitionWidth =
      static_cast<float>(fields.number("transition_width", GpcRegion::kMinTransition, GpcRegion::kMaxTransition,
                                       static_cast<double>(lens.transitionWidth)));
  return lens;
}

nlohmann::ordered_json lensJson(const GpcRegion& lens) {
  return {{"center", {lens.center.x, lens.center.y}},
          {"extent", {lens.extent.x, lens.extent.y}},
          {"zoom", lens.zoom},
          {"transition_width", lens.transitionWidth}};
}

}  // namespace

void validate(const RemoteRequest& request, const std::string& where) {
  validate(request.view, where);
  if (!(request.view.resolvedFovVerticalDegrees() >= RemoteRequest::kMinFovDegrees)) {
    throw InputError(fmt::format("the field of view is less than {:g} degrees", RemoteRequest::kMinFovDegrees), where,
                     "widen \"fov_vertical_degrees\", or move the eye nearer to its target");
  }
  const auto isScreen = [](int side) { return side >= RemoteRequest::kMinScreen && side <= RemoteRequest::kMaxScreen; };
  if (!isScreen(request.screen.x) || !isScreen(request.screen.y)) {
    throw InputError(fmt::format("the screen must have {} to {} pixels a side", RemoteRequest::kMinScreen,
                                 RemoteRequest::kMaxScreen),
                     where, "change \"screen\"");
  }
  if (request.lenses.size() > RemoteRequest::kMaxLenses) {
    throw InputError(fmt::format("there are {} lenses", request.lenses.size()), where,
                     fmt::format("give at most {}", RemoteRequest::kMaxLenses));
  }
}

RemoteRequest remoteRequestFromJson(const std::string& text) {
  return readAs("docs/remote_protocol.md", [&] {
    if (text.size() > RemoteRequest::kMaxTextBytes) {
      throw InputError("a message has at most " + std::to_string(RemoteRequest::kMaxTextBytes) + " bytes", kLook,
                       "send less");
    }
    const nlohmann::json json = parseJson(text, kLook);
    JsonFields fields(json, kLook);
    RemoteRequest request;
    fields.choice("type", {"look"});
    request.sequence = static_cast<uint32_t>(fields.integer("sequence", 0, std::numeric_limits<int>::max()));
    request.view = viewFromJsonText(fields.value("view").dump(), std::string(kLook) + ", \"view\"");
    const std::vector<double> screen =
        fields.numbers("screen", 2, RemoteRequest::kMinScreen, RemoteRequest::kMaxScreen);
    request.screen = {static_cast<int>(screen[0]), static_cast<int>(screen[1])};
    if (glm::dvec2(request.screen) != glm::dvec2(screen[0], screen[1])) {
      fields.fail("screen", "must be whole numbers");
    }
    fields.forEach("lenses", 0, RemoteRequest::kMaxLenses,
                   [&](JsonFields& each) { request.lenses.push_back(readLens(each)); });
    fields.rejectUnknown();
    validate(request, kLook);
    return request;
  });
}

std::string jsonText(const RemoteRequest& request) {
  nlohmann::ordered_json lenses = nlohmann::ordered_json::array();
  for (const GpcRegion& lens : request.lenses) {
    lenses.push_back(lensJson(lens));
  }
  return textOfJson({{"type", "look"},
                     {"sequence", request.sequence},
                     {"view", nlohmann::ordered_json::parse(jsonText(request.view))},
                     {"screen", {request.screen.x, request.screen.y}},
                     {"lenses", lenses}});
}

}  // namespace ocelli
