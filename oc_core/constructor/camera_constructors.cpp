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
#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/constructor/path_constructor.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/constructor/target_constructor.h"
#include "oc_core/constructor/walk_fields.h"

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

/// Whether the scene is a grid maze, and nothing is asked for that only walk maps have.
bool isGrid(JsonFields& fields, const GuidedScene& scene, std::initializer_list<const char*> ofWalkMaps) {
  return scene.guides.maze &&
         std::none_of(ofWalkMaps.begin(), ofWalkMaps.end(), [&](const char* name) { return fields.has(name); });
}

MultiperspectiveCamera comprehensiveCamera(JsonFields& fields, const GuidedScene& scene,
                                           const PinholeCamera& reference) {
  ComprehensiveOptions options = readComprehensiveOptions(fields);
  const bool showsObjects = fields.boolean("show_objects", true);
  const WalkStartFields start = readWalkStart(fields);
  WalkComprehensiveOptions walk;
  walk.minPixels = fields.number("min_pixels", 0, 1e6, walk.minPixels);
  std::optional<WalkMap> ways = readWays(fields, scene);
  const int width = reference.width();
  const int height = reference.height();
  if (isGrid(fields, scene, {"ways", "start_cell", "start_point", "heading_degrees", "min_pixels"})) {
    if (showsObjects) {
      options = chooseComprehensive(scene, options, width, height).options;
    }
    return makeComprehensiveCamera(*scene.guides.maze, options, width, height);
  }
  const WalkMap map = walkMapFor(scene, std::move(ways));
  walk.order = options.order;
  walk.start = walkStartOf(map, start);
  walk.nearness = options.nearness;
  walk.evenness = options.evenness;
  walk.eyeHeight = fields.has("eye_height") ? options.eyeHeight : walk.eyeHeight;
  const RayScene rays(scene.mesh);
  return makeComprehensiveWalk(map, walk, width, height, &rays).camera;
}

MultiperspectiveCamera mazeCamera(JsonFields& fields, const GuidedScene& scene, const PinholeCamera& reference) {
  const MazeCameraPlace place = readMazeCamera(fields, reference);
  const bool turned = fields.has("heading");
  const std::optional<glm::dvec3> heading = readHeadingDegrees(fields);
  WalkCameraOptions walk;
  walk.portalsInRooms = fields.number("portals_in_rooms", 0, 1, walk.portalsInRooms);
  std::optional<WalkMap> ways = readWays(fields, scene);
  if (isGrid(fields, scene, {"ways", "heading_degrees", "portals_in_rooms"})) {
    return makeMazeCamera(*scene.guides.maze, place.pose, place.options, reference.width(), reference.height());
  }
  walk.split = place.options.split;
  walk.backward = place.options.backward;
  walk.fovHorizontalDegrees = place.options.fovHorizontalDegrees;
  walk.fovWayDegrees = place.options.fovCorridorDegrees;
  walk.crossingShare = place.options.crossingShare;
  walk.deployWidths = fields.has("deploy_cells") ? place.options.deployCells : walk.deployWidths;
  const glm::dvec3 level = turned ? glm::dvec3(vectorOf(place.pose.heading)) : glm::dvec3(reference.forward());
  WalkCamera made = makeWalkCamera(walkMapFor(scene, std::move(ways)), {place.pose.eye, heading.value_or(level)}, walk,
                                   reference.width(), reference.height());
  if (!made.cell) {
    throw InputError(made.note, "maze camera",
                     "move the eye (--view, or \"position\") over floor that `ocelli scene walk` finds");
  }
  return std::move(made.camera);
}

std::string listOfNames() {
  std::string names;
  for (const CameraConstructor& each : cameraConstructors()) {
    names += names.empty() ? each.name : std::string(", ") + each.name;
  }
  return names;
}

MultiperspectiveCamera constructCamera(const nlohmann::json& json, const std::string& where, const GuidedScene& scene,
                                       const PinholeCamera& reference) {
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
      {"comprehensive", "a whole maze, house or town in one image, each place once", comprehensiveCamera},
      {"portal", "graph camera that looks straight into every portal in view",
       [](JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference) {
         return MultiperspectiveCamera(buildPortalCamera(readPortalOptions(options), scene.guides, reference));
       }},
      {"maze", "along a corridor to the next crossing, and along all ways that leave it", mazeCamera},
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
  return isFile(nameOrFile)
             ? constructCamera(readJsonFile(nameOrFile), nameOrFile, scene, reference)
             : constructCamera(nlohmann::json{{"camera", nameOrFile}}, "--camera " + nameOrFile, scene, reference);
}

MultiperspectiveCamera constructCameraFromJson(const std::string& text, const std::string& where,
                                               const GuidedScene& scene, const PinholeCamera& reference) {
  return constructCamera(parseJson(text, where), where, scene, reference);
}

}  // namespace ocelli
