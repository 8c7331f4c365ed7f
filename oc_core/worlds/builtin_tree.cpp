// `builtin:tree`: a tree whose leaves are triangles, smaller than pixels from afar (dissertation Figure 5.16).
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/leafy_tree.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"

namespace ocelli {
namespace {

constexpr double kMaxTreeTriangles = 4e6;
constexpr double kLawnTiltDegrees = 14;

Scene buildTree(const BuiltinValues& values) {
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(kLawnTiltDegrees)), glm::vec3(1, 0, 0));
  Scene scene;
  Mesh lawn;
  addCheckerFloor(lawn, {-1.2f, -0.9f}, {1.2f, 0.9f}, 0, 12, 9, palette::fromSrgbBytes(150, 160, 104),
                  palette::fromSrgbBytes(186, 190, 134));
  scene.add(std::move(lawn), tilt);
  scene.add(makeLeafyTree(values.count("triangles"), values.count("seed")), tilt);
  scene.instances.back().object = 1;
  return scene;
}

}  // namespace

BuiltinScene treeScene() {
  using Kind = BuiltinParameter::Kind;
  return {.name = "tree",
          .summary = "a tree with leaves on a lawn; the tree is an object",
          .parameters = {{"triangles", "of the tree", Kind::kInteger, "9000", static_cast<double>(minTreeTriangles()),
                          kMaxTreeTriangles},
                         {"seed", "of the random numbers", Kind::kInteger, "2", 0, 4294967295.0}},
          .build = buildTree};
}

}  // namespace ocelli
