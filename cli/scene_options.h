// The options of every command that takes a SCENE.
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/values.h"
#include "oc_core/camera/view.h"
#include "oc_core/worlds/scene_source.h"

namespace CLI {
class App;
}

namespace ocelli {

struct SceneChoice {
  std::string source;
  SceneOptions options;
  bool shadingGiven = false;  ///< whether the user said --shading
};

/// Adds the argument SCENE, --no-fit, --shading, --no-textures, --texture-triangles, --point-size, --labels,
/// --label-facing, --iso, --transfer and --series. `choice` must outlive the parsing. What there is to say of the scene
/// that is loaded then, such as a missing texture, becomes a note of `frame`.
void addSceneOptions(CLI::App& command, SceneChoice& choice, const CommandContext& context);

/// The same without the argument: the scene is the option --scene, which may be missing.
void addSceneOption(CLI::App& command, SceneChoice& choice, const CommandContext& context);

/// Adds what there is to say of a SCENE that moves: --time, --animation, --rate and --between.
void addMotionOptions(CLI::App& command, SceneChoice& choice);

/// Adds --camera NAME|FILE.json|RAYS.exr, for the cameras that build reference images.
void addCameraOption(CLI::App& command, std::string& camera);
/// The same for constructors of graph and curved ray cameras; it is required. No ray maps.
void addConstructorOption(CLI::App& command, std::string& camera);
/// The same for both.
void addAnyCameraOption(CLI::App& command, std::string& camera);
/// Adds --size WIDTHxHEIGHT. Read it with imageSizeFromText() when the command runs.
void addSizeOption(CLI::App& command, std::string& size);

/// The same for cameras whose file may say a size: empty where it is not given. Read it with cameraImageSize().
void addCameraSizeOption(CLI::App& command, std::string& size, const ImageSize& otherwise);
/// The size that the user gave, or the camera's file, or that one.
ImageSize cameraImageSize(const std::string& camera, const std::string& size, const ImageSize& otherwise);

/// Adds --metre UNITS, of commands that know people's lengths. Where it is not given, metreOf() guesses.
void addMetreOption(CLI::App& command, std::optional<double>& metre);

/// Adds --view FILE.json. Read it with readViewOption() when the command runs.
void addViewOption(CLI::App& command, std::string& path);
/// The view of the file, or the default one where no --view was given. Throws InputError.
View readViewOption(const std::string& path);
/// The same for a camera, which is the file of a ray map perhaps: that says the view where no --view was given, and
/// takes none where it stands in the world already.
View cameraView(const std::string& camera, const std::string& path);

}  // namespace ocelli
