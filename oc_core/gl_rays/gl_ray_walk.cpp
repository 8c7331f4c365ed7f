#include "oc_core/gl_rays/gl_ray_walk.h"

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>
#include <string>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl_rays/shaders.h"

namespace ocelli {
namespace {

constexpr size_t kChildren = SamplePyramid::kChildren;
/// As shaders/pyramid_walk.glsl has it: no cell has this number.
constexpr uint32_t kNoChild = 0xffffffffu;
/// Children that the smallest program has room for: 3 levels. Deeper trees get one of their own.
constexpr size_t kMinWaiting = 3 * (kChildren - 1) + 1;

/// In the layout std430, as shaders/pyramid_walk.glsl has it.
struct NodeItem {
  std::array<std::array<float, kChildren>, 3> lower;
  std::array<std::array<float, kChildren>, 3> upper;
  std::array<uint32_t, kChildren> child;
};
static_assert(kChildren == 16 && sizeof(NodeItem) == 28 * sizeof(glm::vec4));

GlObject uploadNodes(GlContext& context, const SamplePyramid& pyramid) {
  std::vector<NodeItem> items;
  items.reserve(pyramid.nodes().size());
  for (const SamplePyramid::Node& node : pyramid.nodes()) {
    NodeItem& item = items.emplace_back(NodeItem{node.lower, node.upper, node.child});
    std::fill(item.child.begin() + node.count, item.child.end(), kNoChild);
  }
  return makeBuffer(context, items);
}

/// Iterations of the loop of the walk. Software renderers end a shader after 65535 iterations of its loops, all
/// together, and say nothing: so it is given up before. An iteration puts a node's children or tests a cell's
/// triangles; neighbours share the count, so each iteration may take both.
uint32_t iterationsFor(const GlContext& context, const SampleCells& cells) {
  if (!context.info().isSoftware) {
    return 0xffffffffu;
  }
  uint32_t most = 0;
  for (size_t i = 0; i < cells.cellCount(); ++i) {
    most = std::max(most, cells.firstTriangle[i + 1] - cells.firstTriangle[i]);
  }
  constexpr uint32_t kMaxSoftwareIterations = 65535;
  // To count children, to enter four groups of them, to put them; the last look of each loop may count, too.
  constexpr uint32_t kOfNode = 5 + 4 * 4 + (kChildren + 1);
  const uint32_t ofCell = most + 1;
  return kMaxSoftwareIterations / (1 + kOfNode + ofCell);
}

}  // namespace

GlRayWalk::GlRayWalk(GlContext& context, const SampleCells& cells, const SamplePyramid& pyramid)
    : context_(&context), mesh_(context, Mesh{}) {
  setTarget(cells, pyramid);
}

GlRayWalk::GlRayWalk(GlContext& context, const DepthImageTarget& target)
    : GlRayWalk(context, target.cells(), target.pyramid()) {}

void GlRayWalk::setTarget(const SampleCells& cells, const SamplePyramid& pyramid) {
  mesh_ = GlMesh(*context_, cells.mesh);
  nodes_ = uploadNodes(*context_, pyramid);
  firstTriangle_ = makeBuffer(*context_, cells.firstTriangle);
  root_ = pyramid.root().value_or(kNoChild);
  maxIterations_ = iterationsFor(*context_, cells);
  maxSteps_ = pyramid.maxSteps();
  makeProgramFor(pyramid.maxWaiting());
}

void GlRayWalk::makeProgramFor(size_t waiting) {
  if (waiting <= maxWaiting_) {
    return;
  }
  maxWaiting_ = std::max(waiting, kMinWaiting);
  program_ = makeProgram(
      *context_, "ray_walk",
      {{GL_COMPUTE_SHADER,
        {shaders::kMesh, shaders::kFragment, shaders::kStraightRay, shaders::kPyramidWalk, shaders::kRayWalkComp}}},
      "#define MAX_WAITING " + std::to_string(maxWaiting_) + "\n");
}

GlRayHits GlRayWalk::walk(const GlRays& rays) const {
  const GladGLContext& gl = context_->gl();
  GlRayHits hits{GlFragments(*context_, rays.width(), rays.height()),
                 makeTexture(*context_, GL_RGBA32F, rays.width(), rays.height()),
                 makeTexture(*context_, GL_RGBA32UI, rays.width(), rays.height())};
  gl.UseProgram(program_.id());
  gl.Uniform1ui(0, root_);
  gl.Uniform1ui(1, maxIterations_);
  bindMesh(*context_, mesh_);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, mesh_.colors().id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, nodes_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, firstTriangle_.id());
  gl.BindTextureUnit(0, rays.origins().id());
  gl.BindTextureUnit(1, rays.steps().id());
  gl.BindImageTexture(0, hits.fragments.texture().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  gl.BindImageTexture(1, hits.colors.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(2, hits.costs.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(*context_, rays.width(), rays.height());
  context_->check("walking rays");
  return hits;
}

void castOnGpu(GlContext& context, const GlRayWalk& walk, const DepthImageTarget& target, std::span<const RayPath> rays,
               std::span<std::optional<Hit>> found, std::span<RayCost> costs) {
  OC_CHECK(rays.size() == found.size() && rays.size() == costs.size(), "one hit and one cost a ray");
  std::vector<StraightRay> straight(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].size() == 2) {
      straight[i] = {rays[i][0], rays[i][1] - rays[i][0], 1};
    }
  }
  const Image<StraightRay> image = rayImage(straight);
  const GlRayHits hits = walk.walk(GlRays(context, image));
  const FragmentImage fragments = hits.fragments.read();
  const auto colors = readTexture<glm::vec4>(context, hits.colors, image.width(), image.height(), GL_RGBA, GL_FLOAT);
  const auto spent =
      readTexture<glm::uvec4>(context, hits.costs, image.width(), image.height(), GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  for (size_t i = 0; i < rays.size(); ++i) {
    const size_t texel = rayTexel(image, i);
    const Fragment& fragment = fragments[texel];
    costs[i] = {spent[texel].x, spent[texel].y, spent[texel].z, spent[texel].w};
    if (fragment.t == kUnansweredDistance || rays[i].size() > 2) {
      costs[i] = {};
      found[i] = target.hit(rays[i], costs[i]);
    } else if (fragment.covered()) {
      found[i] =
          Hit{fragment.t, positionOf(fragment, target.cells().mesh), glm::vec3(colors[texel]), fragment.triangle};
    } else {
      found[i] = std::nullopt;
    }
  }
}

}  // namespace ocelli
