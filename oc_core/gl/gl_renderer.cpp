#include "oc_core/gl/gl_renderer.h"

#include "oc_core/gl/bent_ray_pass.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_pass.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl/span_pass.h"
#include "oc_core/gl/subdivision_pass.h"
#include "oc_core/render/rasterize_gpc.h"

namespace ocelli {

struct GlRenderer::Impl {
  Impl(GlContext& context, const Mesh& scene)
      : mesh(context, scene),
        blocks(scene),
        pinhole(context),
        subdivision(context),
        spans(context),
        bentRays(context),
        color(makeProgram(context, "color_resolve",
                          {{GL_COMPUTE_SHADER, {shaders::kMesh, shaders::kFragment, shaders::kColorResolveComp}}})),
        encodedColor(makeProgram(
            context, "color_resolve",
            {{GL_COMPUTE_SHADER, {shaders::kMesh, shaders::kFragment, shaders::kEncode, shaders::kColorResolveComp}}},
            "#define ENCODED\n")) {}

  GlMesh mesh;
  MeshBlocks blocks;
  PinholePass pinhole;
  SubdivisionPass subdivision;
  SpanPass spans;
  BentRayPass bentRays;
  GlObject color;
  GlObject encodedColor;
};

GlRenderer::GlRenderer(GlContext& context, const Mesh& mesh) : context_(context) {
  const GlScope scope(context);
  impl_ = std::make_unique<Impl>(context, mesh);
}

GlRenderer::~GlRenderer() = default;

const GlMesh& GlRenderer::mesh() const {
  return impl_->mesh;
}

void GlRenderer::setMesh(const Mesh& mesh) {
  const GlScope scope(context_);
  impl_->mesh = GlMesh(context_, mesh);
  impl_->blocks = MeshBlocks(mesh);
}

void GlRenderer::moveVertices(const Mesh& moved, size_t first, size_t count) {
  const GlScope scope(context_);
  impl_->mesh.move(first, std::span(moved.positions).subspan(first, count));
  impl_->blocks.update(moved, first, count);
}

FragmentImage GlRenderer::draw(const PinholeCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

FragmentImage GlRenderer::draw(const SpocCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

FragmentImage GlRenderer::draw(const ReversePinholeCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

FragmentImage GlRenderer::draw(const GpcCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

FragmentImage GlRenderer::draw(const DdocCamera& camera, const FragmentImage& seen,
                               const SubdivisionOptions& subdivision) const {
  const GlScope scope(context_);
  return impl_->subdivision.draw(camera, GlFragments(context_, seen), impl_->mesh, subdivision).read();
}

FragmentImage GlRenderer::drawLines(const PinholeCamera& base, const EpipolarLines& lines) const {
  const GlScope scope(context_);
  return drawLinesOnGpu(base, lines).read();
}

FragmentImage GlRenderer::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  const GlScope scope(context_);
  return impl_->spans.draw(camera, GlFragments(context_, baseImage), impl_->mesh).read();
}

FragmentImage GlRenderer::draw(const GraphCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

FragmentImage GlRenderer::draw(const CurvedRayCamera& camera) const {
  const GlScope scope(context_);
  return drawOnGpu(camera).read();
}

GlFragments GlRenderer::drawOnGpu(const PinholeCamera& camera) const {
  return impl_->pinhole.draw(camera, impl_->mesh);
}

GlFragments GlRenderer::drawOnGpu(const SpocCamera& camera, const SubdivisionOptions& options) const {
  return impl_->subdivision.draw(camera, drawOnGpu(camera.reference()), impl_->mesh, options);
}

GlFragments GlRenderer::drawOnGpu(const ReversePinholeCamera& camera, const SubdivisionOptions& options) const {
  return impl_->subdivision.draw(camera, drawOnGpu(camera.reference()), impl_->mesh, options);
}

GlFragments GlRenderer::drawOnGpu(const GpcCamera& camera) const {
  return impl_->subdivision.draw(camera, drawOnGpu(camera.reference()), impl_->mesh, gpcSubdivision(camera));
}

GlFragments GlRenderer::drawOnGpu(const DdocCamera& camera, const SubdivisionOptions& options) const {
  return impl_->subdivision.draw(camera, drawOnGpu(camera.reference()), impl_->mesh, options);
}

GlFragments GlRenderer::drawOnGpu(const EpipolarCamera& camera) const {
  return impl_->spans.draw(camera, drawLinesOnGpu(camera.base(), camera.lines()), impl_->mesh);
}

GlFragments GlRenderer::drawOnGpu(const GraphCamera& camera) const {
  return impl_->bentRays.draw(camera, impl_->mesh, impl_->blocks);
}

GlFragments GlRenderer::drawOnGpu(const CurvedRayCamera& camera) const {
  return impl_->bentRays.draw(camera, impl_->mesh, impl_->blocks);
}

GlFragments GlRenderer::drawLinesOnGpu(const PinholeCamera& base, const EpipolarLines& lines) const {
  return lines.isParallel() ? drawOnGpu(base) : impl_->spans.drawLines(base, lines, impl_->mesh);
}

GlObject GlRenderer::colors(const GlFragments& fragments, const glm::vec3& background) const {
  return resolve(impl_->color, GL_RGBA32F, fragments, background);
}

GlObject GlRenderer::encodedColors(const GlFragments& fragments, const glm::vec3& background) const {
  return resolve(impl_->encodedColor, GL_RGBA8, fragments, background);
}

GlObject GlRenderer::resolve(const GlObject& program, uint32_t format, const GlFragments& fragments,
                             const glm::vec3& background) const {
  const GladGLContext& gl = context_.gl();
  GlObject image = makeTexture(context_, format, fragments.width(), fragments.height());
  gl.UseProgram(program.id());
  gl.Uniform3f(0, background.x, background.y, background.z);
  bindMesh(context_, impl_->mesh);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, impl_->mesh.colors().id());
  gl.BindTextureUnit(0, fragments.texture().id());
  gl.BindImageTexture(0, image.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
  dispatchPixels(context_, fragments.width(), fragments.height());
  context_.check("colouring fragments");
  return image;
}

}  // namespace ocelli
