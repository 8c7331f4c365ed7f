// `ocelli view`: a window to look around in, or the same driven by a script.
#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/effect_options.h"
#include "cli/gl_drawing.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/volume_options.h"
#ifdef OCELLI_WITH_OPENGL
#include "display_sim/viewer/viewer_run.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/gl/gl_context.h"
#include "oc_core/shade/effects.h"
#endif

namespace ocelli {
namespace {

struct ViewChoice {
  SceneChoice scene;
  VolumeChoice volume;
  std::string camera = "ddoc";
  bool cameraGiven = false;
  std::string view;
  std::string size = "720x480";
  std::string profile = "perspecta";
  std::string script;
  std::string gl = "auto";
  std::string folder = ".";
  std::string effect;
  std::string way;
  std::string roles;
};

#ifdef OCELLI_WITH_OPENGL
/// `rays` gets what only volumes take.
std::string cameraOfPanes(const ViewChoice& choice, std::string& rays) {
  const bool isVolume = isVolumeSource(choice.scene.source);
  if (isVolume && choice.cameraGiven && namesConstructor(choice.camera)) {
    rays = choice.camera;
  } else if (choice.cameraGiven || !takesVolume(choice.scene)) {
    return choice.camera;
  }
  return takesVolume(choice.scene) ? "di" : "ddoc";  // there is nothing that images of a volume alone could miss
}

ViewerOptions viewerOptions(const ViewChoice& choice) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  ViewerOptions options;
  options.source = choice.scene.source;
  options.sceneOptions = choice.scene.options;
  if (isVolumeSource(choice.scene.source)) {
    options.volumeOptions = volumeSceneOptionsOf(choice.scene, choice.volume);
    if (choice.scene.shadingGiven) {
      options.volumeIsShaded = choice.scene.options.shading == Shading::kLambert;
    }
  } else {
    refuseVolumeOptions(choice.volume);
  }
  options.camera = cameraChoice(cameraOfPanes(choice, options.volumeRays));
  options.reference = cameraView(choice.cameraGiven ? choice.camera : "", choice.view);
  options.width = size.width;
  options.height = size.height;
  options.profile = choice.profile;
  options.folder = choice.folder;
  options.effect.rolesFile = choice.roles;
  if (!choice.effect.empty()) {
    const Effect& effect = shadeEffect(choice.effect);
    if (!choice.way.empty()) {
      effect.checkWay(choice.way);
    }
    options.effect.on = true;
    options.effect.effect = choice.effect;
    options.effect.way = choice.way;
  } else if (!choice.way.empty()) {
    throw InputError("only with --effect", "--by " + choice.way, "give --effect NAME, or leave it out");
  }
  return options;
}

void view(const ViewChoice& choice, const CommandContext& context) {
  const ViewerOptions options = viewerOptions(choice);
  if (choice.script.empty() && choice.gl != "auto") {
    throw InputError("only with --offscreen", "--gl", "leave it out: a window is drawn by what its display offers");
  }
  if (choice.script.empty()) {
    runViewerWindow(options);
    return;
  }
  const ViewerScript script = readViewerScript(choice.script);
  const std::unique_ptr<GlContext> gl = openGlContext(choice.gl, "--gl");
  runViewerScript(*gl, options, script, [&](const std::string& file) { context.note("wrote " + file); });
}
#else
void view(const ViewChoice&, const CommandContext&) {
  failWithoutOpenGl();
}
#endif

}  // namespace

void addViewCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("view", "Look around in a window: scene, rays, reconstruction, display");
  const auto choice = std::make_shared<ViewChoice>();
  addSceneOptions(command, choice->scene, context);
  addVolumeOptions(command, choice->volume);
  addCameraOption(command, choice->camera);
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  command.add_option("--profile", choice->profile, "Display to simulate")->type_name("NAME|FILE.json");
  command.add_option("-o,--output", choice->folder, "Folder for saved images and views")->type_name("DIR");
  command.add_option("--offscreen", choice->script, "Play a script to the viewer, without a display")
      ->type_name("SCRIPT.json");
  command.add_option("--effect", choice->effect, "Start with a picture of this effect, as in shade: " + effectHelp())
      ->type_name("NAME");
  command.add_option("--by", choice->way, "What stands for the scene where its rays go; by default the camera")
      ->type_name("NAME");
  addRolesOption(command, choice->roles);
  addGlOption(command, choice->gl);
  context.finish(command,
                 "  ocelli view builtin:statues\n"
                 "  ocelli view bunny.obj --camera cell --size 1440x960\n"
                 "  ocelli view scan.nrrd --transfer ct-bone\n"
                 "  ocelli view builtin:mirror --effect reflection --by cell\n"
                 "  ocelli view builtin:room --offscreen tour.json -o frames",
                 [choice, context, camera = command.get_option("--camera")] {
                   choice->cameraGiven = camera->count() > 0;
                   view(*choice, context);
                 });
}

}  // namespace ocelli
