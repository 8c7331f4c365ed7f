// The SCENE of commands that look at it from viewpoints: a mesh, or a packed scene, of which each view takes what it
// needs.
#pragma once

#include <optional>
#include <utility>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/pack/packed_scene.h"

namespace ocelli {

class ViewedScene {
 public:
  /// Loads or opens it, and notes where it is black. Throws as loadScene() and openPacked() do.
  ViewedScene(const SceneChoice& scene, const CommandContext& context);
  explicit ViewedScene(Mesh mesh) : mesh_(std::move(mesh)) {}

  /// What the images of this choice are made of: of a packed scene valid until the next call. Throws InputError where a
  /// viewpoint lies inside an object of a packed scene.
  const Mesh& meshFor(const CameraChoice& choice, const PinholeCamera& reference);

 private:
  std::optional<PackedScene> packed_;
  Mesh mesh_;
};

}  // namespace ocelli
