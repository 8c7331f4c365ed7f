#include "cli/camera_rays_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "cli/volume_options.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/camera_rays/camera_rays.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "oc_core/volume_ocri/volume_first_hits.h"

namespace ocelli {
namespace {

constexpr ImageSize kRayMapSize{720, 480};

struct RaysFileChoice {
  RaysChoice rays;
  bool json = false;
  std::string output;
};

void requireSceneOf(const RaysChoice& choice) {
  if (choice.scene.source.empty()) {
    throw InputError("the rays of camera \"" + choice.camera + "\" depend on the scene", "--scene",
                     "give --scene SCENE, or choose a camera that is made from the view alone, such as di or panorama");
  }
}

/// Of a camera that looks at a volume.
RayMap volumeRays(const RaysChoice& choice, const PinholeCamera& reference, const CommandContext& context) {
  refuseImageNumber(choice);
  const VolumeFirstHits volume(loadVolume(choice.scene, {}, context));
  return rayMapOf(volumeCamera(
                      choice.camera, reference, volume.scene(), [&]() -> const RayTarget& { return volume.target(); },
                      context.progress()),
                  reference.view(), context.progress());
}

nlohmann::ordered_json arrayOf(const glm::vec3& p) {
  return {p.x, p.y, p.z};
}

nlohmann::ordered_json rayMapInfo(const RayMap& map) {
  const RayMapFacts facts = factsOf(map);
  const RayMapNotes& notes = map.notes();
  nlohmann::ordered_json info{{"camera", "rays"},
                              {"name", notes.name},
                              {"width", map.width()},
                              {"height", map.height()},
                              {"rays", facts.rays},
                              {"bent", facts.bent},
                              {"segments", facts.segments},
                              {"frame", nameOf(notes.frame)},
                              {"origins", {{"lower", arrayOf(facts.lower)}, {"upper", arrayOf(facts.upper)}}},
                              {"t", {facts.tMin, facts.tMax}},
                              {"wraps_around", notes.wrapsAround}};
  if (notes.view) {
    info["view"] = nlohmann::ordered_json::parse(jsonText(*notes.view));
  }
  return info;
}

std::string rayMapText(const RayMap& map) {
  const RayMapFacts facts = factsOf(map);
  const auto point = [](const glm::vec3& p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); };
  std::string text = fmt::format("ray map \"{}\" of {}x{} pixels\n", map.notes().name, map.width(), map.height());
  text += fmt::format("  {} rays, {} pixels without one\n", facts.rays,
                      static_cast<size_t>(map.width()) * static_cast<size_t>(map.height()) - facts.rays);
  text += facts.bent == 0 ? std::string("  all of them straight\n")
                          : fmt::format("  {} of them bent, of {} segments at most\n", facts.bent, facts.segments);
  text += fmt::format("  they begin between {} and {}\n", point(facts.lower), point(facts.upper));
  text += fmt::format("  t runs from {:g} to {:g}\n", facts.tMin, facts.tMax);
  text += map.notes().frame == RayFrame::kWorld ? "  in the world of the scene\n"
                                                : "  in the coordinates of the view that it is placed at\n";
  return text + (map.notes().wrapsAround ? "  the last column is next to the first\n" : "");
}

void writeRays(const RaysFileChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const RayMap map = raysOf(choice.rays, raysReference(choice.rays), context);
  writeRayMap(choice.output, map, context.progress());
  if (choice.json) {
    context.print(textOfJson(rayMapInfo(map), 1) + "\n");
  }
  context.note(fmt::format("wrote {}: {} rays of {}x{} pixels, of {} segments at most", choice.output, map.rayCount(),
                           map.width(), map.height(), map.maxSegments()));
}

}  // namespace

void refuseImageNumber(const RaysChoice& choice) {
  if (choice.image != 0) {
    throw InputError("camera \"" + choice.camera + "\" has one image", "--image", "leave it out");
  }
}

RayMap raysOf(const RaysChoice& choice, const PinholeCamera& reference, const CommandContext& context) {
  if (!choice.scene.source.empty() && takesVolume(choice.scene)) {
    return volumeRays(choice, reference, context);
  }
  if (namesConstructor(choice.camera)) {
    refuseImageNumber(choice);
    requireSceneOf(choice);
    const GuidedScene scene = loadGuidedScene(choice.scene.source, choice.scene.options, context.progress());
    return rayMapOf(constructCamera(choice.camera, scene, reference), choice.camera, reference.view(),
                    context.progress());
  }
  const CameraChoice camera = cameraChoice(choice.camera);
  if (!needsScene(camera)) {
    return rayMapOf(camera, reference, Mesh{}, choice.image, context.progress());
  }
  requireSceneOf(choice);
  ViewedScene scene(choice.scene, context);
  return rayMapOf(camera, reference, scene.meshFor(camera, reference), choice.image, context.progress());
}

PinholeCamera raysReference(const RaysChoice& choice) {
  const ImageSize size = cameraImageSize(choice.camera, choice.size, kRayMapSize);
  return {cameraView(choice.camera, choice.view), size.width, size.height};
}

void addRaysOptions(CLI::App& command, RaysChoice& choice, const CommandContext& context) {
  command.add_option("CAMERA", choice.camera, "A camera, a constructor, or a file of one (`ocelli camera list`)")
      ->type_name("NAME|FILE.json|RAYS.exr")
      ->required();
  addSceneOption(command, choice.scene, context);
  addViewOption(command, choice.view);
  addCameraSizeOption(command, choice.size, kRayMapSize);
  command.add_option("--image", choice.image, "Of a camera of several images, such as a union: which one, from 1 on")
      ->check(CLI::Range(1, 1024))
      ->type_name("NUMBER");
}

void printRayMapInfo(const std::string& file, bool json, const CommandContext& context) {
  const RayMap map = readRayMap(file);
  context.print(json ? textOfJson(rayMapInfo(map), 1) + "\n" : rayMapText(map));
}

void addCameraRays(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand(
      "rays", "Write the ray of each pixel of a camera to a file, for other programs and for --camera");
  const auto choice = std::make_shared<RaysFileChoice>();
  addRaysOptions(command, choice->rays, context);
  command.add_flag("--json", choice->json, "Print what the map consists of as JSON");
  addOutputOption(command, choice->output, "Where the rays go (docs/ray_maps.md)", {".exr"});
  context.finish(command,
                 "  ocelli camera rays panorama --view street.json --size 1440x720 -o panorama.exr\n"
                 "  ocelli camera rays ddoc --scene builtin:statues -o ddoc.exr\n"
                 "  ocelli render builtin:statues --camera ddoc.exr -o statues.png",
                 [choice, context] { writeRays(*choice, context); });
}

}  // namespace ocelli
