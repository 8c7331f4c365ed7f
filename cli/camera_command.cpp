#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/output_file.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/multiperspective/plan_picture.h"

namespace ocelli {
namespace {

/// A multiperspective camera in a scene, as its commands take it.
struct CameraInScene {
  SceneChoice scene;
  std::string camera;
  std::string view;
  std::string size = "1280x720";
};

void addCameraInScene(CLI::App& command, CameraInScene& choice) {
  addSceneOptions(command, choice.scene);
  addConstructorOption(command, choice.camera);
  addViewOption(command, choice.view);
  addSizeOption(command, choice.size);
}

MultiperspectiveCamera construct(const CameraInScene& choice, const GuidedScene& scene) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  return constructCamera(choice.camera, scene, {readViewOption(choice.view), size.width, size.height});
}

void addList(CLI::App& camera, const Frame& frame) {
  CLI::App& command = *camera.add_subcommand("list", "List the constructors of graph and curved ray cameras");
  frame.finish(command, "  ocelli camera list", [frame] {
    for (const CameraConstructor& each : cameraConstructors()) {
      frame.print(fmt::format("{:<14} {}\n", each.name, each.description));
    }
  });
}

struct ShowChoice {
  CameraInScene camera;
  std::string from = "top";
  std::optional<float> cut;
  int rays = 48;
  int pixels = 1200;
  std::string output;
};

PlanSide sideFromText(const std::string& text) {
  return text == "top" ? PlanSide::kTop : text == "front" ? PlanSide::kFront : PlanSide::kRight;
}

void show(const ShowChoice& choice, const Frame& frame) {
  checkWritable(choice.output);
  const GuidedScene scene = loadGuidedScene(choice.camera.scene.source, choice.camera.scene.options, frame.progress());
  const MultiperspectiveCamera camera = construct(choice.camera, scene);
  const CameraPlan plan = planOf(
      camera, scene.mesh,
      {.side = sideFromText(choice.from), .cut = choice.cut, .rays = choice.rays, .groundPixels = choice.pixels});
  writePlan(choice.output, plan,
            {.title = choice.camera.camera + " in " + choice.camera.scene.source, .planPixels = choice.pixels});
  frame.note(
      fmt::format("wrote {}: {} parts of the camera, {} rays", choice.output, plan.parts.size(), plan.rays.size()));
}

void addShow(CLI::App& camera, const Frame& frame) {
  CLI::App& command = *camera.add_subcommand("show", "Draw a plan of a camera: its frusta and rays in the scene");
  const auto choice = std::make_shared<ShowChoice>();
  addCameraInScene(command, choice->camera);
  command.add_option("--from", choice->from, "The side that the plan shows the scene from")
      ->check(CLI::IsMember({"top", "front", "right"}))
      ->capture_default_str();
  command.add_option("--cut", choice->cut,
                     "Where the scene is cut open, along the direction of --from; at the eye where not given");
  command.add_option("--rays", choice->rays, "How many rays, from the left of the image to its right")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command.add_option("--pixels", choice->pixels, "Longer side of the plan")
      ->check(CLI::Range(100, 8192))
      ->capture_default_str();
  addOutputOption(command, choice->output, "Where the plan goes", {".svg", ".png"});
  frame.finish(command,
               "  ocelli camera show builtin:maze --camera comprehensive -o plan.svg\n"
               "  ocelli camera show builtin:town --camera town.json --from front -o plan.png",
               [choice, frame] { show(*choice, frame); });
}

}  // namespace

void addCameraCommand(CLI::App& program, const Frame& frame) {
  CLI::App& camera = *program.add_subcommand("camera", "Graph and curved ray cameras: list, show");
  camera.require_subcommand(1);
  addList(camera, frame);
  addShow(camera, frame);
}

}  // namespace ocelli
