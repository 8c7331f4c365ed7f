// What a quilt is made of, and how: the options of `ocelli quilt`, and the quilt of one scene or image.
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "display_sim/quilt/quilt_ways.h"

namespace ocelli {

struct QuiltChoice {
  SceneChoice scene;
  std::string display = "portrait";
  std::optional<double> coneDegrees;
  std::string calibration;
  std::string view;
  std::string by = "eoc-h";
  QuiltImageOptions images;

  bool isImage() const { return scene.source.ends_with(".exr"); }
};

/// Adds SCENE and all of the above. `choice` must outlive the command.
void addQuiltOptions(CLI::App& command, QuiltChoice& choice, const CommandContext& context);

/// The views of the display and the cone. Throws InputError.
QuiltViews quiltViewsOf(const QuiltChoice& choice, const CommandContext& context);

/// The scene or the image, loaded.
class QuiltSource {
 public:
  /// Throws InputError.
  QuiltSource(const QuiltChoice& choice, const QuiltViews& views, const CommandContext& context);

  QuiltPicture picture(const QuiltViews& views, QuiltDepths depths, const Progress& progress) const;
  /// In the stretched world of the views; of no use for an image.
  const Mesh& scene() const { return scene_; }
  /// How the picture is made, for people.
  std::string description() const;

 private:
  const QuiltChoice& choice_;
  Mesh scene_;
  ReferenceImages images_;
  std::optional<QuiltLines> lines_;
};

}  // namespace ocelli
