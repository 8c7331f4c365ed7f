#include "study/task/trial_image.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"

namespace ocelli {

FragmentImage rasterizeStudy(const StudyCamera& camera, const Mesh& mesh) {
  return std::visit([&](const auto& each) { return rasterize(each, mesh); }, camera);
}

Mesh meshOf(const TrialLayout& layout) {
  OC_CHECK(layout.scene != nullptr, "only images of a scene have a mesh");
  Mesh mesh = layout.scene->mesh();
  layout.scene->moveObjects(mesh, layout.objectOffsets);
  return mesh;
}

std::shared_ptr<const ShownContent> shownIn(const TrialLayout& layout, const TrialLayout::View& view) {
  return view.show ? view.show(layout) : nullptr;
}

std::optional<ViewMesh> viewMesh(const ShownContent* shown, const StudyScene& scene, const Mesh& mesh) {
  if (shown == nullptr) {
    return ViewMesh{&mesh, &scene.objectOfTriangle()};
  }
  const auto* other = std::get_if<ShownMesh>(shown);
  return other != nullptr ? std::optional(ViewMesh{&other->mesh, &other->objectOfTriangle}) : std::nullopt;
}

Image<uint32_t> objectsIn(const TrialLayout& layout, const TrialLayout::View& view, const StudyRenderer& renderer) {
  const Mesh scene = meshOf(layout);
  const std::shared_ptr<const ShownContent> shown = shownIn(layout, view);
  const std::optional<ViewMesh> of = viewMesh(shown.get(), *layout.scene, scene);
  return of ? identityImage(renderer(view.camera, *of->mesh), *of->objectOfTriangle)
            : std::get<ShownImage>(*shown).objects;
}

Image<Rgb8> viewsOf(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer) {
  Image<Rgb8> pixels(screen.width, screen.height, Rgb8(0));
  if (layout.views.empty()) {
    return pixels;
  }
  const Mesh scene = meshOf(layout);
  for (const TrialLayout::View& view : layout.views) {
    const std::shared_ptr<const ShownContent> shown = shownIn(layout, view);
    const std::optional<ViewMesh> of = viewMesh(shown.get(), *layout.scene, scene);
    const Image<Rgb8> image = of ? srgbFromLinear(colorImage(renderer(view.camera, *of->mesh), *of->mesh, skyColor()))
                                 : std::get<ShownImage>(*shown).pixels;
    const int left = static_cast<int>(std::lround(view.place.left));
    const int top = static_cast<int>(std::lround(view.place.top));
    for (int y = std::max(0, -top); y < std::min(image.height(), screen.height - top); ++y) {
      for (int x = std::max(0, -left); x < std::min(image.width(), screen.width - left); ++x) {
        pixels(left + x, top + y) = image(x, y);
      }
    }
  }
  return pixels;
}

uint64_t pixelHashOf(const Image<Rgb8>& image) {
  // FNV-1a over the size and the bytes.
  uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](uint64_t byte) { hash = (hash ^ byte) * 0x100000001b3u; };
  for (const int side : {image.width(), image.height()}) {
    for (int shift = 0; shift < 32; shift += 8) {
      add(static_cast<uint64_t>(side) >> shift & 0xff);
    }
  }
  for (const Rgb8& pixel : image) {
    add(pixel.x);
    add(pixel.y);
    add(pixel.z);
  }
  return hash;
}

}  // namespace ocelli
