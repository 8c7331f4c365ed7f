// `builtin:canyon`: a river winds through a canyon; its course is the path of the guides.
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/canyon.h"

namespace ocelli {
namespace {

/// 2048 cells.
constexpr double kMaxCanyonTriangles = 8'593'408;

}  // namespace

BuiltinScene canyonScene() {
  using Kind = BuiltinParameter::Kind;
  return {"canyon",
          "terrain with a canyon and a winding river; in metres",
          {{"seed", "of the random numbers", Kind::kInteger, "1", 0, 4294967295.0},
           {"cells", "of the height field, along each side", Kind::kInteger, "256", 8, 2048},
           {"triangles", "about so many in all, in place of cells; 0 leaves it at the cells", Kind::kInteger, "0", 0,
            kMaxCanyonTriangles}},
          [](const BuiltinValues& values) {
            const uint64_t seed = values.count("seed");
            Scene scene;
            scene.guides.path = canyonPath(seed);
            const size_t triangles = values.count("triangles");
            const size_t cells = triangles > 0 ? canyonCells(triangles) : values.count("cells");
            scene.add(makeCanyon({seed, cells}, scene.guides.path));
            return scene;
          }};
}

}  // namespace ocelli
