#include "oc_core/constructor/camera_constructors.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/comprehensive_objects.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/constructor/maze_constructor.h"
#include "oc_core/constructor/maze_options.h"
#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/constructor/path_constructor.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/constructor/target_constructor.h"

namespace ocelli {
namespace {

const CameraConstructor* find(const std::string& name) {
  const auto& all = cameraConstructors();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const CameraConstructor& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool isFile(const std::string& nameOrFile) {
  return nameOrFile.ends_with(".json");
}

/// For cameras that a name alone does not say.
void requireFile(JsonFields& options, const char* field) {
  if (!options.has(field)) {
    throw InputError("field \"" + std::string(field) + "\" is missing", options.where(),
                     "give a JSON file that has it: --camera FILE.json");
  }
}

/// Of a camera's file.
const char* schemaOf(const nlohmann::json& json) {
  const auto camera = json.is_object() ? json.find("camera") : json.end();
  if (camera != json.end() && *camera == "graph") {
    return "oc_core/constructor/graph_camera.schema.json";
  }
  return camera != json.end() && *camera == "curved" ? "oc_core/constructor/curved_ray_camera.schema.json"
                                                     : "oc_core/constructor/constructor.schema.json";
}

std::string listOfNames() {
  std::string names;
  for (const CameraConstructor& each : cameraConstructors()) {
    names += names.empty() ? each.name : std::string(", ") + each.name;
  }
  return names;
}

}  // namespace

const std::vector<CameraConstructor>& cameraConstructors() {
  static const std::vector<CameraConstructor> constructors{
      {"graph", "graph camera of a JSON file's bend, split, merge and limit operations",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         requireFile(options, "operations");
         return MultiperspectiveCamera(readGraphCamera(options, reference, boundsOf(scene.mesh)));
       }},
      {"curved", "curved ray camera of a JSON file's turns",
       [](JsonFields& options, const GuidedScene&, const PinholeCamera& reference) {
         requireFile(options, "turns");
         return MultiperspectiveCamera(readCurvedRayCamera(options, reference));
       }},
      {"comprehensive", "a whole maze in one image, each place once",
       [](JsonFields& fields, const GuidedScene& scene, const PinholeCamera& reference) {
         ComprehensiveOptions options = readComprehensiveOptions(fields);
         const Maze& maze = mazeOf(scene, "comprehensive camera");
         if (fields.boolean("show_objects", true)) {
           options = chooseComprehensive(scene, options, reference.width(), reference.height()).options;
         }
         return MultiperspectiveCamera(makeComprehensiveCamera(maze, options, reference.width(), reference.height()));
       }},
      {"portal", "graph camera that looks straight into every portal in view",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         return MultiperspectiveCamera(buildPortalCamera(readPortalOptions(options), scene.guides, reference));
       }},
      {"maze", "along a corridor to the next crossing, and along all ways that leave it",
       [](JsonFields& fields, const GuidedScene& scene, const PinholeCamera& reference) {
         const MazeCameraPlace place = readMazeCamera(fields, reference);
         const Maze& maze = mazeOf(scene, "maze camera");
         return MultiperspectiveCamera(
             makeMazeCamera(maze, place.pose, place.options, reference.width(), reference.height()));
       }},
      {"path", "curved ray camera that previews a path behind its next turns",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         return MultiperspectiveCamera(buildPathCamera(readPathOptions(options), scene.guides, reference));
       }},
      {"occluder", "graph camera that looks around a box",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         return MultiperspectiveCamera(buildOccluderCamera(readOccluderOptions(options), scene, reference));
       }},
      {"target", "curved ray camera that bends around what hides a target",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         return MultiperspectiveCamera(buildTargetCamera(readTargetOptions(options), scene, reference));
       }},
  };
  return constructors;
}

bool namesConstructor(const std::string& nameOrFile) {
  if (!isFile(nameOrFile)) {
    return find(nameOrFile) != nullptr;
  }
  const nlohmann::json json = readJsonFile(nameOrFile);
  return json.is_object() && json.contains("camera") && json["camera"].is_string() &&
         find(json["camera"].get<std::string>()) != nullptr;
}

std::optional<glm::ivec2> sizeInFile(const std::string& nameOrFile) {
  if (!isFile(nameOrFile)) {
    return std::nullopt;
  }
  const nlohmann::json json = readJsonFile(nameOrFile);
  return readAs(schemaOf(json), [&] {
    JsonFields fields(json, nameOrFile);
    return readSize(fields);
  });
}

MultiperspectiveCamera constructCamera(const std::string& nameOrFile, const GuidedScene& scene,
                                       const PinholeCamera& reference) {
  const nlohmann::json json = isFile(nameOrFile) ? readJsonFile(nameOrFile) : nlohmann::json{{"camera", nameOrFile}};
  const std::string where = isFile(nameOrFile) ? nameOrFile : "--camera " + nameOrFile;
  return readAs(schemaOf(json), [&] {
    JsonFields fields(json, where);
    const std::string name = fields.text("camera");
    const CameraConstructor* constructor = find(name);
    if (constructor == nullptr) {
      throw InputError("there is no constructor of cameras \"" + name + "\"", where + ", field \"camera\"",
                       "use " + listOfNames());
    }
    MultiperspectiveCamera camera = constructor->build(fields, scene, reference);
    fields.rejectUnknown();
    return camera;
  });
}

}  // namespace ocelli
