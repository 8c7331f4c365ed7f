// `builtin:canyon`: a river winds through a canyon; its course is the path of the guides.
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/canyon.h"

namespace ocelli {

BuiltinScene canyonScene() {
  using Kind = BuiltinParameter::Kind;
  return {"canyon",
          "terrain with a canyon and a winding river; in metres",
          {{"seed", "of the random numbers", Kind::kInteger, "1", 0, 4294967295.0},
           {"cells", "of the height field, along each side", Kind::kInteger, "256", 8, 2048}},
          [](const BuiltinValues& values) {
            const uint64_t seed = values.count("seed");
            Scene scene;
            scene.guides.path = canyonPath(seed);
            scene.add(makeCanyon({seed, values.count("cells")}, scene.guides.path));
            return scene;
          }};
}

}  // namespace ocelli
