#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cli/command.h"
#include "cli/depth_views_option.h"
#include "cli/gl_drawing.h"
#include "cli/ocri_views_command.h"
#include "cli/output_option.h"
#include "cli/scene_notes.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "cli/viewers_option.h"
#include "cli/volume_options.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_file.h"
#include "oc_core/compositing/shared_renderer.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/ocri/viewers.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/volume_ocri/volume_first_hits.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

constexpr ImageSize kBuildSize{720, 480};

struct BuildChoice {
  SceneChoice scene;
  std::string from;
  VolumeChoice volume;
  std::optional<double> opacity;
  std::string camera = "ddoc";
  ViewersChoice viewers;
  std::string size;
  std::string construction = "auto";
  std::string gl = "auto";
  std::string compositing = "direct";
  std::string output;
  std::string json;
};

size_t samplesOf(const ReferenceImages& images) {
  return std::accumulate(images.begin(), images.end(), size_t{0},
                         [](size_t sum, const ReferenceImage& image) { return sum + image.sampleCount(); });
}

/// "ddoc of 720x480, 90000 samples", of a union "corners-8, 8 images of 720x480, 200000 samples".
std::string describe(const ReferenceImages& images) {
  const ReferenceImage& first = images.front();
  const bool sameSize = std::ranges::all_of(images, [&](const ReferenceImage& image) {
    return image.width() == first.width() && image.height() == first.height();
  });
  const std::string count = images.size() == 1 ? "" : fmt::format(", {} images", images.size());
  const std::string size = sameSize ? fmt::format(" of {}x{}", first.width(), first.height()) : " of several sizes";
  return fmt::format("{}{}{}, {} samples", first.camera, count, size, samplesOf(images));
}

Json figuresOf(const ReferenceImages& images) {
  Json rows = Json::array();
  for (const ReferenceImage& image : images) {
    rows.push_back({{"camera", image.camera},
                    {"width", image.width()},
                    {"height", image.height()},
                    {"layer", image.layer},
                    {"samples", image.sampleCount()}});
  }
  return rows;
}

void give(const BuildChoice& choice, const ReferenceImages& images, const CommandContext& context) {
  writeReferenceImages(choice.output, images);
  context.note("wrote " + choice.output + ": " + describe(images));
  const Json figures{{choice.from.empty() ? "scene" : "from", choice.from.empty() ? choice.scene.source : choice.from},
                     {"camera", choice.camera},
                     {"samples", samplesOf(images)},
                     {"images", figuresOf(images)}};
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", "", context);
}

/// Of more than one rank: what they draw together. Nothing otherwise.
std::unique_ptr<SharedRenderer> sharedRenderer(const BuildChoice& choice, const Mesh& mesh,
                                               const CommandContext& context) {
  if (context.ranks().size() == 1) {
    return nullptr;
  }
  if (choice.construction == "rays" || choice.construction == "gl") {
    throw InputError("ranks draw together by rasterisation alone", "--construction " + choice.construction,
                     "use auto or raster, or run it without mpirun");
  }
  return std::make_unique<SharedRenderer>(mesh, context.ranks(),
                                          compositingFromText(choice.compositing, "--compositing"));
}

std::string describe(const SharedRenderer& shared, const CommandContext& context) {
  const SharedDrawing& cost = shared.cost();
  return fmt::format(
      "drawn by {} ranks: {} images composited; rank 0 drew for {:.1f} ms, waited {:.1f} ms, composited {:.1f} ms and "
      "sent {:.2f} MB",
      context.ranks().size(), cost.images, 1000 * cost.drawSeconds, 1000 * cost.waitSeconds, 1000 * cost.mergeSeconds,
      static_cast<double>(context.ranks().bytesSent()) / 1e6);
}

/// Of a graph or curved ray camera, made for a scene that one walks through.
ReferenceImage constructedImage(const BuildChoice& choice, const View& view, const ImageSize& size,
                                const CommandContext& context) {
  if (choice.construction == "gl") {
    throw InputError("graph and curved ray cameras are constructed by rasterisation or by rays", "--construction gl",
                     "use auto, raster or rays");
  }
  const GuidedScene scene = loadGuidedScene(choice.scene.source, choice.scene.options, context.progress());
  noteBlackScene(context, scene.mesh);
  const PinholeCamera reference(view, size.width, size.height);
  const MultiperspectiveCamera camera = constructCamera(choice.camera, scene, reference);
  const bool byRays = constructionFromText(choice.construction, "--construction") == Construction::kRays;
  const std::unique_ptr<SharedRenderer> shared = sharedRenderer(choice, scene.mesh, context);
  const FragmentImage fragments = std::visit(
      [&](const auto& each) {
        return shared != nullptr ? shared->draw(each)
               : byRays          ? raycast(each, scene.mesh)
                                 : rasterize(each, scene.mesh);
      },
      camera);
  if (shared != nullptr) {
    shared->finish();
    context.note(describe(*shared, context));
  }
  const ReferenceImage image = std::visit(
      [&](const auto& each) { return placedImage(each, fragments, scene.mesh, view, choice.camera); }, camera);
  if (image.sampleCount() == 0) {
    failSeeingNothing(reference, scene.mesh, "--camera " + choice.camera);
  }
  context.note(byRays ? "constructed by rays" : "constructed by rasterisation");
  return image;
}

/// What no renderer draws but along its rays, or as layers.
bool drawnInOneRank(const CameraChoice& camera) {
  return camera.kind->castsRays || *camera.kind->needsCpu != 0;
}

/// Of every other camera, for each viewer: of a scene, or of the views of a folder.
ReferenceImages builtImages(const BuildChoice& choice, const std::vector<View>& views, const ImageSize& size,
                            const CommandContext& context) {
  const bool onGpu = choice.construction == "gl";
  const Construction construction = constructionFromText(onGpu ? "auto" : choice.construction, "--construction");
  const CameraChoice camera = cameraChoice(choice.camera);
  const auto gl = onGpu ? std::make_unique<GlDrawing>(choice.gl) : nullptr;
  if (context.ranks().size() > 1 && drawnInOneRank(camera)) {
    context.note("camera \"" + camera.name + "\" is not divided among ranks: the first one draws it");
    if (!context.ranks().isFirst()) {
      return {};
    }
  }
  ViewedScene scene =
      choice.from.empty() ? ViewedScene(choice.scene, context) : ViewedScene(surfaceFrom(choice.from, context));
  ConstructionReport report;
  std::vector<ReferenceImages> viewers;
  for (const View& view : views) {
    const PinholeCamera reference(view, size.width, size.height);
    const Mesh& mesh = scene.meshFor(camera, reference);
    const std::unique_ptr<SharedRenderer> shared =
        drawnInOneRank(camera) ? nullptr : sharedRenderer(choice, mesh, context);
    if (shared != nullptr) {
      viewers.push_back(buildReferenceImages(camera, reference, mesh, context.progress(), *shared));
      shared->finish();
      context.note(describe(*shared, context));
    } else {
      viewers.push_back(
          gl != nullptr
              ? buildReferenceImages(camera, reference, mesh, context.progress(), gl->rendererOf(mesh))
              : buildReferenceImages(camera, reference, mesh, context.progress(), construction, nullptr, &report));
    }
  }
  context.note("constructed " + (gl != nullptr ? "with " + gl->description() : describe(report)));
  return mergeViewers(std::move(viewers)).images;
}

/// Of a volume, whose surface is what rays hit first.
ReferenceImages imagesOfVolume(const BuildChoice& choice, const std::vector<View>& views, const ImageSize& size,
                               const CommandContext& context) {
  if (choice.construction == "raster" || choice.construction == "gl") {
    throw InputError("reference images of volumes are constructed by rays", "--construction " + choice.construction,
                     "use auto or rays, or take the mesh of a surface with --iso VALUE");
  }
  if (namesConstructor(choice.camera)) {
    throw InputError(
        "graph and curved ray cameras build no reference images of volumes", "--camera " + choice.camera,
        "draw the volume along their rays with ocelli render, or take the mesh of a surface with --iso VALUE");
  }
  const CameraChoice camera = cameraChoice(choice.camera);
  if (context.ranks().size() > 1) {
    context.note("volumes are not divided among ranks: the first one draws");
    if (!context.ranks().isFirst()) {
      return {};
    }
  }
  const VolumeFirstHits volume(loadVolume(choice.scene, choice.volume, context),
                               {.depthOpacity = choice.opacity.value_or(VolumeRenderOptions{}.depthOpacity)});
  std::vector<ReferenceImages> viewers;
  for (const View& view : views) {
    viewers.push_back(buildReferenceImages(camera, PinholeCamera(view, size.width, size.height), volume.renderer(),
                                           context.progress()));
  }
  context.note("constructed by rays: " + volume.description());
  return mergeViewers(std::move(viewers)).images;
}

void addBuild(CLI::App& ocri, const CommandContext& context) {
  CLI::App& command = *ocri.add_subcommand("build", "Build the reference image of a scene");
  const auto choice = std::make_shared<BuildChoice>();
  addSceneOptions(command, choice->scene, context);
  command.get_option("SCENE")->required(false);
  addFromOption(
      command, choice->from,
      "Build it of the views with depth in this folder, in place of a SCENE: EXR files of depth images, or PNG "
      "files that views.json lists");
  addVolumeOptions(command, choice->volume);
  addOpacityOption(command, choice->opacity);
  addMotionOptions(command, choice->scene);
  addAnyCameraOption(command, choice->camera);
  addViewersOptions(command, choice->viewers);
  addCameraSizeOption(command, choice->size, kBuildSize);
  command
      .add_option("--construction", choice->construction,
                  "By rasterisation or by rays; rays build an acceleration structure (BVH) first, which takes longer "
                  "than rasterising one image of any scene, but for large ones with cell: auto rasterises. gl draws on "
                  "the GPU with OpenGL")
      ->check(CLI::IsMember({"auto", "raster", "rays", "gl"}))
      ->type_name("NAME")
      ->capture_default_str();
  addGlOption(command, choice->gl);
  command
      .add_option("--compositing", choice->compositing,
                  "How ranks of an MPI job bring their images together: direct sends each part to the rank that owns "
                  "it, swap halves parts between pairs of ranks. The image is the same")
      ->check(CLI::IsMember({"direct", "swap"}))
      ->type_name("direct|swap")
      ->capture_default_str();
  addOutputOption(command, choice->output, "Where the image goes", {".exr"});
  addFiguresOption(command, choice->json);
  context.finishShared(
      command,
      "  ocelli ocri build builtin:statues -o statues.exr\n"
      "  ocelli ocri build bunny.obj --camera di --size 180x120 -o bunny.exr\n"
      "  ocelli ocri build builtin:statues --viewers 4 -o around.exr\n"
      "  ocelli ocri build --from views --camera ldi-2 -o views.exr\n"
      "  ocelli ocri build builtin:volume,name=skull --camera ldi-3 --opacity 0.5 -o skull.exr\n"
      "  ocelli ocri build builtin:town --camera panorama --size 1440x720 --view street.json -o town.exr\n"
      "  ocelli ocri build builtin:maze --camera comprehensive --size 1920x1200 -o maze.exr",
      [choice, context, &command] {
        requireSceneOrViews(command, choice->scene.source, choice->from);
        const bool writes = context.ranks().isFirst();
        if (writes) {
          checkWritable(choice->output);
          checkFiguresOutput(choice->json, choice->output);
        }
        requireGlUsed(choice->gl, choice->construction == "gl", "--construction gl");
        const ImageSize size = cameraImageSize(choice->camera, choice->size, kBuildSize);
        const std::vector<View> views = viewsFor(choice->camera, choice->viewers);
        if (choice->from.empty() && takesVolume(choice->scene)) {
          const ReferenceImages images = imagesOfVolume(*choice, views, size, context);
          if (writes) {
            give(*choice, images, context);
          }
          return;
        }
        refuseVolumeOptions(choice->volume);
        refuseVolumeOption(choice->opacity.has_value(), "--opacity");
        const bool constructed = namesConstructor(choice->camera);
        if (constructed && !choice->from.empty()) {
          throw InputError("graph and curved ray cameras are made for a scene that one walks through",
                           "--camera " + choice->camera, "give a SCENE, or choose another camera");
        }
        if (constructed && views.size() != 1) {
          throw InputError("graph and curved ray cameras are made for one viewer", "--viewers",
                           "leave it out, or choose another camera");
        }
        const ReferenceImages images = constructed
                                           ? ReferenceImages{constructedImage(*choice, views.front(), size, context)}
                                           : builtImages(*choice, views, size, context);
        if (writes) {
          give(*choice, images, context);
        }
      });
}

void addMesh(CLI::App& ocri, const CommandContext& context) {
  CLI::App& command = *ocri.add_subcommand("mesh", "Turn a reference image into its bounded triangle mesh");
  struct Choice {
    std::string input;
    std::string output;
    std::string json;
  };
  const auto choice = std::make_shared<Choice>();
  command.add_option("IMAGE", choice->input, "A reference image (.exr)")->required();
  addOutputOption(command, choice->output, "Where the mesh goes", {".ply"});
  addFiguresOption(command, choice->json);
  context.finish(command, "  ocelli ocri mesh statues.exr -o statues.ply", [choice, context] {
    checkFiguresOutput(choice->json, choice->output);
    const ReferenceImages images = readReferenceImages(choice->input);
    const Mesh mesh = unionMesh(images);
    writePly(choice->output, mesh);
    context.note(fmt::format("wrote {}: {} triangles", choice->output, mesh.triangles.size()));
    const Json figures{{"image", choice->input},
                       {"samples", samplesOf(images)},
                       {"triangles", mesh.triangles.size()},
                       {"vertices", mesh.positions.size()}};
    giveFigures(choice->json, textOfJson(figures, 2) + "\n", "", context);
  });
}

}  // namespace

void addOcriCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& ocri = *program.add_subcommand("ocri", "Build occlusion camera reference images and their meshes");
  ocri.require_subcommand(1);
  addBuild(ocri, context);
  addMesh(ocri, context);
  addOcriViews(ocri, context);
}

}  // namespace ocelli
