// What can stand for the object of relief tiles, by name.
#pragma once

#include <memory>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/relief/relief_object.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Help for the names that buildReliefObject() takes.
inline constexpr const char* kReliefKindsHelp =
    "height-field (conventional relief, 16 linear and 5 binary steps; height-field-N has N linear ones), layered-N (N "
    "layers of it), or the reference images of a camera from above: a name or a JSON file";

struct BuiltRelief {
  std::string name;
  std::shared_ptr<const ReliefObject> object = {};
  double buildMilliseconds = 0;      ///< of the images
  double structureMilliseconds = 0;  ///< of cells and pyramid; 0 where there is none
};

/// Throws InputError for another name, and for what has no image.
void checkReliefKind(const std::string& name);

/// `mesh` is the object in the coordinates of its tiles: in the unit sphere, its normal along +y. Its images have about
/// `texels` pixels; those of cameras that add rows to an image, at most a fifth more. An object without triangles gives
/// one that nothing meets. Throws as checkReliefKind() does, and where the images cannot be built.
BuiltRelief buildReliefObject(const std::string& name, const Mesh& mesh, size_t texels, const Progress& progress = {});

}  // namespace ocelli
