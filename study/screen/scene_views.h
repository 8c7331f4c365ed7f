// Draws what the cameras of a trial see of its scene: uploaded once a scene, after which only what moves is sent again.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "oc_core/gl/gl_renderer.h"
#include "study/task/trial_layout.h"

namespace ocelli {

class SceneViews {
 public:
  /// The context must outlive it.
  explicit SceneViews(GlContext& context) : context_(&context) {}

  /// Into a texture of GL_RGBA8, row 0 at the top, as sRGB values: each view at its place, which must lie within it.
  /// Nothing where the layout has no views. Hold a GlScope, here and below. Throws GlError.
  void draw(const TrialLayout& layout, const GlObject& target);

  /// An object of a scene by itself, as a square texture of GL_RGBA8 whose alpha says where it is.
  const GlObject& portraitOf(const StudyScene& scene, int object, int pixels);

 private:
  void prepare(const StudyScene& scene);
  void move(const StudyScene& scene, std::span<const glm::vec3> offsets);
  /// Of the mesh that stands for a scene, which stays uploaded for some images more.
  GlRenderer& rendererOf(const std::shared_ptr<const ShownContent>& shown);

  GlContext* context_;
  std::unique_ptr<GlRenderer> renderer_;
  Mesh base_;   ///< of the scene that is uploaded
  Mesh moved_;  ///< as it is uploaded now
  std::vector<glm::vec3> offsets_;
  struct ShownRenderer {
    std::shared_ptr<const ShownContent> shown;
    std::unique_ptr<GlRenderer> renderer;
  };
  static constexpr size_t kMaxShown = 8;
  std::vector<ShownRenderer> shown_;
  struct Portrait {
    Mesh mesh;
    int pixels = 0;
    GlObject texture;
  };
  std::optional<Portrait> portrait_;
};

}  // namespace ocelli
