// Constructors of multiperspective cameras (sections 4.3.1 and 4.3.2): from a scene, a reference view and options to a
// graph camera or a curved ray camera. A user names one after `--camera`, or in the field "camera" of a JSON file whose
// other fields are its options.
//
// Recipe for a new constructor, three places:
//   1. oc_core/constructor/NAME_constructor.h and .cpp: a struct of options with their defaults, a function that builds
//      the camera from it, and one that reads the options from JSON.
//   2. oc_core/constructor/camera_constructors.cpp: one line in the table.
//   3. oc_core/constructor/constructor.schema.json: its options.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class JsonFields;

struct CameraConstructor {
  const char* name;
  const char* description;
  /// Reads its options, which may all be missing, and builds. `reference` is the user's view; its size is that of the
  /// image. Throws InputError where the options do not fit the scene.
  MultiperspectiveCamera (*build)(JsonFields& options, const GuidedScene& scene, const PinholeCamera& reference);
};

const std::vector<CameraConstructor>& cameraConstructors();

/// Whether that is the name of a constructor, or a JSON file whose "camera" is one. Throws InputError where a file
/// cannot be read.
bool namesConstructor(const std::string& nameOrFile);

/// The size of images that a file asks for (graph_operations.h); nothing for names and for files of any size.
std::optional<glm::ivec2> sizeInFile(const std::string& nameOrFile);

/// Throws InputError for an unknown name, a file that is wrong, and options that do not fit the scene.
MultiperspectiveCamera constructCamera(const std::string& nameOrFile, const GuidedScene& scene,
                                       const PinholeCamera& reference);
/// The same from the text of such a file; `where` names it in messages.
MultiperspectiveCamera constructCameraFromJson(const std::string& text, const std::string& where,
                                               const GuidedScene& scene, const PinholeCamera& reference);

}  // namespace ocelli
