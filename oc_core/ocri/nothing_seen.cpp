#include "oc_core/ocri/nothing_seen.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// The longest side of a triangle's image, pixels; nothing where that is not in the image.
std::optional<float> longestSide(const PinholeCamera& reference, const Mesh& mesh, const glm::uvec3& triangle) {
  std::array<glm::vec2, 3> corners{};
  for (int i = 0; i < 3; ++i) {
    const auto image = reference.project(mesh.positions[triangle[i]]);
    if (!image) {
      return std::nullopt;
    }
    corners[static_cast<size_t>(i)] = {image->u, image->v};
  }
  const auto& [a, b, c] = corners;
  const glm::vec2 lower = glm::min(a, glm::min(b, c));
  const glm::vec2 upper = glm::max(a, glm::max(b, c));
  const glm::vec2 size(reference.width(), reference.height());
  if (upper.x < 0 || upper.y < 0 || lower.x > size.x || lower.y > size.y) {
    return std::nullopt;
  }
  return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
}

}  // namespace

void failSeeingNothing(const PinholeCamera& reference, const Mesh& mesh, const std::string& where) {
  std::optional<float> longest;
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (const std::optional<float> side = longestSide(reference, mesh, triangle)) {
      longest = std::max(longest.value_or(0), *side);
    }
  }
  if (!longest) {
    throw InputError("the view sees nothing of the scene", where,
                     "turn \"target\" towards the scene; a fitted scene lies in the unit sphere around the origin");
  }
  // What is in the image, and longer than a pixel, but covers none has no width there.
  if (*longest >= 1) {
    throw InputError("the scene is flat and the view sees it edge-on, so that it covers no pixel", where,
                     "move \"eye\" out of its plane, or turn the scene");
  }
  throw InputError("the scene is smaller than a pixel, so that it covers none", where,
                   "move \"eye\" closer, lower \"fov_vertical_degrees\", or give a larger --size");
}

}  // namespace ocelli
