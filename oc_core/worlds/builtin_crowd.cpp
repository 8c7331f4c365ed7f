// `builtin:crowd`: very many copies of an object in rows on a floor. Its triangles need not fit into memory as one
// mesh: `ocelli scene pack` takes it copy by copy.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"

namespace ocelli {
namespace {

constexpr double kMaxCopies = 10'000;
constexpr double kMaxTriangles = 1e9;

Scene buildCrowd(const BuiltinValues& values) {
  const std::array<glm::vec3, 7> colors{palette::orange(), palette::skyBlue(),   palette::green(), palette::yellow(),
                                        palette::blue(),   palette::vermilion(), palette::purple()};
  const size_t copies = values.count("copies");
  Scene scene;
  Mesh object = readObject(values, scene.warnings);
  densify(object, values.count("triangles") / copies);

  // Rows of twice as many copies as there are rows, each copy in a square of the floor.
  const auto columns = static_cast<size_t>(std::ceil(std::sqrt(2.0 * static_cast<double>(copies))));
  const size_t rows = (copies + columns - 1) / columns;
  const float square = 2.0f / static_cast<float>(columns);
  const float depth = square * static_cast<float>(rows);
  const glm::vec3 size = boundsOf(object).size();
  const float scale = 0.8f * square / std::max(size.x, size.z);

  Mesh floor;
  addCheckerFloor(floor, {-1, -depth}, {1, 0}, 0, std::min<size_t>(columns, 40), std::min<size_t>(rows, 20),
                  palette::slate(), palette::ivory());
  scene.add(std::move(floor));
  const bool plain = object.colors.empty();
  scene.meshes.push_back(std::move(object));
  Random random(values.count("seed"));
  for (size_t i = 0; i < copies; ++i) {
    const float x = -1 + (static_cast<float>(i % columns) + 0.5f) * square;
    const float z = -(static_cast<float>(i / columns) + 0.5f) * square;
    glm::mat4 worldFromMesh = glm::translate(glm::mat4(1), {x, 0, z});
    worldFromMesh = glm::rotate(worldFromMesh, random.inRange(0, static_cast<float>(2 * kPi)), glm::vec3(0, 1, 0));
    worldFromMesh = glm::scale(worldFromMesh, glm::vec3(scale * random.inRange(0.8f, 1.0f)));
    const glm::vec3 color = colors[random.next() % colors.size()];
    scene.instances.push_back({1, worldFromMesh, plain ? color : glm::vec3(1), static_cast<uint32_t>(i + 1)});
  }
  tiltRoom(scene);
  return scene;
}

}  // namespace

BuiltinScene crowdScene() {
  BuiltinParameter triangles = trianglesParameter();
  triangles.most = kMaxTriangles;
  return {"crowd",
          "very many copies of an object in rows on a floor; packed first, it may be larger than memory",
          {meshParameter(),
           turnParameter(),
           {"copies", "how many", BuiltinParameter::Kind::kInteger, "100", 1, kMaxCopies},
           triangles,
           {"seed", "of their colours, sizes and directions", BuiltinParameter::Kind::kInteger, "1", 0, 1e9}},
          buildCrowd};
}

}  // namespace ocelli
