// The ways to make a quilt of a scene, by name: what `ocelli quilt --by` takes. To add one: one row in quilt_ways.cpp,
// or registerQuiltWay() from outside of the tree.
#pragma once

#include <functional>
#include <string>

#include "display_sim/quilt/quilt_images.h"
#include "oc_core/base/registry.h"

namespace ocelli {

struct QuiltWayInputs {
  const QuiltViews& views;
  const Mesh& scene;  ///< in the stretched world
  const QuiltImageOptions& images;
  QuiltDepths depths = QuiltDepths::kNone;
  const Progress& progress;
};

struct QuiltWay {
  std::string name;
  std::string help;  ///< one line
  std::function<QuiltPicture(const QuiltWayInputs& inputs)> make;
};

Rows<QuiltWay> quiltWays();
/// Throws InputError where its name is taken.
void registerQuiltWay(QuiltWay way);
/// Throws InputError, naming `where`, for other names.
const QuiltWay& quiltWayNamed(const std::string& name, const std::string& where);

}  // namespace ocelli
