#include "oc_core/gl/span_pass.h"

#include <algorithm>
#include <array>

#include "oc_core/base/check.h"
#include "oc_core/gl/epipolar_uniforms.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/piece_lists.h"
#include "oc_core/gl/piece_splitter.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

constexpr GLuint kGroup = 64;
/// Items in a list, 32 MiB; a few less than 2^22, since groups of them are counted in 16 bits.
constexpr uint32_t kCapacity = (1u << 22) - kGroup;

// Bindings of lists.
constexpr GLuint kItems = 2;
constexpr GLuint kCounters = 3;
constexpr GLuint kClips = 5;
constexpr GLuint kPieces = 7;

void bindList(const GladGLContext& gl, GLuint binding, const GlObject& list) {
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, list.id());
}

GlObject makeSelect(GlContext& context, const std::string& target, const std::string& source) {
  return makeProgram(context, "span_select",
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kPiece, shaders::kEpipolarLines,
                        shaders::kSpanPieces, shaders::kSpanSelectComp}}},
                     target + "#define SOURCE " + source + "\n");
}

GlObject makeSpans(GlContext& context, const std::string& target, const std::string& stage) {
  return makeProgram(context, "spans",
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kPiece, shaders::kEpipolarLines,
                        shaders::kEpipolarDisocclusions, shaders::kSpanPieces, shaders::kSpansComp}}},
                     target + "#define STAGE " + stage + "\n");
}

GlObject makeClip(GlContext& context, const std::string& stage) {
  return makeProgram(context, "clip",
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kPiece, shaders::kEpipolarLines,
                        shaders::kSplitCounts, shaders::kClipComp}}},
                     "#define GROUP " + std::to_string(PieceSplitter::kClipGroup) + "\n#define STAGE " + stage + "\n");
}

GlObject makeResolve(GlContext& context, const char* name, std::string_view source) {
  return makeProgram(context, name,
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kWeights,
                        shaders::kEpipolarLines, shaders::kEpipolarDisocclusions, source}}});
}

/// What the passes select by number: which program, which target.
std::string targetDefine(const char* name) {
  return std::string("#define BASE 1\n#define DISOCCLUSIONS 2\n#define TARGET ") + name + "\n";
}

}  // namespace

SpanPass::Target::Target(GlContext& context, const char* name)
    : selectTriangles(makeSelect(context, targetDefine(name), "TRIANGLES")),
      selectPieces(makeSelect(context, targetDefine(name), "PIECES")),
      depth(makeSpans(context, targetDefine(name), "DEPTH")),
      index(makeSpans(context, targetDefine(name), "INDEX")) {}

SpanPass::SpanPass(GlContext& context)
    : context_(context),
      base_(context, "BASE"),
      disocclusions_(context, "DISOCCLUSIONS"),
      countClipped_(makeClip(context, "COUNT")),
      emitClipped_(makeClip(context, "EMIT")),
      prefixSum_(makeProgram(context, "prefix_sum", {{GL_COMPUTE_SHADER, {shaders::kPrefixSumComp}}})),
      tops_(
          makeProgram(context, "disocclusion_tops",
                      {{GL_COMPUTE_SHADER,
                        {shaders::kEpipolarLines, shaders::kEpipolarDisocclusions, shaders::kDisocclusionTopsComp}}})),
      resolveLines_(makeResolve(context, "lines_resolve", shaders::kLinesResolveComp)),
      resolveCamera_(makeResolve(context, "eoc_resolve", shaders::kEocResolveComp)) {}

GlFragments SpanPass::drawLines(const PinholeCamera& base, const EpipolarLines& lines, const GlMesh& mesh) const {
  const GladGLContext& gl = context_.gl();
  const EpipolarUniforms uniforms(context_, base, lines);
  uniforms.bind(context_);
  bindMesh(context_, mesh);
  const Samples samples = drawSpans(base_, mesh, lines.longest(), lines.rowCount());

  GlFragments fragments(context_, lines.longest(), lines.rowCount());
  gl.UseProgram(resolveLines_.id());
  gl.BindTextureUnit(0, samples.depths.id());
  gl.BindTextureUnit(1, samples.indices.id());
  gl.BindImageTexture(0, fragments.texture().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(context_, fragments.width(), fragments.height());
  context_.check("drawing along epipolar lines");
  return fragments;
}

GlFragments SpanPass::draw(const EpipolarCamera& camera, const GlFragments& baseImage, const GlMesh& mesh) const {
  const GladGLContext& gl = context_.gl();
  const EpipolarUniforms uniforms(context_, camera);
  uniforms.bind(context_);
  bindMesh(context_, mesh);
  const int cells = camera.lines().longest() + 1;
  const GlObject tops = makeTexture(context_, GL_R32F, cells, camera.height());
  gl.UseProgram(tops_.id());
  gl.BindImageTexture(0, tops.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  dispatchPixels(context_, cells, camera.height());
  gl.BindTextureUnit(1, tops.id());
  const Samples samples = drawSpans(disocclusions_, mesh, camera.width(), camera.height());

  uniforms.bind(context_);
  GlFragments fragments(context_, camera.width(), camera.height());
  gl.UseProgram(resolveCamera_.id());
  gl.BindTextureUnit(0, samples.depths.id());
  gl.BindTextureUnit(1, samples.indices.id());
  gl.BindTextureUnit(2, baseImage.texture().id());
  gl.BindImageTexture(0, fragments.texture().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(context_, fragments.width(), fragments.height());
  context_.check("drawing an epipolar occlusion camera");
  return fragments;
}

SpanPass::Samples SpanPass::drawSpans(const Target& target, const GlMesh& mesh, int width, int height) const {
  const GladGLContext& gl = context_.gl();
  Samples samples{makeTexture(context_, GL_R32UI, width, height), makeTexture(context_, GL_R32UI, width, height)};
  const uint32_t none = Fragment::kNoTriangle;  // also behind every depth
  gl.ClearTexImage(samples.depths.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  gl.ClearTexImage(samples.indices.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);

  std::vector<Selection> selections;
  const auto triangles = static_cast<uint32_t>(mesh.triangleCount());
  uint32_t most = kCapacity;  // triangles at a time, whose items a list has room for
  for (uint32_t first = 0; first < triangles;) {
    const uint32_t count = std::min(most, triangles - first);
    Selection selection = select(target, first, count);
    if (selection.count > kCapacity) {
      OC_CHECK(count > 1, "a list has room for the blocks of one triangle");
      most = (count + 1) / 2;
      continue;
    }
    selections.push_back(std::move(selection));
    first += count;
  }
  for (const GlObject* program : {&target.depth, &target.index}) {
    gl.UseProgram(program->id());
    const GLenum access = program == &target.depth ? GL_READ_WRITE : GL_READ_ONLY;
    gl.BindImageTexture(0, samples.depths.id(), 0, GL_FALSE, 0, access, GL_R32UI);
    gl.BindImageTexture(1, samples.indices.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    for (const Selection& selection : selections) {
      bindList(gl, kItems, selection.items);
      bindList(gl, kPieces, selection.pieces);
      gl.Uniform1ui(0, 0);
      gl.Uniform1ui(1, selection.count);
      gl.DispatchCompute(groupsOf(selection.count, kGroup), 1, 1);
    }
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  }
  return samples;
}

/// A count above kCapacity where a list overflowed.
SpanPass::Selection SpanPass::select(const Target& target, uint32_t first, uint32_t count) const {
  const GladGLContext& gl = context_.gl();
  struct Counters {
    uint32_t items = 0;
    uint32_t clips = 0;
  };
  Counters counters;
  const GlObject counterBuffer = makeBuffer(context_, sizeof(counters), &counters);
  const GlObject clips = makeBuffer(context_, kCapacity * sizeof(uint32_t));
  Selection selection{makeBuffer(context_, kCapacity * sizeof(glm::uvec2)), makeBuffer(context_, 0), 0};
  const auto run = [&](const GlObject& program, uint32_t from, uint32_t items) {
    gl.UseProgram(program.id());
    bindList(gl, kItems, selection.items);
    bindList(gl, kCounters, counterBuffer);
    bindList(gl, kPieces, selection.pieces);
    gl.Uniform1ui(0, from);
    gl.Uniform1ui(1, items);
    gl.Uniform1ui(2, kCapacity);
    gl.DispatchCompute(groupsOf(items, kGroup), 1, 1);
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    readBuffer(context_, counterBuffer, sizeof(counters), &counters);
  };
  // The list of triangles to be clipped takes the place of the disocclusions, which this does not look at.
  GLint disocclusions = 0;
  gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, kClips, &disocclusions);
  bindList(gl, kClips, clips);
  run(target.selectTriangles, first, count);
  if (counters.clips > 0 && counters.items <= kCapacity) {
    uint32_t pieces = 0;
    selection.pieces = clip(clips, counters.clips, pieces);
    if (pieces > 0) {
      run(target.selectPieces, 0, pieces);
    }
  }
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kClips, static_cast<GLuint>(disocclusions));
  selection.count = counters.items;
  return selection;
}

GlObject SpanPass::clip(const GlObject& triangles, uint32_t count, uint32_t& pieces) const {
  const GladGLContext& gl = context_.gl();
  const GLuint groups = groupsOf(count, PieceSplitter::kClipGroup);
  const GlObject groupCounts = makeBuffer(context_, (groups + 1) * sizeof(glm::uvec4));
  const auto run = [&](const GlObject& program) {
    gl.UseProgram(program.id());
    bindList(gl, kSourceBinding, triangles);
    bindList(gl, kGroupsBinding, groupCounts);
    gl.Uniform1ui(0, 0);
    gl.Uniform1ui(1, count);
    gl.DispatchCompute(groups, 1, 1);
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  };
  run(countClipped_);
  pieces = sumGroups(context_, prefixSum_, groupCounts, groups).y;
  GlObject list = makeBuffer(context_, pieces * kPieceBytes);
  bindList(gl, kChildrenBinding, list);
  run(emitClipped_);
  return list;
}

}  // namespace ocelli
