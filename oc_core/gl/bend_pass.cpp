#include "oc_core/gl/bend_pass.h"

#include <algorithm>
#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/render/bend_projection.h"

namespace ocelli {
namespace {

constexpr size_t kMaxSides = 16;

/// As shaders/bend.glsl has it, in the layout std140.
struct BendBlock {
  glm::vec4 before{0};
  glm::vec4 beyond{0};
  glm::vec4 from{0};
  glm::vec4 to{0};
  glm::vec4 axis{0};
  glm::vec4 linePoint{0};
  glm::vec4 lineDirection{0};
  glm::vec4 border{0};
  std::array<glm::vec4, 3> rowsBefore{};
  std::array<glm::vec4, 3> rowsAfter{};
  std::array<glm::vec4, kMaxSides> sides{};
  int32_t sideCount = 0;
  int32_t straight = 0;
  float shortestEdge = 0;
  uint32_t piece = 0;
  float bendFactor = 0;
  float bendWidth = 0;
  glm::vec2 unused{0};
};

glm::vec4 inSingle(const glm::dvec3& v) {
  return {glm::vec3(v), 0};
}

/// Rows of the linear map that projects places from a viewpoint, which the projection passes.
std::array<glm::vec4, 3> rowsOf(const glm::dmat4& pixelFromWorld) {
  const glm::dmat4 rows = glm::transpose(pixelFromWorld);
  return {inSingle(glm::dvec3(rows[0])), inSingle(glm::dvec3(rows[1])), inSingle(glm::dvec3(rows[3]))};
}

BendBlock blockOf(const RayTransition& transition, const BendProjection& projection, uint32_t piece) {
  const TransitionPlanes& planes = transition.planes();
  const BendBounds& bounds = projection.bounds();
  const glm::dvec3& origin = transition.before();
  const auto moved = [&](const glm::dvec4& space) {
    return glm::vec4(glm::vec3(space), static_cast<float>(glm::dot(space, glm::dvec4(origin, 1))));
  };
  BendBlock block;
  block.before = inSingle(origin);
  block.beyond = inSingle(transition.beyond() - origin);
  block.from = moved(beyond(planes.from));
  block.to = moved(beyond(planes.to));
  block.straight = transition.isStraight() ? 1 : 0;
  block.axis = transition.isStraight() ? glm::vec4(1, 0, 0, 0) : inSingle(glm::normalize(transition.beyond() - origin));
  block.linePoint = inSingle(transition.linePoint() - origin);
  block.lineDirection = inSingle(transition.lineDirection());
  block.border = inSingle(transition.border() - origin);
  block.rowsBefore = rowsOf(bounds.before());
  block.rowsAfter = rowsOf(bounds.after());
  OC_CHECK(bounds.sides().size() <= kMaxSides, "a turn has more sides than its shader takes");
  std::transform(bounds.sides().begin(), bounds.sides().end(), block.sides.begin(), moved);
  block.sideCount = static_cast<int32_t>(bounds.sides().size());
  block.shortestEdge = static_cast<float>(bounds.shortestEdge());
  block.piece = piece;
  block.bendFactor = static_cast<float>(projection.bendFactor());
  block.bendWidth = static_cast<float>(projection.widthPixels());
  return block;
}

SplitPrograms makePrograms(GlContext& context, ArcModel model) {
  const std::string arcs = std::string("#define ARCS ") + (model == ArcModel::kConic ? "CONIC" : "BEZIER") + "\n";
  const auto compute = [&](const char* name, std::string_view source, const std::string& define) {
    return makeProgram(context, name,
                       {{GL_COMPUTE_SHADER,
                         {shaders::kPinhole, shaders::kMesh, shaders::kBend, shaders::kPiece, shaders::kSplitCounts,
                          shaders::kSplitCodes, source}}},
                       arcs + define);
  };
  const std::string decide = std::string(shaders::kBendDecideComp) + std::string(shaders::kSplitStore);
  const std::string triangles = "#define SOURCE TRIANGLES\n#define BLOCKS\n";
  const std::string pieces = "#define SOURCE PIECES\n";
  SplitPrograms programs;
  programs.decideTriangles = compute("bend_decide", decide, triangles);
  programs.decidePieces = compute("bend_decide", decide, pieces);
  programs.emitTriangles = compute("split_emit", shaders::kSplitEmitComp, triangles);
  programs.emitPieces = compute("split_emit", shaders::kSplitEmitComp, pieces);
  programs.prefixSum = makeProgram(context, "prefix_sum", {{GL_COMPUTE_SHADER, {shaders::kPrefixSumComp}}});
  programs.drawLeaves = makeProgram(
      context, "bend_leaves",
      {{GL_VERTEX_SHADER,
        {shaders::kPinhole, shaders::kMesh, shaders::kBend, shaders::kPiece, shaders::kBendLeavesVert}},
       {GL_FRAGMENT_SHADER, {shaders::kPinhole, shaders::kBend, shaders::kOverlap, shaders::kBendLeavesFrag}}},
      arcs);
  return programs;  // nothing is clipped: pieces that reach out of the bend are tested by pixels
}

}  // namespace

BendPass::BendPass(GlContext& context)
    : context_(context),
      splitter_(context),
      conic_(makePrograms(context, ArcModel::kConic)),
      vertexArray_(makeVertexArray(context)) {}

void BendPass::draw(const CurvedRayCamera& camera, size_t bend, const BendProjection& projection, uint32_t piece,
                    const GlMesh& mesh, const MeshBlocks& blocks) const {
  const BendBlock block = blockOf(camera.bends()[bend], projection, piece);
  std::vector<uint32_t> seen;
  blocks.forEachWithin(projection.bounds().spaces(), [&](uint32_t i, Placement) { seen.push_back(i); });
  if (seen.empty()) {
    return;
  }
  const GlObject uniforms = makeBuffer(context_, sizeof(block), &block);
  const GlObject seenBuffer = makeBuffer(context_, seen);
  const GladGLContext& gl = context_.gl();
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms.id());
  bindMesh(context_, mesh);
  gl.BindVertexArray(vertexArray_.id());
  if (camera.arcModel() == ArcModel::kBezier && !bezier_) {
    bezier_ = makePrograms(context_, ArcModel::kBezier);
  }
  splitter_.drawBlocks(camera.arcModel() == ArcModel::kConic ? conic_ : *bezier_, seenBuffer, seen.size());
  context_.check("drawing a turn of rays");
}

}  // namespace ocelli
