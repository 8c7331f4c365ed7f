#include "oc_core/gl/segment_pass.h"

#include <algorithm>
#include <glm/mat3x3.hpp>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

/// As shaders/straight_segment.glsl has it, in the layout std140.
struct SegmentBlock {
  glm::vec4 rowU;
  glm::vec4 rowV;
  glm::vec4 rowW;
  glm::vec4 viewpoint;
  glm::vec4 begin;
  float margin;
  float nearWeight;
  uint32_t piece;
  uint32_t firstOfLeaves;
};

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

/// The vertices of the triangles of blocks, as ranges.
struct VertexRanges {
  std::vector<GLint> first;
  std::vector<GLsizei> count;

  void add(uint32_t triangle) {
    const auto vertex = static_cast<GLint>(3 * triangle);
    if (!first.empty() && first.back() + count.back() == vertex) {
      count.back() += 3;
    } else {
      first.push_back(vertex);
      count.push_back(3);
    }
  }
};

}  // namespace

SegmentPass::SegmentPass(GlContext& context)
    : context_(context),
      program_(makeProgram(
          context, "segment",
          {{GL_VERTEX_SHADER,
            {shaders::kPinhole, shaders::kMesh, shaders::kStraightSegment, shaders::kStraightSegmentVert}},
           {GL_FRAGMENT_SHADER, {shaders::kStraightSegment, shaders::kOverlap, shaders::kStraightSegmentFrag}}})),
      vertexArray_(makeVertexArray(context)) {}

GlObject SegmentPass::upload(const PixelLeaves& leaves) const {
  GlObject texture = makeTexture(context_, GL_R16UI, leaves.width(), leaves.height());
  context_.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  context_.gl().TextureSubImage2D(texture.id(), 0, 0, 0, leaves.width(), leaves.height(), GL_RED_INTEGER,
                                  GL_UNSIGNED_SHORT, leaves.data());
  return texture;
}

void SegmentPass::draw(const StraightSegment& segment, uint32_t piece, const GlObject& leaves, const GlMesh& mesh,
                       const MeshBlocks& blocks) const {
  const SegmentBounds bounds(segment);
  std::vector<BlockTask> tasks;
  bounds.findBlocks(blocks, {0, blocks.runCount()}, piece, bounds.rectIn(PinholeCamera::kMaxPixelsASide, PinholeCamera::kMaxPixelsASide), tasks);
  VertexRanges ranges;
  for (const BlockTask& task : tasks) {
    blocks.forEachTriangle(task.block, [&](uint32_t triangle) { ranges.add(triangle); });
  }
  if (ranges.first.empty()) {
    return;
  }
  // From the viewpoint, which every projection of the segment passes, the matrix is a linear one.
  const glm::dmat4 rows = glm::transpose(segment.pixelFromWorld);
  const glm::dmat3 imageFromWorld =
      glm::transpose(glm::dmat3(glm::dvec3(rows[0]), glm::dvec3(rows[1]), glm::dvec3(rows[3])));
  const SegmentBlock block{glm::vec4(glm::vec3(rows[0]), 0),
                           glm::vec4(glm::vec3(rows[1]), 0),
                           glm::vec4(glm::vec3(rows[3]), 0),
                           glm::vec4(glm::vec3(segment.viewpoint), 0),
                           planeFrom(segment.viewpoint, segment.begin),
                           static_cast<float>(bounds.margin()),
                           static_cast<float>(0.9 * nearWeight(segment, imageFromWorld)),
                           piece,
                           0};
  const std::vector<int32_t> endsOfLeaves(segment.endsOfLeaf.begin(), segment.endsOfLeaf.end());
  std::vector<glm::uvec2> kinds;
  std::vector<glm::vec4> planes;
  for (const std::vector<Plane>& ends : segment.ends) {
    kinds.emplace_back(planes.size(), ends.size());
    for (const Plane& plane : ends) {
      planes.push_back(planeFrom(segment.viewpoint, plane));
    }
  }
  const GlObject uniforms = makeBuffer(context_, sizeof(block), &block);
  const GlObject leafBuffer = makeBuffer(context_, endsOfLeaves);
  const GlObject kindBuffer = makeBuffer(context_, kinds);
  const GlObject planeBuffer = makeBuffer(context_, planes);
  const GladGLContext& gl = context_.gl();
  gl.UseProgram(program_.id());
  bindMesh(context_, mesh);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, leafBuffer.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, kindBuffer.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, planeBuffer.id());
  gl.BindTextureUnit(0, leaves.id());
  gl.BindVertexArray(vertexArray_.id());
  gl.MultiDrawArrays(GL_TRIANGLES, ranges.first.data(), ranges.count.data(), static_cast<GLsizei>(ranges.first.size()));
  context_.check("drawing a segment of straight rays");
}

}  // namespace ocelli
