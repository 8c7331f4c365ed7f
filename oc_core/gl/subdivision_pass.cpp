#include "oc_core/gl/subdivision_pass.h"

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

/// Compute shaders of the splitter, which share what they know of the camera.
GlObject makeCompute(GlContext& context, int model, const char* name, std::string_view source,
                     const std::string& define) {
  return makeProgram(context, name,
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kDisplaced, shaders::kPiece, shaders::kSplitCounts,
                        shaders::kSplitCodes, source}}},
                     displacementDefine(model) + define);
}

SplitPrograms makePrograms(GlContext& context, int model) {
  const std::string triangles = "#define SOURCE TRIANGLES\n";
  const std::string pieces = "#define SOURCE PIECES\n";
  const std::string clip = "#define GROUP " + std::to_string(PieceSplitter::kClipGroup) + "\n";
  const auto compute = [&](const char* name, std::string_view source, const std::string& define) {
    return makeCompute(context, model, name, source, define);
  };
  const std::string decide = std::string(shaders::kSplitDecideComp) + std::string(shaders::kSplitStore);
  return {
      compute("split_decide", decide, triangles),
      compute("split_decide", decide, pieces),
      compute("split_emit", shaders::kSplitEmitComp, triangles),
      compute("split_emit", shaders::kSplitEmitComp, pieces),
      compute("clip", shaders::kClipComp, clip + "#define STAGE COUNT\n"),
      compute("clip", shaders::kClipComp, clip + "#define STAGE EMIT\n"),
      makeProgram(context, "prefix_sum", {{GL_COMPUTE_SHADER, {shaders::kPrefixSumComp}}}),
      makeProgram(context, "leaves",
                  {{GL_VERTEX_SHADER,
                    {shaders::kPinhole, shaders::kMesh, shaders::kDisplaced, shaders::kPiece, shaders::kLeavesVert}},
                   {GL_FRAGMENT_SHADER, {shaders::kFragment, shaders::kLeavesFrag}}},
                  displacementDefine(model))};
}

}  // namespace

SubdivisionPass::Model::Model(GlContext& context, int number)
    : split(makePrograms(context, number)),
      keepUndisplaced(
          makeProgram(context, "keep_undisplaced",
                      {{GL_COMPUTE_SHADER,
                        {shaders::kPinhole, shaders::kDisplaced, shaders::kFragment, shaders::kKeepUndisplacedComp}}},
                      displacementDefine(number))) {}

SubdivisionPass::SubdivisionPass(GlContext& context)
    : context_(context),
      splitter_(context),
      spoc_(context, kSpocModel),
      reversePinhole_(context, kReversePinholeModel),
      ddoc_(context, kDdocModel),
      vertexArray_(makeVertexArray(context)) {}

GlFragments SubdivisionPass::draw(const SpocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  return drawModel(spoc_, camera.reference(), displacementBlock(camera, options), seen, mesh);
}

GlFragments SubdivisionPass::draw(const ReversePinholeCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  return drawModel(reversePinhole_, camera.reference(), displacementBlock(camera, options), seen, mesh);
}

GlFragments SubdivisionPass::draw(const DdocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  const GladGLContext& gl = context_.gl();
  const GlObject map = distortionTexture(context_, camera);
  const Image<uint32_t>& before = camera.displacedBefore();
  const GlObject displacedBefore = makeTexture(context_, GL_R32UI, before.width(), before.height());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TextureSubImage2D(displacedBefore.id(), 0, 0, 0, before.width(), before.height(), GL_RED_INTEGER, GL_UNSIGNED_INT,
                       before.data());
  gl.BindTextureUnit(1, map.id());
  gl.BindTextureUnit(2, displacedBefore.id());
  return drawModel(ddoc_, camera.reference(), displacementBlock(camera, options), seen, mesh);
}

GlFragments SubdivisionPass::drawModel(const Model& model, const PinholeCamera& reference,
                                       const DisplacementBlock& block, const GlFragments& seen,
                                       const GlMesh& mesh) const {
  const GladGLContext& gl = context_.gl();
  const GlObject pinhole = pinholeUniforms(context_, reference);
  const GlObject displacement = makeBuffer(context_, sizeof(block), &block);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, pinhole.id());
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, displacement.id());
  bindMesh(context_, mesh);

  GlFragments fragments(context_, reference.width(), reference.height());
  fragments.clear();
  const GlObject depth = makeTexture(context_, GL_DEPTH_COMPONENT32F, reference.width(), reference.height());
  const GlObject framebuffer = makeFramebuffer(context_, std::array{fragments.texture().id()}, depth.id());
  beginDepthDraw(context_, framebuffer, reference.width(), reference.height());
  gl.BindVertexArray(vertexArray_.id());
  splitter_.draw(model.split, mesh);

  gl.UseProgram(model.keepUndisplaced.id());
  gl.BindTextureUnit(0, seen.texture().id());
  gl.BindImageTexture(0, fragments.texture().id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32UI);
  dispatchPixels(context_, reference.width(), reference.height());
  context_.check("drawing displaced triangles");
  return fragments;
}

}  // namespace ocelli
