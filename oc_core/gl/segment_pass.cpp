#include "oc_core/gl/segment_pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <limits>
#include <span>

#include "oc_core/camera/pinhole_camera.h"
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
  uint32_t planeCount = 0;
  std::array<glm::vec4, kEndPlanes> endPlanes{};
};
static_assert(sizeof(SegmentBlock) == 160);

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
  GLuint firstIndex = 0;  ///< which the shader gets, too (GlMesh::kDrawNumber)
  GLint baseVertex = 0;
  GLuint baseInstance = 0;  ///< the place in the list of draws
};

/// Adds the triangles of a block whose corners are finite, to the draw before where they lie side by side.
void addBlock(std::vector<IndirectDraw>& draws, const MeshBlocks& blocks, uint32_t block) {
  const auto first = static_cast<GLuint>(block * MeshBlocks::kTriangles);
  for (uint64_t left = blocks[block].finite; left != 0;) {
    const int skipped = std::countr_zero(left);
    const int triangles = std::countr_one(left >> skipped);
    left &= ~(((uint64_t{1} << triangles) - 1) << skipped);
    const GLuint firstIndex = 3 * (first + static_cast<GLuint>(skipped));
    const GLuint count = 3 * static_cast<GLuint>(triangles);
    if (!draws.empty() && draws.back().firstIndex + draws.back().count == firstIndex) {
      draws.back().count += count;
    } else {
      draws.push_back({.count = count, .firstIndex = firstIndex});
    }
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

/// The rays of a segment that end alike.
struct SegmentPass::Kind {
  int16_t number = 0;
  PixelBounds rect;              ///< around their pixels
  bool fills = false;            ///< these are all of it
  std::vector<uint32_t> ofLeaf;  ///< whether the rays of each leaf are of this kind
  double margin = 0;             ///< how far before the first plane triangles are drawn
  std::span<const BlockTask> tasks;
};

SegmentPass::Leaves SegmentPass::upload(const PixelLeaves& leaves) const {
  Leaves uploaded{makeTexture(context_, GL_R16UI, leaves.width(), leaves.height()), {}, {}};
  context_.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  context_.gl().TextureSubImage2D(uploaded.texture.id(), 0, 0, 0, leaves.width(), leaves.height(), GL_RED_INTEGER,
                                  GL_UNSIGNED_SHORT, leaves.data());
  for (int y = 0; y < leaves.height(); ++y) {
    for (int x = 0; x < leaves.width();) {
      const uint16_t leaf = leaves(x, y);
      const int first = x;
      while (x < leaves.width() && leaves(x, y) == leaf) {
        ++x;
      }
      if (leaf >= uploaded.rects.size()) {
        uploaded.rects.resize(leaf + size_t{1}, {leaves.width(), leaves.height(), 0, 0});
        uploaded.pixels.resize(leaf + size_t{1}, 0);
      }
      PixelBounds& rect = uploaded.rects[leaf];
      rect = {std::min(rect.x0, first), std::min(rect.y0, y), std::max(rect.x1, x), std::max(rect.y1, y + 1)};
      uploaded.pixels[leaf] += static_cast<size_t>(x - first);
    }
  }
  return uploaded;
}

/// Lays out depths: nothing is drawn where rays of this kind do not pass.
void SegmentPass::closeOtherPixels(const Kind& kind, Leaves& leaves) const {
  const GladGLContext& gl = context_.gl();
  const GlObject isOfKind = makeBuffer(context_, kind.ofLeaf);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, isOfKind.id());
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
  leaves.isMasked = true;
}

void SegmentPass::draw(const StraightSegment& segment, uint32_t piece, Leaves& leaves, const GlMesh& mesh,
                       const MeshBlocks& blocks) const {
  const SegmentBounds bounds(segment);
  const PixelBounds rect = bounds.rectIn(PinholeCamera::kMaxPixelsASide, PinholeCamera::kMaxPixelsASide);
  std::vector<BlockTask> tasks;
  bounds.findBlocks(blocks, {0, blocks.runCount()}, piece, rect, tasks);
  sortRuns(tasks);
  const GladGLContext& gl = context_.gl();
  gl.Enable(GL_SCISSOR_TEST);
  for (size_t number = 0; number < segment.ends.size(); ++number) {
    Kind kind{static_cast<int16_t>(number),
              {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 0, 0},
              false,
              {},
              bounds.margin(),
              tasks};
    size_t pixels = 0;
    for (size_t leaf = 0; leaf < leaves.rects.size(); ++leaf) {
      kind.ofLeaf.push_back(segment.endsOfLeaf[leaf] == kind.number ? 1 : 0);
      if (kind.ofLeaf.back() != 0 && leaves.pixels[leaf] > 0) {
        const PixelBounds& of = leaves.rects[leaf];
        kind.rect = {std::min(kind.rect.x0, of.x0), std::min(kind.rect.y0, of.y0), std::max(kind.rect.x1, of.x1),
                     std::max(kind.rect.y1, of.y1)};
        pixels += leaves.pixels[leaf];
      }
    }
    if (pixels > 0) {
      kind.fills =
          pixels == static_cast<size_t>(kind.rect.x1 - kind.rect.x0) * static_cast<size_t>(kind.rect.y1 - kind.rect.y0);
      drawKind(segment, kind, piece, leaves, mesh, blocks);
    }
  }
  gl.Disable(GL_SCISSOR_TEST);
  context_.check("drawing a segment of straight rays");
}

void SegmentPass::drawKind(const StraightSegment& segment, const Kind& kind, uint32_t piece, Leaves& leaves,
                           const GlMesh& mesh, const MeshBlocks& blocks) const {
  const uint64_t bit = RegionBuffer::kindBit(static_cast<size_t>(kind.number));
  std::vector<IndirectDraw> draws;
  std::vector<IndirectDraw> reaching;
  for (const BlockTask& task : kind.tasks) {
    const bool isApart = task.rect.x0 >= kind.rect.x1 || task.rect.x1 <= kind.rect.x0 || task.rect.y0 >= kind.rect.y1 ||
                         task.rect.y1 <= kind.rect.y0;
    if (!isApart && (task.ended & bit) == 0) {
      addBlock(task.within && (task.clear & bit) != 0 ? draws : reaching, blocks, task.block);
    }
  }
  if (draws.empty() && reaching.empty()) {
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
                     static_cast<float>(kind.margin),
                     static_cast<float>(0.9 * nearWeight(segment, imageFromWorld)),
                     piece};
  std::vector<glm::vec4> planes;
  for (const Plane& plane : segment.ends[static_cast<size_t>(kind.number)]) {
    planes.push_back(planeFrom(segment.viewpoint, plane));
  }
  block.planeCount = static_cast<uint32_t>(planes.size());
  std::copy_n(planes.begin(), std::min(planes.size(), SegmentBlock::kEndPlanes), block.endPlanes.begin());
  const size_t whole = draws.size();
  draws.insert(draws.end(), reaching.begin(), reaching.end());
  for (size_t i = 0; i < draws.size(); ++i) {
    draws[i].baseInstance = static_cast<GLuint>(i);
  }
  const GlObject uniforms = makeBuffer(context_, sizeof(block), &block);
  const GlObject planeBuffer = makeBuffer(context_, planes);
  const GlObject drawBuffer = makeBuffer(context_, draws);
  const GladGLContext& gl = context_.gl();
  gl.Scissor(kind.rect.x0, kind.rect.y0, kind.rect.x1 - kind.rect.x0, kind.rect.y1 - kind.rect.y0);
  if (!kind.fills || leaves.isMasked) {
    closeOtherPixels(kind, leaves);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, planeBuffer.id());
  const GLuint vertices = mesh.vertexArray().id();
  gl.BindVertexArray(vertices);
  gl.VertexArrayVertexBuffer(vertices, GlMesh::kDrawNumber, drawBuffer.id(), offsetof(IndirectDraw, firstIndex),
                             sizeof(IndirectDraw));
  gl.EnableVertexArrayAttrib(vertices, GlMesh::kDrawNumber);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, drawBuffer.id());
  const auto drawSome = [&](const GlObject& program, size_t first, size_t count) {
    if (count > 0) {
      gl.UseProgram(program.id());
      gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                                   reinterpret_cast<const void*>(first * sizeof(IndirectDraw)),
                                   static_cast<GLsizei>(count), 0);
    }
  };
  drawSome(whole_, 0, whole);
  drawSome(tested_, whole, draws.size() - whole);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  gl.DisableVertexArrayAttrib(vertices, GlMesh::kDrawNumber);
  gl.VertexArrayVertexBuffer(vertices, GlMesh::kDrawNumber, 0, 0, sizeof(IndirectDraw));
}

}  // namespace ocelli
