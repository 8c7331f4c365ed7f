// `--gl`, and what `--method gl` and `--construction gl` draw scenes with: a renderer on the GPU for one scene, with
// the context that it needs.
#pragma once

#include <memory>
#include <string>

#include "oc_core/depth_rays/depth_ray_caster.h"
#include "oc_core/render/scene_renderer.h"

namespace CLI {
class App;
}

namespace ocelli {

/// Adds `--gl auto|egl|osmesa`.
void addGlOption(CLI::App& command, std::string& provider);

/// Adds `--gl auto|egl|osmesa` to a command that uses OpenGL where it is given, and only there; `provider` is empty
/// before. `use` says what OpenGL does then: "Cast rays with OpenGL".
void addGlSwitch(CLI::App& command, std::string& provider, const std::string& use);

/// Adds `--method cpu|gl`, for work that has these two ways.
void addMethodOption(CLI::App& command, std::string& method);

/// Throws InputError where --gl names a provider but nothing draws with OpenGL; `by` is the option that makes it so.
void requireGlUsed(const std::string& provider, bool used, const std::string& by);

/// Throws InputError: this program was built without OpenGL.
[[noreturn]] void failWithoutOpenGl(const std::string& where = "--method or --construction");

/// Casts rays at depth images with OpenGL. Throws InputError where this program was built without it, GlError where no
/// context can be opened.
std::shared_ptr<const DepthRayCaster> openRayCaster(const std::string& provider);

class GlDrawing {
 public:
  /// Opens the context: before the scene is loaded, so that a machine without OpenGL says so at once. Throws InputError
  /// where this program was built without OpenGL, GlError where no context can be opened.
  explicit GlDrawing(const std::string& provider);
  ~GlDrawing();
  GlDrawing(const GlDrawing&) = delete;
  GlDrawing& operator=(const GlDrawing&) = delete;

  /// Uploads the mesh, which it does not keep. Throws GlError where the GPU has no room for it.
  const SceneRenderer& rendererOf(const Mesh& mesh);
  /// "OpenGL on llvmpipe, through EGL".
  std::string description() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
