#include "oc_core/gl/segment_pass.h"

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

/// As shaders/straight_segment.glsl has it, in the layout std140.
struct SegmentBlock {
  static constexpr size_t kEndPlanes = 4;

  glm::vec4 rowU;
  glm::vec4 rowV;
  glm::vec4 rowW;
  glm::vec4 viewpoint;
  glm::vec4 begin;
  float margin = 0;
  float nearWeight = 0;
  uint32_t piece = 0;
  uint32_t kindCount = 0;
  glm::uvec4 planeCount{0};
  std::array<glm::vec4, kEndPlanes> endPlanes{};
};
static_assert(sizeof(SegmentBlock) == 176);

glm::vec4 planeFrom(const glm::dvec3& viewpoint, const Plane& plane) {
  return {glm::vec3(plane.normal), static_cast<float>(plane.height(viewpoint))};
}

/// Least weight of what the segment shows: at the corner of its part where its first plane is nearest.
double nearWeight(const StraightSegment& segment, const glm::dmat3& imageFromWorld) {
  const glm::dmat3 worldFromImage = glm::inverse(imageFromWorld);
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& corner : segment.part) {
    const glm::dvec3 direction = worldFromImage * glm::dvec3(corner, 1);
    least = std::min(least, -segment.begin.height(segment.viewpoint) / glm::dot(segment.begin.normal, direction));
  }
  return least;
}

/// As OpenGL takes it.
struct IndirectDraw {
  GLuint count = 0;
  GLuint instances = 1;
  GLuint firstIndex = 0;
  GLint baseVertex = 0;
  GLuint baseInstance = 0;  ///< the block, which location 2 tells the shader
};

/// What a draw of blocks needs that lie side by side.
void addBlock(std::vector<IndirectDraw>& draws, uint32_t block, const GlMesh& mesh) {
  constexpr auto kIndices = static_cast<GLuint>(3 * MeshBlocks::kTriangles);
  const GLuint first = block * kIndices;
  const GLuint count = std::min(kIndices, static_cast<GLuint>(3 * mesh.triangleCount()) - first);
  if (!draws.empty() && draws.back().firstIndex + draws.back().count == first) {
    draws.back().count += count;
  } else {
    draws.push_back({count, 1, first, 0, block});
  }
}

/// Runs of blocks from the near to the far. Blocks of a run stay in their order: the more of them lie side by side, the
/// fewer draws there are.
void sortRuns(std::vector<BlockTask>& tasks) {
  struct Run {
    size_t first;
    size_t last;
    float nearest;
  };
  std::vector<Run> runs;
  for (size_t i = 0; i < tasks.size(); ++i) {
    if (runs.empty() || tasks[runs.back().first].block / MeshBlocks::kRun != tasks[i].block / MeshBlocks::kRun) {
      runs.push_back({i, i, tasks[i].nearest});
    }
    runs.back().last = i + 1;
    runs.back().nearest = std::min(runs.back().nearest, tasks[i].nearest);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.nearest < b.nearest; });
  std::vector<BlockTask> sorted;
  sorted.reserve(tasks.size());
  for (const Run& run : runs) {
    sorted.insert(sorted.end(), tasks.begin() + static_cast<std::ptrdiff_t>(run.first),
                  tasks.begin() + static_cast<std::ptrdiff_t>(run.last));
  }
  tasks.swap(sorted);
}

GlObject makeSegmentProgram(GlContext& context, const std::string& defines) {
  return makeProgram(
      context, "segment",
      {{GL_VERTEX_SHADER, {shaders::kPinhole, shaders::kStraightSegment, shaders::kStraightSegmentVert}},
       {GL_FRAGMENT_SHADER, {shaders::kStraightSegment, shaders::kOverlap, shaders::kStraightSegmentFrag}}},
      defines);
}

}  // namespace

SegmentPass::SegmentPass(GlContext& context)
    : context_(context),
      whole_(makeSegmentProgram(context, "")),
      tested_(makeSegmentProgram(context, "#define TESTED\n")),
      mask_(makeProgram(
          context, "segment_mask",
          {{GL_VERTEX_SHADER, {shaders::kSegmentMaskVert}}, {GL_FRAGMENT_SHADER, {shaders::kSegmentMaskFrag}}})),
      noVertices_(makeVertexArray(context)) {}

SegmentPass::Leaves SegmentPass::upload(const PixelLeaves& leaves) const {
  Leaves uploaded{
      makeTexture(context_, GL_R16UI, leaves.width(), leaves.height()), {}, leaves.width(), leaves.height()};
  context_.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  context_.gl().TextureSubImage2D(uploaded.texture.id(), 0, 0, 0, leaves.width(), leaves.height(), GL_RED_INTEGER,
                                  GL_UNSIGNED_SHORT, leaves.data());
  for (const uint16_t leaf : leaves) {
    if (leaf >= uploaded.seen.size()) {
      uploaded.seen.resize(leaf + size_t{1}, 0);
    }
    uploaded.seen[leaf] = 1;
  }
  return uploaded;
}

/// Lays out depths: nothing is drawn where the rays of the segment do not pass.
void SegmentPass::closeOtherPixels(const GlObject& endsOfLeaves, const Leaves& leaves) const {
  const GladGLContext& gl = context_.gl();
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, endsOfLeaves.id());
  gl.BindTextureUnit(0, leaves.texture.id());
  gl.UseProgram(mask_.id());
  gl.BindVertexArray(noVertices_.id());
  gl.Disable(GL_STENCIL_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthFunc(GL_GREATER);
  gl.Enable(GL_STENCIL_TEST);
}

void SegmentPass::draw(const StraightSegment& segment, uint32_t piece, const Leaves& leaves, const GlMesh& mesh,
                       const MeshBlocks& blocks) const {
  const SegmentBounds bounds(segment);
  const PixelBounds rect = bounds.rectIn(leaves.width, leaves.height);
  std::vector<BlockTask> tasks;
  bounds.findBlocks(blocks, {0, blocks.runCount()}, piece, rect, tasks);
  sortRuns(tasks);
  std::vector<IndirectDraw> whole;
  std::vector<IndirectDraw> reaching;
  for (const BlockTask& task : tasks) {
    if (task.rect.x0 < task.rect.x1 && task.rect.y0 < task.rect.y1) {
      addBlock(task.within && task.clear == ~uint64_t{0} ? whole : reaching, task.block, mesh);
    }
  }
  if (whole.empty() && reaching.empty()) {
    return;
  }
  // From the viewpoint, which every projection of the segment passes, the matrix is a linear one.
  const glm::dmat4 rows = glm::transpose(segment.pixelFromWorld);
  const glm::dmat3 imageFromWorld =
      glm::transpose(glm::dmat3(glm::dvec3(rows[0]), glm::dvec3(rows[1]), glm::dvec3(rows[3])));
  SegmentBlock block{glm::vec4(glm::vec3(rows[0]), 0),
                     glm::vec4(glm::vec3(rows[1]), 0),
                     glm::vec4(glm::vec3(rows[3]), 0),
                     glm::vec4(glm::vec3(segment.viewpoint), 0),
                     planeFrom(segment.viewpoint, segment.begin),
                     static_cast<float>(bounds.margin()),
                     static_cast<float>(0.9 * nearWeight(segment, imageFromWorld)),
                     piece};
  const std::vector<int32_t> endsOfLeaves(segment.endsOfLeaf.begin(), segment.endsOfLeaf.end());
  std::vector<glm::uvec2> kinds;
  std::vector<glm::vec4> planes;
  for (const std::vector<Plane>& ends : segment.ends) {
    kinds.emplace_back(planes.size(), ends.size());
    for (const Plane& plane : ends) {
      planes.push_back(planeFrom(segment.viewpoint, plane));
    }
  }
  if (kinds.size() == 1 && planes.size() <= SegmentBlock::kEndPlanes) {
    block.kindCount = 1;
    block.planeCount.x = static_cast<uint32_t>(planes.size());
    std::copy(planes.begin(), planes.end(), block.endPlanes.begin());
  }
  const size_t wholeDraws = whole.size();
  whole.insert(whole.end(), reaching.begin(), reaching.end());
  const GlObject uniforms = makeBuffer(context_, sizeof(block), &block);
  const GlObject leafBuffer = makeBuffer(context_, endsOfLeaves);
  const GlObject kindBuffer = makeBuffer(context_, kinds);
  const GlObject planeBuffer = makeBuffer(context_, planes);
  const GlObject draws = makeBuffer(context_, whole);
  const GladGLContext& gl = context_.gl();
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0);
  bool passesAll = true;
  for (size_t leaf = 0; leaf < leaves.seen.size(); ++leaf) {
    passesAll = passesAll && (leaves.seen[leaf] == 0 || segment.endsOfLeaf[leaf] >= 0);
  }
  if (!passesAll) {
    closeOtherPixels(leafBuffer, leaves);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, leafBuffer.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, kindBuffer.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, planeBuffer.id());
  gl.BindTextureUnit(0, leaves.texture.id());
  gl.BindVertexArray(mesh.vertexArray().id());
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, draws.id());
  const auto drawSome = [&](const GlObject& program, size_t first, size_t count) {
    if (count > 0) {
      gl.UseProgram(program.id());
      gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                                   reinterpret_cast<const void*>(first * sizeof(IndirectDraw)),
                                   static_cast<GLsizei>(count), 0);
    }
  };
  drawSome(whole_, 0, wholeDraws);
  drawSome(tested_, wholeDraws, whole.size() - wholeDraws);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  gl.Disable(GL_SCISSOR_TEST);
  context_.check("drawing a segment of straight rays");
}

}  // namespace ocelli
