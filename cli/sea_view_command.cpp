// `ocelli sea view`: a walk through a sea of images in a window.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/gl_drawing.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/sea_command.h"
#include "cli/values.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/sea/sea_file.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/gl/gl_context.h"
#include "oc_core/sea_window/sea_window.h"
#endif

namespace ocelli {
namespace {

struct SeaViewChoice {
  std::string file;
  std::string save;
  std::string size = "1280x800";
  std::string at;
  std::optional<double> yaw;
  bool help = false;
  std::string gl = "auto";
};

#ifdef OCELLI_WITH_OPENGL
void savePicture(const SeaViewChoice& choice, const SeaFile& sea, const CommandContext& context) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  const std::optional<glm::dvec3> place =
      choice.at.empty() ? std::nullopt : std::optional(glm::dvec3(pointFromText(choice.at, "--at")));
  checkWritable(choice.save);
  const std::unique_ptr<GlContext> gl = openGlContext(choice.gl, "--gl");
  writePng(choice.save, pictureOfSeaWindow(*gl, sea, {size.width, size.height}, place,
                                           radiansFromDegrees(choice.yaw.value_or(0)), choice.help));
  context.note("wrote " + choice.save);
}
#endif

void runView(const SeaViewChoice& choice, const CommandContext& context) {
  if (choice.save.empty() && (!choice.at.empty() || choice.yaw || choice.help)) {
    throw InputError("in a window one walks and turns oneself", "--at, --yaw, --keys",
                     "give --save PICTURE.png with them");
  }
  const SeaFile sea(choice.file);
#ifdef OCELLI_WITH_OPENGL
  if (!choice.save.empty()) {
    savePicture(choice, sea, context);
    return;
  }
  runSeaWindow(sea, "Ocelli: " + std::filesystem::path(choice.file).filename().string());
#else
  (void)context;
  failWithoutOpenGl("sea view");
#endif
}

}  // namespace

void addSeaViewCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("view", "Walk through a sea of images in a window; its keys: H");
  const auto choice = std::make_shared<SeaViewChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  addSecondOutputOption(command, "--save", choice->save, "Write a picture of the window instead of opening it",
                        {".png"});
  command.add_option("--size", choice->size, "Of the picture")->capture_default_str()->type_name("WIDTHxHEIGHT");
  command.add_option("--at", choice->at, "Of the picture: where one stands; at the first image by default")
      ->type_name("X,Y,Z");
  command.add_option("--yaw", choice->yaw, "Of the picture: how far one looks to the left of -z; 0 by default")
      ->type_name("DEGREES");
  command.add_flag("--keys", choice->help, "Of the picture: with the help");
  addGlOption(command, choice->gl);
  context.finish(command,
                 "  ocelli sea view museum.sea\n"
                 "  ocelli sea view museum.sea --save walk.png --at 1,1.6,-2 --yaw 90",
                 [choice, context] { runView(*choice, context); });
}

}  // namespace ocelli
