// `ocelli solidity`: how solid a scene looks on a display that emits light and hides nothing.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <system_error>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/volume_options.h"
#include "cli/volume_slicing_options.h"
#include "display_sim/slicing/slicer.h"
#include "display_sim/solidity/solidity_report.h"
#include "display_sim/volume_solidity/volume_ways.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/ray_map/ray_map_file.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

struct SolidityChoice {
  SceneChoice scene;
  VolumeChoice volume;
  std::vector<std::string> cameras{"di", "ddoc"};
  bool camerasGiven = false;
  std::vector<std::string> ways;
  std::string cell = "8in";
  std::string view;
  std::string size = "720x480";
  std::string profile = "perspecta";
  int interiorViews = 4;
  unsigned seed = 1;
  int imageSide = 0;
  std::string json;
  std::string images;
};

/// What stands for the scene: by a camera, or finished images.
struct Shown {
  std::string name;
  std::optional<CameraChoice> camera;
  ReferenceImages images;
};

Shown shownFromText(const std::string& text, const ViewCell& cell) {
  if (text.ends_with(".exr") && !holdsRays(text)) {
    return {fs::path(text).stem().string(), std::nullopt, readReferenceImages(text)};
  }
  const CameraChoice camera = cameraChoice(text, cell);
  return {camera.name, camera, {}};
}

/// Names that files of images can have.
std::string fileName(const std::string& name) {
  std::string file = name;
  for (char& c : file) {
    c = c == ' ' || c == '/' ? '-' : c;
  }
  return file;
}

/// Of the first eye, and the last one of the second group: a corner of the cell.
SolidityMeter::Visitor imageWriter(const std::string& folder, const std::string& name, const SolidityOptions& options) {
  if (folder.empty()) {
    return {};
  }
  return [&options, folder, file = fileName(name)](const ObservedFrame& frame) {
    const bool corner = frame.group == 1 && frame.eye + 1 == options.groups[1].eyes.size();
    if (frame.group == 0 || corner) {
      const std::string place = corner ? "corner" : "reference";
      writePng(fs::path(folder) / fmt::format("{}-opaque.png", place), frame.opaque);
      writePng(fs::path(folder) / fmt::format("{}-{}.png", place, file), frame.observed);
      writePng(fs::path(folder) / fmt::format("{}-{}-hidden.png", place, file), frame.hidden);
    }
  };
}

void prepareOutputs(const SolidityChoice& choice) {
  checkFiguresOutput(choice.json);
  if (!choice.images.empty()) {
    std::error_code error;
    fs::create_directories(choice.images, error);
    if (error) {
      throw WorkError("cannot make this folder (" + error.message() + ")", choice.images, "choose another one with -o");
    }
  }
}

void requireImageSide(const SolidityChoice& choice, const DisplayProfile& profile) {
  constexpr int kMinSide = 16;  // FLIP looks at neighbourhoods
  if (const int side = choice.imageSide > 0 ? choice.imageSide : profile.height; side < kMinSide) {
    throw InputError(fmt::format("images of {} pixels are too small to compare", side), "--image-side",
                     fmt::format("make it {} or more", kMinSide));
  }
}

void finish(const SolidityChoice& choice, const SolidityOptions& options, const std::vector<SolidityFigures>& rows,
            const CommandContext& context) {
  giveFigures(choice.json, solidityJson(choice.scene.source, options, rows), solidityTable(options, rows), context);
  if (!choice.images.empty()) {
    context.note("wrote images to " + choice.images);
  }
}

std::vector<std::string> allWays() {
  std::vector<std::string> names;
  for (const VolumeWay& way : volumeWays()) {
    names.emplace_back(way.name);
  }
  return names;
}

/// Ways to show a volume of scalars, with what it looks like where it absorbs light for their truth.
void runVolume(const SolidityChoice& choice, const SolidityOptions& options, const PinholeCamera& reference,
               const ViewCell& cell, const CommandContext& context) {
  if (choice.camerasGiven) {
    throw InputError("a volume is compared by ways to show it", "--cameras", "--ways everything,seen");
  }
  VolumeWaysToMeasure wanted{.scene = loadVolume(choice.scene, choice.volume, context),
                             .shown = {.surface = choice.scene.options.iso},
                             .ways = choice.ways.empty() ? allWays() : choice.ways,
                             .settings = {.referenceEye = reference.eye(), .cellEyes = {reference.eye()}}};
  if (const std::optional<double>& iso = choice.scene.options.iso) {
    requireSurface(wanted.scene, *iso, choice.scene.source);
  }
  for (const View& corner : cell.edgeViews(reference.view(), 0)) {
    wanted.settings.cellEyes.push_back(corner.eye);
  }
  for (const std::string& way : wanted.ways) {
    volumeWayByName(way, "--ways");
  }
  prepareOutputs(choice);
  finish(choice, options,
         measureVolumeWays(wanted, options, context.progress(),
                           [&](const std::string& way) { return imageWriter(choice.images, way, options); }),
         context);
}

void run(const SolidityChoice& choice, const CommandContext& context) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  const PinholeCamera reference(readViewOption(choice.view), size.width, size.height);
  const ViewCell cell{.sideRadii = cellSideFromText(choice.cell, "--cell")};
  const SolidityOptions options{
      .profile = loadProfile(choice.profile),
      .groups = eyesOfCell(reference.view(), cell, choice.interiorViews, choice.seed),
      .imageSide = choice.imageSide,
  };
  requireImageSide(choice, options.profile);
  if (isVolumeSource(choice.scene.source)) {
    return runVolume(choice, options, reference, cell, context);
  }
  refuseVolumeOptions(choice.volume);
  refuseVolumeOption(!choice.ways.empty(), "--ways");
  std::vector<Shown> compared;
  for (const std::string& name : choice.cameras) {
    compared.push_back(shownFromText(name, cell));
  }
  prepareOutputs(choice);
  const Mesh scene = loadScene(choice.scene.source, choice.scene.options, context.progress());
  SolidityMeter meter(scene, options);
  std::vector<SolidityFigures> rows;
  const auto measure = [&](const std::string& name, const Volume& volume, size_t triangles,
                           SolidityMeter::Shown shown) {
    rows.push_back(
        meter.measure(name, volume, triangles, shown, context.progress(), imageWriter(choice.images, name, options)));
  };
  const Volume full = slice(scene, options.profile);
  measure("visible voxels", full, scene.triangles.size(), SolidityMeter::Shown::kVisibleOnly);
  measure("geometry", full, scene.triangles.size(), SolidityMeter::Shown::kEverything);
  for (const Shown& each : compared) {
    const Mesh mesh = each.camera ? buildRepresentation(*each.camera, reference, scene, context.progress()).mesh
                                  : unionMesh(each.images);
    measure(each.name, slice(mesh, options.profile), mesh.triangles.size(), SolidityMeter::Shown::kEverything);
  }
  finish(choice, options, rows, context);
}

}  // namespace

void addSolidityCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "solidity", "Measure how solid a scene looks on a display that emits light and hides nothing");
  const auto choice = std::make_shared<SolidityChoice>();
  addSceneOptions(command, choice->scene, context);
  addVolumeOptions(command, choice->volume);
  command
      .add_option_function<std::vector<std::string>>(
          "--cameras",
          [choice = choice.get()](const std::vector<std::string>& cameras) {
            choice->cameras = cameras;
            choice->camerasGiven = true;
          },
          "What to compare with the full geometry: names of cameras, JSON files, or reference images (.exr)")
      ->delimiter(',')
      ->default_str("di,ddoc")
      ->type_name("NAME,...");
  std::string waysHelp = "Of a volume: which ways to show it are compared, by default all:";
  for (const VolumeWay& way : volumeWays()) {
    waysHelp += fmt::format("\n  {}: {}", way.name, way.summary);
  }
  command.add_option("--ways", choice->ways, waysHelp)->delimiter(',')->type_name("NAME,...");
  command.add_option("--cell", choice->cell, "Side of the cube of eyes, in inches at the reference display")
      ->type_name("SIDE");
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  command.add_option("--profile", choice->profile, "The display: a name, or a profile of your own")
      ->type_name("NAME|FILE.json");
  command.add_option("--interior", choice->interiorViews, "How many eyes inside of the cell")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command.add_option("--seed", choice->seed, "Of the eyes inside")->type_name("S");
  command
      .add_option("--image-side,--picture-side", choice->imageSide,
                  "Of the images, pixels; 0: as many as the display has rows, so that a voxel is about a pixel")
      ->check(CLI::Range(0, 8192))
      ->type_name("N");
  addFiguresOption(command, choice->json);
  command.add_option("-o,--output", choice->images, "Also write images from the reference eye and a corner here")
      ->type_name("DIR");
  context.finish(
      command,
      "  ocelli solidity builtin:statues\n"
      "  ocelli solidity bunny.obj --cameras di,ddoc,eoc-hv --cell 4in --json bunny.json -o bunny\n"
      "  ocelli solidity builtin:volume,name=skull --transfer ct-bone --ways everything,seen,seen-cell -o skull",
      [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
