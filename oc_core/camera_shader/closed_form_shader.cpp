#include "oc_core/camera_shader/closed_form_shader.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "oc_core/camera/gpc_map.h"
#include "oc_core/camera_shader/osl_text.h"
#include "oc_core/ocri/representation_kind.h"

namespace ocelli {
namespace {

std::string focalLength(const PinholeCamera& reference) {
  return oslFloat("focal", reference.focalPixels(), "length, pixels");
}

/// The ray of a pinhole through (x, y), from the plane at the near distance on.
std::string pinholeRay(const PinholeCamera& reference) {
  const glm::vec2 center = reference.centerPixels();
  return focalLength(reference) + oslFloat("centerX", center.x, "where the view direction meets the image, pixels") +
         oslFloat("centerY", center.y) +
         "    vector ray = vector((x - centerX) / focal, (centerY - y) / focal, 1);\n"
         "    position = point(ray[0] * begin, ray[1] * begin, begin);\n"
         "    direction = normalize(ray);\n";
}

std::string pinhole(const CameraChoice&, const PinholeCamera& reference) {
  return pinholeRay(reference);
}

/// A point of a region of the image moves along its line to the region's centre (gpc_map.h).
std::string generalPinhole(const CameraChoice& choice, const PinholeCamera& reference) {
  const GpcMap map(choice.gpc, reference.width(), reference.height());
  if (map.zones().empty()) {
    return pinholeRay(reference);
  }
  const auto values = [&](auto value) {
    std::vector<double> each;
    for (const GpcZone& zone : map.zones()) {
      each.push_back(value(zone));
    }
    return each;
  };
  std::string text =
      "    // Regions of more or less detail. Distances r from a region's centre are in half its size: up to 1 the "
      "region\n"
      "    // shows `zoom` times the detail, from `outer` on the image is that of a pinhole. Between them a sample "
      "lies at\n"
      "    // c0 + c1 (r - 1) + c2 (r - 1)^2 + c3 (r - 1)^3 of the pinhole's image.\n";
  text += "    int regions = " + std::to_string(map.zones().size()) + ";\n";
  text += oslFloats("middleX", values([](const GpcZone& zone) { return zone.center().x; }), "pixels");
  text += oslFloats("middleY", values([](const GpcZone& zone) { return zone.center().y; }));
  text += oslFloats("halfWidth", values([](const GpcZone& zone) { return zone.half().x; }));
  text += oslFloats("halfHeight", values([](const GpcZone& zone) { return zone.half().y; }));
  text += oslFloats("zoom", values([](const GpcZone& zone) { return zone.profile().zoom(); }));
  text += oslFloats("outer", values([](const GpcZone& zone) { return zone.profile().outer(); }));
  for (size_t power = 0; power < 4; ++power) {
    text += oslFloats("c" + std::to_string(power),
                      values([power](const GpcZone& zone) { return zone.profile().coefficients()[power]; }));
  }
  text +=
      "    for (int i = 0; i < regions; ++i) {\n"
      "        float asideX = x - middleX[i];\n"
      "        float asideY = y - middleY[i];\n"
      "        float r = max(abs(asideX) / halfWidth[i], abs(asideY) / halfHeight[i]);\n"
      "        if (r < outer[i]) {\n"
      "            float s = r - 1;\n"
      "            float scale = 1 / zoom[i];\n"
      "            if (s > 0) {\n"
      "                scale = (c0[i] + s * (c1[i] + s * (c2[i] + s * c3[i]))) / r;\n"
      "            }\n"
      "            x = middleX[i] + asideX * scale;\n"
      "            y = middleY[i] + asideY * scale;\n"
      "            break;\n"
      "        }\n"
      "    }\n";
  return text + pinholeRay(reference);
}

constexpr const char* kFromTheEye =
    "    direction = normalize(ray);\n"
    "    position = point(direction[0] * begin, direction[1] * begin, direction[2] * begin);\n";

std::string panorama(const CameraChoice&, const PinholeCamera&) {
  return oslFloat("pi", kPi) +
         "    float longitude = (2 * x / width - 1) * pi;\n"
         "    float latitude = (1 - 2 * y / height) * pi / 2;\n"
         "    vector ray = vector(cos(latitude) * sin(longitude), sin(latitude), cos(latitude) * cos(longitude));\n" +
         kFromTheEye;
}

std::string cylinder(const CameraChoice&, const PinholeCamera& reference) {
  return focalLength(reference) + oslFloat("pi", kPi) +
         "    float longitude = (2 * x / width - 1) * pi;\n"
         "    vector ray = vector(sin(longitude), (height / 2 - y) / focal, cos(longitude));\n" +
         kFromTheEye;
}

constexpr std::array<ClosedForm, 4> kClosedForms{
    {{"di", pinhole}, {"gpc", generalPinhole}, {"panorama", panorama}, {"cylinder", cylinder}}};

}  // namespace

std::span<const ClosedForm> closedForms() {
  return kClosedForms;
}

const ClosedForm* findClosedForm(const CameraChoice& choice) {
  const auto found = std::find_if(kClosedForms.begin(), kClosedForms.end(), [&](const ClosedForm& form) {
    return std::string_view(form.kind) == choice.kind->name;
  });
  return found == kClosedForms.end() ? nullptr : found;
}

std::string closedFormShader(const ClosedForm& form, const CameraChoice& choice, const PinholeCamera& reference) {
  const std::string statements = oslFloat("width", reference.width(), "of the camera's image, pixels") +
                                 oslFloat("height", reference.height()) +
                                 oslFloat("begin", reference.view().zNear, "the distance at which rays begin") +
                                 "    point raster = camera_shader_raster_position();\n"
                                 "    float x = raster[0] * width;  // from the top left\n"
                                 "    float y = (1 - raster[1]) * height;\n" +
                                 form.statements(choice, reference) + "    throughput = color(1.0);\n";
  return oslText({.name = choice.name,
                  .size = {reference.width(), reference.height()},
                  .view = reference.view(),
                  .remarks = "",
                  .parameters = "",
                  .statements = statements});
}

}  // namespace ocelli
