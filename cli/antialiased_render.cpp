#include "cli/antialiased_render.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "cli/scene_notes.h"
#include "cli/viewed_scene.h"
#include "oc_core/antialiasing/antialias_option.h"
#include "oc_core/antialiasing/ray_samples.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

/// What reference images show where there is nothing.
constexpr glm::vec3 kBlack(0);

bool isAll(const Image<glm::vec3>& image, const glm::vec3& color) {
  return std::all_of(image.begin(), image.end(), [&](const glm::vec3& each) { return each == color; });
}

/// The image on a background. Throws InputError at `where` where it shows nothing of the mesh: where it is the
/// background alone, whatever that is, so that a surface of the same colour counts as seen.
Image<glm::vec3> drawnOn(const glm::vec3& background, const PinholeCamera& reference, const Mesh& mesh,
                         const std::string& where, const std::function<Image<glm::vec3>(const glm::vec3&)>& draw) {
  Image<glm::vec3> image = draw(background);
  if (isAll(image, background)) {
    const glm::vec3 other = background + 1.0f;
    if (isAll(draw(other), other)) {
      failSeeingNothing(reference, mesh, where);
    }
  }
  return image;
}

/// The view of a camera whose samples are rays of the reference's eye; nothing for others.
std::optional<AntialiasView> viewOf(const CameraChoice& choice, const PinholeCamera& reference) {
  if (choice.kind == findRepresentation("di")->kind) {
    return reference;
  }
  if (choice.kind == findRepresentation("gpc")->kind) {
    return GpcCamera(reference, choice.gpc);
  }
  return std::nullopt;
}

/// `outside` is the rule of pixels outside of them, which regions of no more samples take too.
void noteRegions(const AntialiasChoice& choice, const std::vector<AntialiasRegion>& regions, const PixelRule& outside,
                 const CommandContext& context) {
  if (!choice.method->hasRegions) {
    return;
  }
  if (regions.empty()) {
    context.note(fmt::format("no region has more than {} triangles a pixel: all is drawn with {}", choice.dense,
                             choice.outside->text));
  }
  for (const AntialiasRegion& each : regions) {
    const int samples = each.side * each.side;
    const std::string drawn =
        samples > outside.pattern->size()
            ? fmt::format("{} samples a pixel", samples)
            : fmt::format("{} samples a pixel would do, so drawn with {} as outside", samples, choice.outside->text);
    context.note(fmt::format("region of {}x{} pixels at ({}, {}): {}, {:.2g} triangles a pixel",
                             each.box.x1 - each.box.x0, each.box.y1 - each.box.y0, each.box.x0, each.box.y0, drawn,
                             each.trianglesPerPixel));
  }
}

Image<glm::vec3> rasterized(const AntialiasChoice& choice, const AntialiasView& view, const Mesh& mesh,
                            const std::vector<uint32_t>& objects, const CommandContext& context) {
  requireOutside(mesh, view.reference().eye(), "view");
  const AntialiasScene scene(view, mesh);
  const std::vector<AntialiasRegion> regions = antialiasRegions(choice, scene, objects);
  const AntialiasPlan plan = antialiasPlan(choice, view, regions);
  noteRegions(choice, regions, plan.rules.front(), context);
  AntialiasWork work;
  Image<glm::vec3> image = drawnOn(kBlack, view.reference(), mesh, "view",
                                   [&](const glm::vec3& background) { return scene.draw(plan, background, &work); });
  context.note(fmt::format("{} pixels sampled with {} samples, {} averaged by area, {} plain", work.sampled,
                           work.samples, work.exact, work.plain));
  return image;
}

Image<glm::vec3> castMultiperspective(const AntialiasedRender& render, const SamplePattern& pattern,
                                      const CommandContext& context) {
  const GuidedScene scene = loadGuidedScene(render.scene.source, render.scene.options, context.progress());
  const MultiperspectiveCamera camera = constructCamera(render.camera, scene, render.reference);
  noteBlackScene(context, scene.mesh);
  const RayScene rays(scene.mesh);
  return drawnOn(skyColor(), render.reference, scene.mesh, "--camera " + render.camera,
                 [&](const glm::vec3& background) {
                   return std::visit(
                       [&](const auto& each) {
                         return raySampledImage(
                             each.width(), each.height(), [&](const glm::vec2& pixel) { return each.rayPath(pixel); },
                             rays, pattern, background);
                       },
                       camera);
                 });
}

Image<glm::vec3> castReferenceImage(const AntialiasedRender& render, const CameraChoice& camera, const Mesh& mesh,
                                    const SamplePattern& pattern, const CommandContext& context) {
  const ReferenceImages images = buildReferenceImages(camera, render.reference, mesh, context.progress());
  const std::vector<RayFunction> rays = cameraRays(camera, render.reference, mesh, images, context.progress());
  if (rays.size() != 1) {
    throw InputError("\"" + render.camera + "\" is a union of " + std::to_string(rays.size()) +
                         " images, which one PNG does not hold",
                     "--camera", "choose a camera of one image");
  }
  const RayScene scene(mesh);
  return drawnOn(kBlack, render.reference, mesh, "view", [&](const glm::vec3& background) {
    return raySampledImage(images.front().width(), images.front().height(), rays.front(), scene, pattern, background);
  });
}

}  // namespace

void addAntialiasOption(CLI::App& command, std::string& antialias) {
  command
      .add_option("--antialias", antialias,
                  "How pixels average what they show: a way, and what can be said of it, as in "
                  "extreme,tile=320x360,outside=msaa-16:" +
                      antialiasHelp())
      ->type_name("WAY[,KEY=VALUE...]");
}

void renderAntialiased(const AntialiasedRender& render, const CommandContext& context) {
  const AntialiasChoice choice = antialiasChoice(render.antialias, "--antialias");
  if (!render.output.ends_with(".png")) {
    throw InputError("an average of samples has no depth", "-o " + render.output,
                     "write a .png file, or draw without --antialias");
  }
  if (render.method != "raster" && render.method != "raycast") {
    throw InputError("--method " + render.method + " has no antialiasing", "--antialias", "use raster or raycast");
  }
  Image<glm::vec3> image;
  if (namesConstructor(render.camera)) {
    image = castMultiperspective(render, rayPattern(choice, "--camera " + render.camera), context);
  } else {
    const CameraChoice camera = cameraChoice(render.camera);
    const std::optional<AntialiasView> view = viewOf(camera, render.reference);
    const bool casts = render.method == "raycast" || !view;
    const std::optional<SamplePattern> pattern =
        casts ? std::optional(rayPattern(choice, view ? "--method raycast" : "--camera " + render.camera))
              : std::nullopt;
    if (choice.regions == "objects") {
      const GuidedScene scene = loadGuidedScene(render.scene.source, render.scene.options, context.progress());
      image = rasterized(choice, *view, scene.mesh, scene.objectOfTriangle, context);
    } else {
      ViewedScene scene(render.scene, context);
      const Mesh& mesh = scene.meshFor(camera, render.reference);
      image = casts ? castReferenceImage(render, camera, mesh, *pattern, context)
                    : rasterized(choice, *view, mesh, {}, context);
    }
  }
  writePng(render.output, srgbFromLinear(image));
  context.note(fmt::format("wrote {}: {} of {}x{} with {}", render.output, render.camera, image.width(), image.height(),
                           choice.text));
}

}  // namespace ocelli
