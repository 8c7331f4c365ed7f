#include "oc_core/gl/bent_ray_pass.h"

#include <array>
#include <optional>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/render/camera_segments.h"

namespace ocelli {

/// Samples: piece and triangle, and in bends the weights. Pieces are drawn in their order along rays; the stencil keeps
/// the first.
class BentRayPass::Target {
 public:
  Target(GlContext& context, int width, int height, bool hasBends)
      : context_(context),
        samples_(makeTexture(context, GL_RG32UI, width, height)),
        weights_(hasBends ? makeTexture(context, GL_RG32F, width, height) : GlObject()),
        depth_(makeTexture(context, GL_DEPTH32F_STENCIL8, width, height)),
        framebuffer_(makeFramebuffer(
            context, hasBends ? std::vector{samples_.id(), weights_.id()} : std::vector{samples_.id()}, depth_.id())) {
    const GladGLContext& gl = context.gl();
    gl.NamedFramebufferTexture(framebuffer_.id(), GL_STENCIL_ATTACHMENT, depth_.id(), 0);
    beginDepthDraw(context, framebuffer_, width, height);
    gl.ClearNamedFramebufferuiv(framebuffer_.id(), GL_COLOR, 0, std::array{0u, Fragment::kNoTriangle, 0u, 0u}.data());
    const GLint nothing = 0;
    gl.StencilMask(0xff);
    gl.ClearNamedFramebufferiv(framebuffer_.id(), GL_STENCIL, 0, &nothing);
  }
  ~Target() { context_.gl().Disable(GL_STENCIL_TEST); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  /// What is drawn next comes in this order along rays: not over what came before. So depths need not be cleared: where
  /// something came, nothing comes any more.
  void begin(uint8_t order) {
    const GladGLContext& gl = context_.gl();
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_GEQUAL, 0xff - order, 0xff);  // earlier pieces have left more
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  }
  const GlObject& samples() const { return samples_; }
  const GlObject& weights() const { return weights_; }

 private:
  GlContext& context_;
  GlObject samples_;
  GlObject weights_;
  GlObject depth_;
  GlObject framebuffer_;
};

/// How rays come to each piece, as shaders/bent_rays_resolve.comp has it; places are taken from the eye.
struct BentRayPass::Ways {
  struct Bend {
    glm::vec4 plane{0};
    glm::vec4 viewpoint{0};
  };
  /// A piece that is straight: its viewpoint, from the eye, and the rows that project places from there.
  struct Straight {
    glm::vec4 viewpoint{0};
    std::array<glm::vec4, 3> rows{};
  };
  glm::dvec3 eye;
  std::vector<Bend> bends{};
  std::vector<glm::uvec4> ways{};
  std::vector<Straight> straights{};

  /// The next piece is this one.
  void add(const StraightSegment& segment) {
    const glm::dmat4 rows = glm::transpose(segment.pixelFromWorld);
    straights.push_back(
        {glm::vec4(glm::vec3(segment.viewpoint - eye), 0),
         {glm::vec4(glm::vec3(rows[0]), 0), glm::vec4(glm::vec3(rows[1]), 0), glm::vec4(glm::vec3(rows[3]), 0)}});
  }

  void add(const Plane& plane, const glm::dvec3& viewpoint) {
    bends.push_back({glm::vec4(glm::vec3(plane.normal), static_cast<float>(plane.height(eye))),
                     glm::vec4(glm::vec3(viewpoint - eye), 0)});
  }
};

BentRayPass::BentRayPass(GlContext& context)
    : context_(context),
      segments_(context),
      bends_(context),
      resolve_(makeProgram(context, "bent_rays_resolve",
                           {{GL_COMPUTE_SHADER,
                             {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kPiece, shaders::kWeights,
                              shaders::kBentRaysResolveComp}}})) {}

GlFragments BentRayPass::draw(const GraphCamera& camera, const GlMesh& mesh, const MeshBlocks& blocks) const {
  const PixelLeaves leaves = leavesOf(camera);
  const std::vector<StraightSegment> segments = segmentsOf(camera, leaves);
  const GlObject uniforms = pinholeUniforms(context_, camera.root());
  context_.gl().BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());
  Target target(context_, camera.width(), camera.height(), false);
  SegmentPass::Leaves leafTexture = segments_.upload(leaves);
  size_t drawn = 0;
  for (uint8_t order = 0; drawn < segments.size(); ++order) {
    target.begin(order);
    for (size_t i = 0; i < segments.size(); ++i) {
      if (segments[i].order == order) {
        segments_.draw(segments[i], static_cast<uint32_t>(i), leafTexture, mesh, blocks);
        ++drawn;
      }
    }
  }
  Ways ways{glm::dvec3(camera.root().eye())};
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    // That of the parent, and one bend more.
    const glm::uvec4 parent = frustum.parent < 0 ? glm::uvec4(0) : ways.ways[static_cast<size_t>(frustum.parent)];
    const glm::uvec4 way(ways.bends.size(), parent.y + (frustum.parent < 0 ? 0u : 1u), 0u, 0u);
    for (uint32_t k = 0; k < parent.y; ++k) {
      ways.bends.push_back(Ways::Bend(ways.bends[parent.x + k]));
    }
    if (frustum.parent >= 0) {
      ways.add(frustum.plane, frustum.viewpoint);
    }
    ways.ways.push_back(way);
    ways.add(segments[ways.straights.size()]);
  }
  return resolve(camera.root(), target, ways, mesh);
}

GlFragments BentRayPass::draw(const CurvedRayCamera& camera, const GlMesh& mesh, const MeshBlocks& blocks) const {
  const std::vector<StraightSegment> segments = segmentsOf(camera);
  const std::vector<RayTransition>& bends = camera.bends();
  const GlObject uniforms = pinholeUniforms(context_, camera.root());
  context_.gl().BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());
  Target target(context_, camera.width(), camera.height(), !bends.empty());
  SegmentPass::Leaves leafTexture = segments_.upload(PixelLeaves(camera.width(), camera.height(), 0));
  std::vector<std::optional<BendProjection>> projections(bends.size());
  parallelFor(bends.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      projections[i].emplace(camera, i);
    }
  });
  Ways ways{glm::dvec3(camera.root().eye())};
  for (const RayTransition& bend : bends) {
    ways.add(bend.planes().middle, bend.beyond());
  }
  for (uint32_t i = 0; i < segments.size(); ++i) {
    target.begin(segments[i].order);
    segments_.draw(segments[i], 2 * i, leafTexture, mesh, blocks);
    ways.ways.emplace_back(0u, i, 0u, 0u);
    ways.add(segments[i]);
    if (i < bends.size()) {
      target.begin(static_cast<uint8_t>(segments[i].order + 1));
      bends_.draw(camera, i, *projections[i], 2 * i + 1, mesh, blocks);
      ways.ways.emplace_back(0u, i, 1u, ways.bends.size());
      ways.straights.emplace_back();  // for the bend: not read
      ways.add(bends[i].planes().from, bends[i].before());
      ways.add(bends[i].planes().to, bends[i].beyond());
    }
  }
  return resolve(camera.root(), target, ways, mesh);
}

GlFragments BentRayPass::resolve(const PinholeCamera& root, const Target& target, const Ways& ways,
                                 const GlMesh& mesh) const {
  const GladGLContext& gl = context_.gl();
  const GlObject bends = makeBuffer(context_, ways.bends);
  const GlObject wayBuffer = makeBuffer(context_, ways.ways);
  const GlObject straights = makeBuffer(context_, ways.straights);
  GlFragments fragments(context_, root.width(), root.height());
  gl.UseProgram(resolve_.id());
  bindMesh(context_, mesh);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, bends.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, wayBuffer.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, straights.id());
  gl.BindTextureUnit(0, target.samples().id());
  gl.BindTextureUnit(1, target.weights().id());
  gl.BindImageTexture(0, fragments.texture().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(context_, root.width(), root.height());
  context_.check("drawing rays that bend");
  return fragments;
}

}  // namespace ocelli
