#include "oc_core/gl/subdivision_pass.h"

#include <algorithm>
#include <array>
#include <vector>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

// As shaders/displaced.glsl numbers them.
constexpr int kSpoc = 1;
constexpr int kReversePinhole = 2;
constexpr int kDdoc = 3;
constexpr int kGpc = 4;
constexpr size_t kGpcTexels = 3;  ///< of a zone

std::string modelDefine(int model) {
  return "#define MODEL " + std::to_string(model) + "\n";
}

/// Compute shaders of the splitter, which share what they know of the camera.
GlObject makeCompute(GlContext& context, int model, const char* name, std::string_view source,
                     const std::string& define) {
  return makeProgram(context, name,
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kDisplaced, shaders::kPiece, shaders::kSplitCounts,
                        shaders::kSplitCodes, source}}},
                     modelDefine(model) + define);
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
                  modelDefine(model))};
}

}  // namespace

/// In the layout std140, as shaders/displaced.glsl has it.
struct SubdivisionPass::Block {
  glm::vec2 pole{0};
  float displacedFrom = 0;
  float inverseNear = 0;
  float perInverseZ = 0;
  float nearPixels = 0;
  float farPixels = 0;
  float sameImageDepth = 0;
  float meetingDepth = 0;
  float clipMargin = 0;
  uint32_t bilinear = 0;
  float longestEdge = 0;
  float shortestEdge = 0;
  float tornEdge = 0;
  glm::vec2 unused{0};

  Block(float longest, const SubdivisionOptions& options)
      : clipMargin(longest + 2),
        longestEdge(options.longestEdgePixels),
        shortestEdge(options.shortestEdgePixels),
        tornEdge(options.tornEdgePixels) {}
};

SubdivisionPass::Model::Model(GlContext& context, int number)
    : split(makePrograms(context, number)),
      keepUndisplaced(
          makeProgram(context, "keep_undisplaced",
                      {{GL_COMPUTE_SHADER,
                        {shaders::kPinhole, shaders::kDisplaced, shaders::kFragment, shaders::kKeepUndisplacedComp}}},
                      modelDefine(number))) {}

SubdivisionPass::SubdivisionPass(GlContext& context)
    : context_(context),
      splitter_(context),
      spoc_(context, kSpoc),
      reversePinhole_(context, kReversePinhole),
      ddoc_(context, kDdoc),
      gpc_(context, kGpc),
      vertexArray_(makeVertexArray(context)) {}

GlFragments SubdivisionPass::draw(const SpocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  const SpocDistortion& d = camera.distortion();
  Block block(camera.longestDisplacement(), options);
  block.pole = d.pole;
  block.displacedFrom = d.zNear;
  block.inverseNear = 1 / d.zNear;
  block.perInverseZ = 1 / (block.inverseNear - 1 / d.zFar);
  block.nearPixels = d.nearPixels;
  block.farPixels = d.farPixels;
  return drawModel(spoc_, camera.reference(), block, seen, mesh);
}

GlFragments SubdivisionPass::draw(const ReversePinholeCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  Block block(camera.longestDisplacement(), options);
  block.sameImageDepth = camera.sameImageDepth();
  block.meetingDepth = camera.meetingDepth();
  return drawModel(reversePinhole_, camera.reference(), block, seen, mesh);
}

GlFragments SubdivisionPass::draw(const GpcCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  const GladGLContext& gl = context_.gl();
  const Block block(camera.longestDisplacement(), options);
  // Rows of texels as shaders/displaced.glsl has them; one row without a zone displaces nothing.
  std::vector<glm::vec4> texels;
  for (const GpcZone& zone : camera.map().zones()) {
    const GpcProfile& profile = zone.profile();
    const std::array<double, 4>& c = profile.coefficients();
    texels.insert(texels.end(),
                  {glm::vec4(zone.center(), zone.half()),
                   glm::vec4(1 / profile.zoom(), profile.outer(), profile.leastRate(), profile.greatestRate()),
                   glm::vec4(c[0], c[1], c[2], c[3])});
  }
  texels.resize(std::max<size_t>(texels.size(), kGpcTexels), glm::vec4(0));
  const auto rows = static_cast<int>(texels.size() / kGpcTexels);
  const GlObject zones = makeTexture(context_, GL_RGBA32F, static_cast<int>(kGpcTexels), rows);
  gl.TextureSubImage2D(zones.id(), 0, 0, 0, static_cast<int>(kGpcTexels), rows, GL_RGBA, GL_FLOAT, texels.data());
  gl.BindTextureUnit(1, zones.id());
  return drawModel(gpc_, camera.reference(), block, seen, mesh);
}

GlFragments SubdivisionPass::draw(const DdocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                                  const SubdivisionOptions& options) const {
  static_assert(sizeof(DistortionSample) == 4 * sizeof(float), "a sample is a texel");
  const GladGLContext& gl = context_.gl();
  Block block(camera.longestDisplacement(), options);
  block.bilinear = camera.map().lookup() == DistortionMap::Lookup::kBilinear ? 1 : 0;
  const GlObject map = makeTexture(context_, GL_RGBA32F, camera.width(), camera.height());
  gl.TextureSubImage2D(map.id(), 0, 0, 0, camera.width(), camera.height(), GL_RGBA, GL_FLOAT,
                       camera.map().samples().data());
  const Image<uint32_t>& before = camera.displacedBefore();
  const GlObject displacedBefore = makeTexture(context_, GL_R32UI, before.width(), before.height());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TextureSubImage2D(displacedBefore.id(), 0, 0, 0, before.width(), before.height(), GL_RED_INTEGER, GL_UNSIGNED_INT,
                       before.data());
  gl.BindTextureUnit(1, map.id());
  gl.BindTextureUnit(2, displacedBefore.id());
  return drawModel(ddoc_, camera.reference(), block, seen, mesh);
}

GlFragments SubdivisionPass::drawModel(const Model& model, const PinholeCamera& reference, const Block& block,
                                       const GlFragments& seen, const GlMesh& mesh) const {
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
