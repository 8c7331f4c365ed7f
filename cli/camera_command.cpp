#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/camera_compare.h"
#include "cli/camera_draw_command.h"
#include "cli/camera_osl_command.h"
#include "cli/camera_rays_command.h"
#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/camera_editor.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/figure_file.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/multiperspective/plan_image.h"
#include "oc_core/multiperspective/rate_figure.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ray_map/ray_map_file.h"

namespace ocelli {
namespace {

constexpr ImageSize kCameraImageSize{1280, 720};

/// A multiperspective camera in a scene, as its commands take it.
struct CameraInScene {
  SceneChoice scene;
  std::string camera;
  std::string view;
  std::string size;
};

void addCameraInScene(CLI::App& command, CameraInScene& choice, const CommandContext& context) {
  addSceneOptions(command, choice.scene, context);
  addConstructorOption(command, choice.camera);
  addViewOption(command, choice.view);
  addCameraSizeOption(command, choice.size, kCameraImageSize);
}

PinholeCamera referenceOf(const CameraInScene& choice) {
  const ImageSize size = cameraImageSize(choice.camera, choice.size, kCameraImageSize);
  return {cameraView(choice.camera, choice.view), size.width, size.height};
}

/// That of the file of a ray map, where it stands.
RayMapCamera rayMapCameraOf(const CameraInScene& choice) {
  const PinholeCamera reference = referenceOf(choice);
  return {std::make_shared<const RayMap>(readRayMap(choice.camera).placedAt(reference.view())),
          {reference.width(), reference.height()}};
}

MultiperspectiveCamera construct(const CameraInScene& choice, const GuidedScene& scene) {
  return constructCamera(choice.camera, scene, referenceOf(choice));
}

std::string optionText(const CameraOption& option, const CameraChoice& choice) {
  std::string value;
  std::string range;
  if (isDirection(option)) {
    const glm::vec3 direction = directionOf(option, choice);
    value = fmt::format("[{}, {}, {}]", direction.x, direction.y, direction.z);
  } else if (isBoolean(option)) {
    value = numberOf(option, choice) != 0 ? "true" : "false";
  } else {
    value = option.onOff.isOn != nullptr && !option.onOff.isOn(choice)
                ? "off"
                : fmt::format("{}", static_cast<float>(numberOf(option, choice)));
    range = fmt::format(", {:g} to {:g}", option.min, option.max);
  }
  const std::string unit = *option.unit == '\0' ? "" : fmt::format(" {}", option.unit);
  return fmt::format("  {:<30} {}{}{}\n      {}\n", option.name, value, unit, range, option.meaning);
}

/// One camera with the options of its file, or all cameras.
void list(const std::string& name, const CommandContext& context) {
  if (name.empty()) {
    context.print("Cameras, and other representations of a scene:\n");
    for (const CameraName& each : cameraNames()) {
      context.print(fmt::format("  {:<18} {}\n", each.name, each.description));
    }
    context.print("\nGraph and curved ray cameras, by what constructs them:\n");
    for (const CameraConstructor& each : cameraConstructors()) {
      context.print(fmt::format("  {:<18} {}\n", each.name, each.description));
    }
    context.print("\nOptions of one of the first list: `ocelli camera list NAME`.\n");
    return;
  }
  const CameraChoice choice = cameraChoice(name);
  context.print(fmt::format("{}: {}\n", name, choice.kind->description));
  if (choice.kind->options.empty() && choice.kind->structures.empty()) {
    context.print("It has no options.\n");
    return;
  }
  context.print(fmt::format("Options, fields of a JSON file with \"camera\": \"{}\" that --camera takes:\n", name));
  for (const CameraOption* option : choice.kind->options) {
    context.print(optionText(*option, choice));
  }
  for (const CameraStructure* structure : choice.kind->structures) {
    context.print(fmt::format("  {:<30} {}\n      {}\n", structure->name, structure->text(choice), structure->meaning));
  }
}

void addCameraList(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand("list", "List all cameras, or the options of one");
  const auto name = std::make_shared<std::string>();
  command.add_option("NAME", *name, "A camera or its file; the list of all where not given");
  context.finish(command, "  ocelli camera list\n  ocelli camera list ddoc", [name, context] { list(*name, context); });
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

/// The names of cameras that have something to show.
std::string shownCameras() {
  std::string names;
  for (const CameraName& camera : cameraNames()) {
    if (cameraChoice(camera.name).kind->layout) {
      names += std::string(camera.name) + ", ";
    }
  }
  for (const CameraConstructor& constructor : cameraConstructors()) {
    names += std::string(constructor.name) + ", ";
  }
  return names + "or a file of one";
}

/// Of a camera that builds reference images: where it has how many samples, over what it sees.
void showRates(const ShowChoice& choice, const CommandContext& context) {
  const std::string& name = choice.camera.camera;
  if (!namesCamera(name)) {
    throw InputError("there is no camera \"" + name + "\"", "--camera", "use " + shownCameras());
  }
  const CameraChoice camera = cameraChoice(name);
  if (!camera.kind->layout) {
    throw InputError("camera \"" + camera.name + "\" has no regions of detail and no frusta to show",
                     "--camera " + name, "use " + shownCameras());
  }
  const PinholeCamera reference = referenceOf(choice.camera);
  const GpcCamera shown(reference, camera.kind->layout(camera));
  ViewedScene scene(choice.camera.scene, context);
  const ReferenceImages images =
      buildReferenceImages(camera, reference, scene.meshFor(camera, reference), context.progress());
  requireFigureFile(choice.output);
  writeFigure(choice.output, rateFigure(shown, images.front().color,
                                        {.title = choice.camera.camera + " in " + choice.camera.scene.source,
                                         .imagePixels = choice.pixels}));
  const RateSummary rates = summarizeRates(shown);
  context.note(fmt::format("wrote {}: {} regions, sampling rate from {:.4f} to {:.4f} along the axes, {:.4f} at least",
                           choice.output, shown.map().zones().size(), rates.leastAlongAxes, rates.greatest,
                           rates.leastAnywhere));
}

void show(const ShowChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const bool isRayMap = namesRayMap(choice.camera.camera);
  if (!isRayMap && !namesConstructor(choice.camera.camera)) {
    return showRates(choice, context);
  }
  if (choice.cut && !(std::abs(*choice.cut) <= 1e6f)) {
    throw InputError("the cut must be a number between -1e6 and 1e6", "--cut", "give one within the scene");
  }
  const GuidedScene scene =
      loadGuidedScene(choice.camera.scene.source, choice.camera.scene.options, context.progress());
  const PlanOptions options{
      .side = sideFromText(choice.from), .cut = choice.cut, .rays = choice.rays, .groundPixels = choice.pixels};
  const CameraPlan plan = isRayMap ? planOf(rayMapCameraOf(choice.camera), scene.mesh, options)
                                   : planOf(construct(choice.camera, scene), scene.mesh, options);
  writePlan(choice.output, plan,
            {.title = choice.camera.camera + " in " + choice.camera.scene.source, .planPixels = choice.pixels});
  context.note(
      fmt::format("wrote {}: {} parts of the camera, {} rays", choice.output, plan.parts.size(), plan.rays.size()));
}

void addShow(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand(
      "show",
      "Draw a plan of a camera: its frusta and rays in the scene; or where gpc has more samples and where less");
  const auto choice = std::make_shared<ShowChoice>();
  addSceneOptions(command, choice->camera.scene, context);
  addAnyCameraOption(command, choice->camera.camera);
  command.get_option("--camera")->required();
  addViewOption(command, choice->camera.view);
  addCameraSizeOption(command, choice->camera.size, kCameraImageSize);
  command.add_option("--from", choice->from, "The side that the plan shows the scene from")
      ->check(CLI::IsMember({"top", "front", "right"}))
      ->capture_default_str();
  command.add_option("--cut", choice->cut,
                     "Where the scene is cut open, along the direction of --from; at the eye where not given");
  command.add_option("--rays", choice->rays, "How many rays, from the left of the image to its right")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command.add_option("--pixels", choice->pixels, "Longer side of the plan, or of the image")
      ->check(CLI::Range(100, 8192))
      ->capture_default_str();
  addOutputOption(command, choice->output, "Where the plan goes", {".svg", ".png"});
  context.finish(command,
                 "  ocelli camera show builtin:maze --camera comprehensive -o plan.svg\n"
                 "  ocelli camera show builtin:town --camera town.json --from front -o plan.png\n"
                 "  ocelli camera show builtin:statues --camera gpc -o rates.png",
                 [choice, context] { show(*choice, context); });
}

struct InfoChoice {
  CameraInScene camera;
  bool json = false;
  std::string output;
};

nlohmann::ordered_json infoOf(const GraphCamera& camera, const Mesh& mesh) {
  nlohmann::ordered_json frusta = nlohmann::ordered_json::array();
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    frusta.push_back({{"name", frustum.name},
                      {"parent", frustum.parent < 0 ? "" : camera.frusta()[static_cast<size_t>(frustum.parent)].name},
                      {"children", frustum.children.size()},
                      {"limits", frustum.limits.size()}});
  }
  const Box world = boundsOf(mesh);
  nlohmann::ordered_json overlaps = nlohmann::ordered_json::array();
  for (const FrustumOverlap& each : overlapsOf(camera, glm::dvec3(world.lower), glm::dvec3(world.upper))) {
    overlaps.push_back({camera.frusta()[static_cast<size_t>(each.first)].name,
                        camera.frusta()[static_cast<size_t>(each.second)].name});
  }
  return {{"camera", "graph"}, {"frusta", frusta}, {"overlaps", overlaps}};
}

nlohmann::ordered_json infoOf(const CurvedRayCamera& camera, const Mesh&) {
  return {{"camera", "curved"}, {"turns", camera.bends().size()}};
}

std::string textOf(const nlohmann::ordered_json& info) {
  if (info["camera"] == "curved") {
    return fmt::format("curved ray camera of {} turns\n", info["turns"].get<size_t>());
  }
  std::string text = fmt::format("graph camera of {} frusta\n", info["frusta"].size());
  for (const auto& frustum : info["frusta"]) {
    const auto parent = frustum["parent"].get<std::string>();
    text += fmt::format("  {}{}\n", frustum["name"].get<std::string>(), parent.empty() ? "" : ", of " + parent);
  }
  for (const auto& overlap : info["overlaps"]) {
    text += fmt::format("overlap within the scene: {} and {}\n", overlap[0].get<std::string>(),
                        overlap[1].get<std::string>());
  }
  return text + (info["overlaps"].empty() ? "no frusta overlap within the scene\n" : "");
}

void info(const InfoChoice& choice, const CommandContext& context) {
  checkSecondOutput(choice.output, "-o", "");
  const bool namesRays = namesRayMap(choice.camera.scene.source);
  if (namesRays || namesRayMap(choice.camera.camera)) {
    if (!choice.output.empty()) {
      throw InputError("a ray map is no list of operations or turns", "-o", "leave it out");
    }
    return printRayMapInfo(namesRays ? choice.camera.scene.source : choice.camera.camera, choice.json, context);
  }
  if (choice.camera.camera.empty()) {
    throw InputError("no camera is given", "--camera", "give one of `ocelli camera list`, or name a ray map, RAYS.exr");
  }
  const GuidedScene scene =
      loadGuidedScene(choice.camera.scene.source, choice.camera.scene.options, context.progress());
  const MultiperspectiveCamera camera = construct(choice.camera, scene);
  const nlohmann::ordered_json described =
      std::visit([&](const auto& each) { return infoOf(each, scene.mesh); }, camera);
  context.print(choice.json ? textOfJson(described, 1) + "\n" : textOf(described));
  if (!choice.output.empty()) {
    writeFile(choice.output, std::visit([](const auto& each) { return jsonText(each); }, camera));
    context.note("wrote " + choice.output);
  }
}

void addCameraInfo(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand("info", "Tell what a camera consists of, and write it out by hand");
  const auto choice = std::make_shared<InfoChoice>();
  addCameraInScene(command, choice->camera, context);
  command.get_option("--camera")->required(false);  // a ray map stands where the scene does
  command.add_flag("--json", choice->json, "Print it as JSON");
  addSecondOutputOption(command, "-o,--output", choice->output,
                        "Where the camera goes as a list of operations or turns, which `--camera` takes", {".json"});
  context.finish(
      command,
      "  ocelli camera info builtin:maze --camera comprehensive -o frusta.json\n  ocelli camera info rays.exr --json",
      [choice, context] { info(*choice, context); });
}

struct EditChoice {
  CameraInScene camera;
  std::string edits = "-";
  std::string image;
  std::string output;
};

/// One edit a line. From a file, an edit that fails ends the work; a program that sends edits gets an answer to each.
void edit(const EditChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  checkSecondOutput(choice.image, "--image", choice.output);
  if (namesRayMap(choice.camera.camera)) {
    throw InputError("a ray map is no list of operations or turns, so there is nothing to edit",
                     "--camera " + choice.camera.camera,
                     "give a constructor, or the JSON file of a graph or curved ray camera; `ocelli camera info` tells "
                     "what a ray map holds");
  }
  const bool fromInput = choice.edits == "-";
  std::istringstream file(fromInput ? "" : readFile(choice.edits));
  std::istream& lines = fromInput ? std::cin : file;
  const GuidedScene scene =
      loadGuidedScene(choice.camera.scene.source, choice.camera.scene.options, context.progress());
  const std::string text = editableText(choice.camera.camera, construct(choice.camera, scene));
  CameraEditor editor(text, choice.camera.camera, referenceOf(choice.camera), boundsOf(scene.mesh));
  const auto show = [&] {
    if (!choice.image.empty()) {
      writePng(choice.image,
               srgbFromLinear(colorImage(rasterize(editor.camera(), scene.mesh), scene.mesh, skyColor())));
    }
  };
  show();
  size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    try {
      editor.apply(line, fmt::format("{}, line {}", fromInput ? "standard input" : choice.edits, number));
    } catch (const InputError& error) {
      if (!fromInput) {
        throw;
      }
      context.print(textOfJson({{"line", number}, {"error", error.what()}}) + "\n");
      continue;
    }
    show();
    if (fromInput) {
      context.print(nlohmann::json{{"line", number}, {"done", true}}.dump() + "\n");
      flushStandardOutput();
    }
  }
  writeFile(choice.output, editor.text());
  context.note(fmt::format("wrote {} after {} lines of edits", choice.output, number));
}

void addEdit(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand("edit", "Change a camera step by step, and draw it after each step");
  const auto choice = std::make_shared<EditChoice>();
  addCameraInScene(command, choice->camera, context);
  command
      .add_option("--edits", choice->edits,
                  "Edits, a JSON object a line: add, remove, change, rename, view, limits, overlap, several, undo, "
                  "redo (docs/graph_cameras.md); - "
                  "reads them from standard input and answers each with a line of JSON")
      ->type_name("FILE|-")
      ->capture_default_str();
  addSecondOutputOption(command, "--image", choice->image, "Where the camera's image goes, anew after each edit",
                        {".png"});
  addOutputOption(command, choice->output, "Where the camera goes in the end", {".json"});
  context.finish(command,
                 "  ocelli camera edit builtin:town --camera portal --edits edits.jsonl -o town.json --image town.png",
                 [choice, context] { edit(*choice, context); });
}

}  // namespace

void addCameraCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& camera = *program.add_subcommand(
      "camera", "List cameras and their options; show, compare, describe, edit and draw them, and write their rays");
  camera.require_subcommand(1);
  addCameraList(camera, context);
  addShow(camera, context);
  addCameraInfo(camera, context);
  addEdit(camera, context);
  addCameraDraw(camera, context);
  addCameraRays(camera, context);
  addCameraOsl(camera, context);
  addCameraCompare(camera, context);
}

}  // namespace ocelli
