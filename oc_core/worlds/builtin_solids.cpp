// `builtin:sphere`, `builtin:torus`, `builtin:box`: closed solids to test with; `builtin:teapot`: the object of all
// demos.
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/teapot.h"

namespace ocelli {
namespace {

using Kind = BuiltinParameter::Kind;

Scene sceneOf(Mesh mesh, const glm::vec3& color, const glm::mat4& worldFromMesh = glm::mat4(1)) {
  Scene scene;
  scene.add(std::move(mesh), worldFromMesh);
  scene.instances.back().tint = color;
  return scene;
}

glm::mat4 turned(double tiltDegrees, double turnDegrees) {
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(tiltDegrees)), glm::vec3(1, 0, 0));
  return glm::rotate(tilt, static_cast<float>(radiansFromDegrees(turnDegrees)), glm::vec3(0, 1, 0));
}

}  // namespace

BuiltinScene sphereScene() {
  return {"sphere",
          "a closed sphere",
          {{"segments", "around its axis", Kind::kInteger, "96", 3, 4096}},
          [](const BuiltinValues& values) {
            return sceneOf(makeSphere(static_cast<int>(values.count("segments"))), palette::skyBlue());
          }};
}

BuiltinScene torusScene() {
  return {"torus",
          "a closed ring that faces the view",
          {{"tube", "radius of the tube, in radii of the whole", Kind::kNumber, "0.3", 0.01, 0.49},
           {"segments", "around its axis", Kind::kInteger, "128", 3, 4096}},
          [](const BuiltinValues& values) {
            return sceneOf(
                makeTorus(static_cast<float>(values.number("tube")), static_cast<int>(values.count("segments"))),
                palette::orange(), turned(25, 20));
          }};
}

BuiltinScene boxScene() {
  return {"box",
          "a closed box",
          {{"width", "along x, in any unit", Kind::kNumber, "1", 0.001, 1000},
           {"height", "along y", Kind::kNumber, "1", 0.001, 1000},
           {"depth", "along z", Kind::kNumber, "1", 0.001, 1000},
           {"turn", "about the y axis, in degrees", Kind::kNumber, "35", -360, 360},
           {"tilt", "towards the viewer after that, in degrees", Kind::kNumber, "25", -360, 360}},
          [](const BuiltinValues& values) {
            const glm::dvec3 size(values.number("width"), values.number("height"), values.number("depth"));
            return sceneOf(makeBox(glm::vec3(size / 2.0)), palette::green(),
                           turned(values.number("tilt"), values.number("turn")));
          }};
}

BuiltinScene teapotScene() {
  return {"teapot",
          "the Utah teapot from its Bezier patches",
          {{"segments", "quads along each side of a patch", Kind::kInteger, "24", 1, 512}},
          [](const BuiltinValues& values) {
            return sceneOf(makeTeapot(static_cast<int>(values.count("segments"))), palette::orange(), turned(18, -20));
          }};
}

}  // namespace ocelli
