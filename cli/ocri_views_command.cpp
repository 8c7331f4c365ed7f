#include "cli/ocri_views_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iterator>

#include "cli/scene_notes.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

struct OcriViewsChoice {
  SceneChoice scene;
  std::string view;
  std::string size = "720x480";
  std::string cell = "8in";
  int corners = 8;
  std::string format = "exr";
  std::string output;
};

const DepthViewsFormat& formatNamed(const std::string& name) {
  for (const DepthViewsFormat& format : depthViewsFormats()) {
    if (name == format.name) {
      return format;
    }
  }
  throw InputError("there is no format \"" + name + "\"", "--format", "use exr or png");
}

void runOcriViews(const OcriViewsChoice& choice, const CommandContext& context) {
  const DepthViewsFormat& format = formatNamed(choice.format);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  const PinholeCamera reference(readViewOption(choice.view), size.width, size.height);
  ViewCell cell;
  cell.sideRadii = cellSideFromText(choice.cell, "--cell");
  const Mesh mesh = loadScene(choice.scene.source, choice.scene.options, context.progress());
  noteBlackScene(context, mesh);
  ReferenceImages images = buildCornerDepthImages(reference, mesh, cell, choice.corners);
  std::vector<DepthView> views;
  for (ReferenceImage& image : images) {
    requireOutside(mesh, image.view.eye, fmt::format("view {}", views.size()));
    image.camera = "di";
    views.push_back({fmt::format("v{:02}", views.size()), std::move(image)});
    requireDepthView(views.back().image, views.back().name);
  }
  writeDepthViews(choice.output, views, format, context.progress());
  context.note(fmt::format("wrote {} views of {}x{}, {} samples, to {}", views.size(), size.width, size.height,
                           sampleCount(views), choice.output));
}

}  // namespace

void addOcriViews(CLI::App& ocri, const CommandContext& context) {
  CLI::App& command = *ocri.add_subcommand(
      "views",
      "Make a folder of views with depth of a scene: from the reference view and the corners of its view cell");
  const auto choice = std::make_shared<OcriViewsChoice>();
  addSceneOptions(command, choice->scene, context);
  addMotionOptions(command, choice->scene);
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  command.add_option("--cell", choice->cell, "Side of the view cell, in inches at the reference display")
      ->type_name("SIDE");
  command
      .add_option("--corners", choice->corners, "From how many corners of the cell: 4 (those towards the scene) or 8")
      ->check(CLI::IsMember({4, 8}))
      ->type_name("4|8");
  command.add_option("--format", choice->format, "exr: an EXR file each, exact. png: PNG files, and views.json")
      ->check(CLI::IsMember({"exr", "png"}))
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("-o,--output", choice->output, "The folder; it holds no views yet")
      ->required()
      ->type_name("FOLDER");
  context.finish(command,
                 "  ocelli ocri views builtin:statues -o views\n"
                 "  ocelli ocri views bunny.obj --cell 4in --corners 4 --format png -o views",
                 [choice, context] { runOcriViews(*choice, context); });
}

}  // namespace ocelli
