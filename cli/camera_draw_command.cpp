#include "cli/camera_draw_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/frustum_editor/editor_script.h"

namespace ocelli {
namespace {

struct DrawChoice {
  SceneChoice scene;
  std::string view;
  std::string script;
  std::string output;
};

void draw(const DrawChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const std::filesystem::path file(choice.script);
  const EditorScript script = editorScriptFromJsonText(readFile(file, kMaxTextBytes), choice.script);
  const GuidedScene scene = loadGuidedScene(choice.scene.source, choice.scene.options, context.progress());
  EditorSession session = playEditorScript(script, file.parent_path(), readViewOption(choice.view), scene.mesh,
                                           scene.guides, std::filesystem::path(choice.output).parent_path());
  writeFile(choice.output, session.editor().text());
  context.note(fmt::format("wrote {} after {} steps: {} frusta", choice.output, script.steps.size(),
                           session.editor().drawn().frusta.size()));
}

}  // namespace

void addCameraDraw(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand("draw", "Draw a camera in plans by a script of strokes and drags");
  const auto choice = std::make_shared<DrawChoice>();
  addSceneOptions(command, choice->scene, context);
  addViewOption(command, choice->view);
  command
      .add_option("--script", choice->script,
                  "The steps (docs/drawing_cameras.md). Files that it writes go beside the camera")
      ->type_name("FILE.json")
      ->required();
  addOutputOption(command, choice->output, "Where the camera goes", {".json"});
  context.finish(
      command, "  ocelli camera draw builtin:town --no-fit --script docs/cameras/examples/draw_town.json -o town.json",
      [choice, context] { draw(*choice, context); });
}

}  // namespace ocelli
