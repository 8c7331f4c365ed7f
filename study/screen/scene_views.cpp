#include "study/screen/scene_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/image/color.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/rasterize.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

/// The triangles of one object, where its landmark stands.
Mesh meshOf(const StudyScene& scene, size_t object) {
  const VertexRange range = scene.verticesOf(object);
  const auto from = static_cast<std::ptrdiff_t>(range.first);
  const auto to = static_cast<std::ptrdiff_t>(range.first + range.count);
  const Mesh& all = scene.mesh();
  Mesh mesh;
  mesh.positions.assign(all.positions.begin() + from, all.positions.begin() + to);
  if (!all.colors.empty()) {
    mesh.colors.assign(all.colors.begin() + from, all.colors.begin() + to);
  }
  for (size_t i = 0; i < all.triangles.size(); ++i) {
    if (scene.objectOfTriangle()[i] == object + 1) {
      mesh.triangles.push_back(all.triangles[i] - static_cast<uint32_t>(range.first));
    }
  }
  return mesh;
}

/// From in front, a little from above, with room around it.
PinholeCamera portraitCamera(const Box& box, int pixels) {
  constexpr double kFovDegrees = 30;
  const glm::vec3 middle = (box.lower + box.upper) / 2.0f;
  const float radius = glm::length(box.upper - box.lower) / 2;
  const float distance = radius / static_cast<float>(std::sin(radiansFromDegrees(kFovDegrees / 2)));
  View view;
  view.target = middle;
  view.eye = middle + distance * glm::normalize(glm::vec3(0.35f, 0.45f, 1));
  view.fovVerticalDegrees = kFovDegrees;
  view.zNear = distance / 100;
  view.zFar = distance * 10;
  return {view, pixels, pixels};
}

using Rgba8 = std::array<uint8_t, 4>;

/// The mean of `factor` x `factor` fragments a pixel.
Image<Rgba8> smoothed(const FragmentImage& fragments, const Mesh& mesh, int factor) {
  Image<Rgba8> image(fragments.width() / factor, fragments.height() / factor);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      glm::vec3 light(0);
      int covered = 0;
      for (int i = 0; i < factor * factor; ++i) {
        const Fragment& fragment = fragments(factor * x + i % factor, factor * y + i / factor);
        if (fragment.covered()) {
          light += colorOf(fragment, mesh);
          ++covered;
        }
      }
      light /= static_cast<float>(std::max(covered, 1));
      image(x, y) = {srgbByteFromLinear(light.x), srgbByteFromLinear(light.y), srgbByteFromLinear(light.z),
                     static_cast<uint8_t>(255 * covered / (factor * factor))};
    }
  }
  return image;
}

}  // namespace

void SceneViews::prepare(const StudyScene& scene) {
  // Compared by value: another scene may stand where the one before stood.
  const Mesh& mesh = scene.mesh();
  if (renderer_ && mesh.positions == base_.positions && mesh.triangles == base_.triangles &&
      mesh.colors == base_.colors) {
    return;
  }
  if (renderer_) {
    renderer_->setMesh(mesh);
  } else {
    renderer_ = std::make_unique<GlRenderer>(*context_, mesh);
  }
  base_ = mesh;
  moved_ = mesh;
  offsets_.assign(scene.objectCount(), glm::vec3(0));
}

void SceneViews::move(const StudyScene& scene, std::span<const glm::vec3> offsets) {
  for (size_t i = 0; i < offsets_.size(); ++i) {
    const glm::vec3 offset = i < offsets.size() ? offsets[i] : glm::vec3(0);
    if (offset == offsets_[i]) {
      continue;
    }
    offsets_[i] = offset;
    const VertexRange range = scene.verticesOf(i);
    for (size_t v = range.first; v < range.first + range.count; ++v) {
      moved_.positions[v] = base_.positions[v] + offset;
    }
    renderer_->moveVertices(moved_, range.first, range.count);
  }
}

GlRenderer& SceneViews::rendererOf(const std::shared_ptr<const ShownContent>& shown) {
  const auto known =
      std::find_if(shown_.begin(), shown_.end(), [&](const ShownRenderer& each) { return each.shown == shown; });
  if (known != shown_.end()) {
    return *known->renderer;
  }
  const Mesh& mesh = std::get<ShownMesh>(*shown).mesh;
  if (shown_.size() < kMaxShown) {
    shown_.push_back({shown, std::make_unique<GlRenderer>(*context_, mesh)});
  } else {
    // The one that came first.
    std::rotate(shown_.begin(), shown_.begin() + 1, shown_.end());
    shown_.back().shown = shown;
    shown_.back().renderer->setMesh(mesh);
  }
  return *shown_.back().renderer;
}

void SceneViews::draw(const TrialLayout& layout, const GlObject& target) {
  if (layout.scene == nullptr || layout.views.empty()) {
    return;
  }
  prepare(*layout.scene);
  move(*layout.scene, layout.objectOffsets);
  const GladGLContext& gl = context_->gl();
  for (const TrialLayout::View& view : layout.views) {
    const std::shared_ptr<const ShownContent> shown = shownIn(layout, view);
    const auto left = static_cast<GLint>(view.place.left);
    const auto top = static_cast<GLint>(view.place.top);
    if (shown && std::holds_alternative<ShownImage>(*shown)) {
      const Image<Rgb8>& pixels = std::get<ShownImage>(*shown).pixels;
      OC_CHECK(pixels.width() == view.place.width && pixels.height() == view.place.height,
               "a view is as large as its place");
      gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
      gl.TextureSubImage2D(target.id(), 0, left, top, pixels.width(), pixels.height(), GL_RGB, GL_UNSIGNED_BYTE,
                           pixels.data());
      gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
      continue;
    }
    GlRenderer& renderer = shown ? rendererOf(shown) : *renderer_;
    const GlFragments fragments =
        std::visit([&](const auto& camera) { return renderer.drawOnGpu(camera); }, view.camera);
    OC_CHECK(fragments.width() == view.place.width && fragments.height() == view.place.height,
             "a view is as large as its place");
    const GlObject colors = renderer.encodedColors(fragments, skyColor());
    gl.CopyImageSubData(colors.id(), GL_TEXTURE_2D, 0, 0, 0, 0, target.id(), GL_TEXTURE_2D, 0, left, top, 0,
                        fragments.width(), fragments.height(), 1);
  }
  context_->check("drawing the views of a trial");
}

const GlObject& SceneViews::portraitOf(const StudyScene& scene, int object, int pixels) {
  Mesh mesh = meshOf(scene, static_cast<size_t>(object));
  if (portrait_ && portrait_->pixels == pixels && portrait_->mesh.positions == mesh.positions &&
      portrait_->mesh.colors == mesh.colors) {
    return portrait_->texture;
  }
  constexpr int kSamplesAcross = 4;
  const PinholeCamera camera = portraitCamera(boundsOf(mesh), kSamplesAcross * pixels);
  const Image<Rgba8> image = smoothed(rasterize(camera, mesh), mesh, kSamplesAcross);
  GlObject texture = makeTexture(*context_, GL_RGBA8, pixels, pixels);
  context_->gl().TextureSubImage2D(texture.id(), 0, 0, 0, pixels, pixels, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  portrait_ = Portrait{std::move(mesh), pixels, std::move(texture)};
  return portrait_->texture;
}

}  // namespace ocelli
