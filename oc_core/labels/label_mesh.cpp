#include "oc_core/labels/label_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/drawing/text_outline.h"
#include "oc_core/labels/filled_outline.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

constexpr Face kLabelFace = Face::kSansBold;
/// From baseline to baseline, over the height of a capital letter.
constexpr double kLineStep = 1.7;
/// Below this share of its length, what is left of y tells no direction.
constexpr double kUprightShare = 1e-6;

/// Where a label stands: its middle, and its directions of length 1.
struct LabelPlace {
  glm::dvec3 middle;
  glm::dvec3 right;
  glm::dvec3 up;

  glm::vec3 at(double x, double y) const { return glm::vec3(middle + right * x + up * y); }
};

LabelPlace placeOfLabel(const SceneLabel& label, const LabelLook& look) {
  const glm::dvec3 facing = glm::normalize(glm::dvec3(label.facing.value_or(look.facing)));
  glm::dvec3 up = glm::dvec3(0, 1, 0) - facing * facing.y;
  if (glm::length(up) < kUprightShare) {
    up = glm::dvec3(0, 0, facing.y > 0 ? -1 : 1);
    up -= facing * glm::dot(up, facing);
  }
  up = glm::normalize(up);
  return {glm::dvec3(label.position), glm::cross(up, facing), up};
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// `scale`: how large size 1 of the font is.
void addLabel(Mesh& mesh, const SceneLabel& label, const LabelPlace& place, double size, double scale) {
  const std::vector<std::string> lines = linesOf(label.text);
  double baseline = (kLineStep * static_cast<double>(lines.size() - 1) - 1) * size / 2;
  for (const std::string& line : lines) {
    const double start = -textWidth(line, kLabelFace, scale) / 2;
    for (const GlyphOutline& glyph : textOutlines(line, kLabelFace)) {
      std::vector<std::vector<glm::dvec2>> outlines;
      for (const std::vector<PlotPoint>& corners : glyph) {
        outlines.emplace_back();
        for (const PlotPoint& corner : corners) {
          outlines.back().emplace_back(start + corner.x * scale, baseline + corner.y * scale);
        }
      }
      const FilledOutline filled = fillOutlines(outlines);
      const auto first = static_cast<uint32_t>(mesh.positions.size());
      for (const glm::dvec2& corner : filled.corners) {
        mesh.positions.push_back(place.at(corner.x, corner.y));
      }
      for (const glm::uvec3& t : filled.triangles) {
        mesh.triangles.push_back(t + first);
      }
    }
    baseline -= kLineStep * size;
  }
  mesh.colors.resize(mesh.positions.size(), label.color);
}

}  // namespace

Mesh meshOfLabels(const std::vector<SceneLabel>& labels, const LabelLook& look, const std::string& where) {
  OC_CHECK(look.size > 0 && look.facing != glm::vec3(0), "labels have a size, and face some direction");
  const double capital = capitalHeight(kLabelFace);
  Mesh mesh;
  for (const SceneLabel& label : labels) {
    const double size = label.size.value_or(look.size);
    const size_t before = mesh.triangles.size();
    if (capital > 0) {
      addLabel(mesh, label, placeOfLabel(label, look), size, size / capital);
    }
    if (mesh.triangles.size() == before) {
      throw InputError("no installed font draws the label \"" + printableText(label.text) + "\"", where,
                       "install a font, such as the package fonts-dejavu-core");
    }
    if (mesh.triangles.size() > kMaxSceneTriangles) {
      throw InputError("these labels have more than " + std::to_string(kMaxSceneTriangles) + " triangles", where,
                       "leave some out");
    }
  }
  return mesh;
}

}  // namespace ocelli
