#include "oc_core/camera_shader/osl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/geometric.hpp>
#include <vector>

namespace ocelli {
namespace {

/// A name that the language takes for one.
std::string identifierOf(const std::string& name) {
  std::string identifier = "ocelli_";
  for (const char c : name) {
    identifier += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return identifier;
}

/// Without line breaks, which would end a comment.
std::string inComment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  return text;
}

/// Of an object that looks along its own -z, with y up: its axes and its place as columns, in a world whose axes
/// `place` makes of those of the scene.
std::string matrixText(const View& view, glm::dvec3 (*place)(const glm::dvec3&)) {
  const glm::dvec3 eye(view.eye);
  const glm::dvec3 backward = glm::normalize(eye - glm::dvec3(view.target));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(view.up), backward));
  const std::array<glm::dvec3, 4> columns{place(right), place(glm::cross(backward, right)), place(backward),
                                          place(eye)};
  std::string text;
  for (int row = 0; row < 3; ++row) {
    text += "//     (";
    for (const glm::dvec3& column : columns) {
      // 0 has no sign here.
      text += fmt::format("{}{:.9g}", &column == columns.data() ? "" : ", ", column[row] + 0.0);
    }
    text += "),\n";
  }
  return text + "//     (0, 0, 0, 1)\n";
}

std::string placeText(const View& view) {
  return "//\n// Where the camera stands, as the matrix_world of a camera object. In a world whose y axis points up, "
         "as\n"
         "// that of the scene does:\n" +
         matrixText(view, [](const glm::dvec3& p) { return p; }) +
         "// Where the import turned the scene so that z points up, and y along what was -z:\n" +
         matrixText(view, [](const glm::dvec3& p) { return glm::dvec3(p.x, -p.z, p.y); });
}

}  // namespace

std::string oslText(const OslCamera& camera) {
  std::string text = fmt::format(
      "// The camera \"{}\" of Ocelli, {}x{} pixels, for renderers that take cameras in the Open Shading Language.\n"
      "//\n"
      "// position and direction are in the space of the camera: x to the right, y up, z forward; lengths are those "
      "of\n"
      "// the scene. The image that is rendered needs {}:{} as the ratio of its sides.\n",
      inComment(camera.name), camera.size.x, camera.size.y, camera.size.x, camera.size.y);
  text += camera.remarks;
  if (camera.view) {
    text += placeText(*camera.view);
  }
  return text + fmt::format(
                    "shader {}(\n"
                    "    output point position = point(0.0),\n"
                    "    output vector direction = vector(0.0),\n"
                    "    output color throughput = color(0.0){})\n"
                    "{{\n{}}}\n",
                    identifierOf(camera.name), camera.parameters, camera.statements);
}

std::string oslNumber(double value) {
  std::string text = fmt::format("{}", static_cast<float>(value));
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string oslFloat(const std::string& name, double value, const std::string& meaning) {
  return fmt::format("    float {} = {};{}\n", name, oslNumber(value), meaning.empty() ? "" : "  // " + meaning);
}

std::string oslFloats(const std::string& name, std::span<const double> values, const std::string& meaning) {
  std::vector<std::string> numbers;
  for (const double value : values) {
    numbers.push_back(oslNumber(value));
  }
  return fmt::format("    float {}[{}] = {{{}}};{}\n", name, values.size(), fmt::join(numbers, ", "),
                     meaning.empty() ? "" : "  // " + meaning);
}

std::string oslString(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
    }
    quoted += c;
  }
  return quoted + '"';
}

OslCameraSpace::OslCameraSpace(const View& view)
    : eye_(view.eye), forward_(glm::normalize(glm::dvec3(view.target) - glm::dvec3(view.eye))) {
  right_ = glm::normalize(glm::cross(forward_, glm::dvec3(view.up)));
  up_ = glm::cross(right_, forward_);
}

glm::dvec3 OslCameraSpace::direction(const glm::dvec3& world) const {
  return {glm::dot(world, right_), glm::dot(world, up_), glm::dot(world, forward_)};
}

}  // namespace ocelli
