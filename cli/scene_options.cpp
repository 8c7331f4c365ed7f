#include "cli/scene_options.h"

#include <CLI/CLI.hpp>

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

void addSceneOptions(CLI::App& command, SceneChoice& choice) {
  command.add_option("SCENE", choice.source, "A scene file (PLY, OBJ, STL, glTF, ...) or builtin:NAME[,key=value...]")
      ->required();
  command.add_flag_callback(
      "--no-fit", [&choice] { choice.options.fit = false; }, "Leave the scene where it is, not in the unit sphere");
  command
      .add_option_function<std::string>(
          "--shading",
          [&choice](const std::string& name) {
            choice.options.shading = name == "none" ? Shading::kNone : Shading::kLambert;
          },
          "A fixed light on the vertex colours, or the colours as they are")
      ->check(CLI::IsMember({"lambert", "none"}))
      ->default_str("lambert")
      ->type_name("NAME");
  command.add_flag_callback(
      "--no-textures", [&choice] { choice.options.textures = false; }, "Leave the textures of a file out");
}

void addCameraOption(CLI::App& command, std::string& camera) {
  std::string help = "Camera, or a JSON file with its options:";
  for (const CameraName& name : cameraNames()) {
    help += std::string("\n  ") + name.name + ": " + name.description;
  }
  command.add_option("--camera", camera, help)->type_name("NAME|FILE.json");
}

void addSizeOption(CLI::App& command, std::string& size) {
  command.add_option("--size", size, "Size of the image in pixels")->type_name("WIDTHxHEIGHT");
}

void addViewOption(CLI::App& command, std::string& path) {
  command.add_option("--view", path, "Reference view; by default from (0, 0, 10) to the origin")
      ->type_name("FILE.json");
}

View readViewOption(const std::string& path) {
  return path.empty() ? View{} : readView(path);
}

}  // namespace ocelli
