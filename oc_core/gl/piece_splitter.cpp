#include "oc_core/gl/piece_splitter.h"

#include <algorithm>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/piece_lists.h"
#include "oc_core/render/mesh_blocks.h"

namespace ocelli {
namespace {

// Invocations in a group, as shaders/split_counts.glsl has it; fewer where each keeps a polygon in shared memory.
constexpr GLuint kPieceGroup = 64;
constexpr GLuint kClipGroup = PieceSplitter::kClipGroup;
constexpr uint32_t kPieceCapacity = 1u << 20;  // pieces in a list: 28 MiB

// Bindings of the lists, beside those of piece_lists.h.
constexpr GLuint kLeaves = 4;
constexpr GLuint kCodes = 6;
constexpr GLuint kPieceClips = 7;

}  // namespace

PieceSplitter::PieceSplitter(GlContext& context)
    : context_(context),
      groups_(makeBuffer(context, (groupsOf(kPieceCapacity, kClipGroup) + 1) * sizeof(glm::uvec4))),
      codes_(makeBuffer(context, kPieceCapacity * sizeof(uint32_t))),
      leaves_(makeBuffer(context, kPieceCapacity * kPieceBytes)) {}

void PieceSplitter::draw(const SplitPrograms& programs, const GlMesh& mesh) {
  blocks_ = nullptr;
  drawTriangles(programs, static_cast<uint32_t>(mesh.triangleCount()));
}

void PieceSplitter::drawBlocks(const SplitPrograms& programs, const GlObject& blocks, size_t count) {
  blocks_ = &blocks;
  drawTriangles(programs, static_cast<uint32_t>(count * MeshBlocks::kTriangles));
}

void PieceSplitter::drawTriangles(const SplitPrograms& programs, uint32_t count) {
  programs_ = &programs;
  levels_.clear();  // of a drawing that failed
  leafCount_ = 0;
  levels_.push_back({Level::Kind::kTriangles, 0, {}, 0, count});
  while (!levels_.empty()) {
    if (levels_.back().next < levels_.back().count) {
      splitNext();
    } else {
      if (levels_.back().items) {
        spare_.push_back(std::move(levels_.back().items));
      }
      levels_.pop_back();
    }
  }
  drawLeaves();
}

/// Splits as many of the next items of the deepest level as the lists have room for. Their children become a level of
/// their own, and so do the triangles that are to be clipped.
void PieceSplitter::splitNext() {
  Level& level = levels_.back();
  uint32_t items = std::min(level.count - level.next, kPieceCapacity);
  Counts total = countNext(level, items);
  while (total.leaves > kPieceCapacity || total.children > kPieceCapacity) {
    items = (items + 1) / 2;
    total = countNext(level, items);
  }
  if (leafCount_ + total.leaves > kPieceCapacity) {
    drawLeaves();
  }
  Level children{Level::Kind::kPieces, level.depth + 1, {}, 0, total.children};
  Level clips{Level::Kind::kClips, level.depth, {}, 0, total.clips};
  if (total.leaves + total.children + total.clips > 0) {
    const GladGLContext& gl = context_.gl();
    children.items = takeList();
    clips.items = total.clips > 0 ? takeList() : GlObject();
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kLeaves, leaves_.id());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kChildrenBinding, children.items.id());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kPieceClips, total.clips > 0 ? clips.items.id() : codes_.id());
    const GlObject& program = level.kind == Level::Kind::kTriangles ? programs_->emitTriangles
                              : level.kind == Level::Kind::kPieces  ? programs_->emitPieces
                                                                    : programs_->emitClipped;
    run(program, level, items, leafCount_);
    leafCount_ += total.leaves;
  }
  level.next += items;
  levels_.push_back(std::move(children));
  levels_.push_back(std::move(clips));
}

uint32_t PieceSplitter::groupOf(const Level& level) {
  return level.kind == Level::Kind::kClips ? kClipGroup : kPieceGroup;
}

PieceSplitter::Counts PieceSplitter::countNext(const Level& level, uint32_t items) {
  const GlObject& program = level.kind == Level::Kind::kTriangles ? programs_->decideTriangles
                            : level.kind == Level::Kind::kPieces  ? programs_->decidePieces
                                                                  : programs_->countClipped;
  run(program, level, items, level.depth);
  const glm::uvec4 total = sumGroups(context_, programs_->prefixSum, groups_, groupsOf(items, groupOf(level)));
  return {total.x, total.y, total.z};
}

void PieceSplitter::run(const GlObject& program, const Level& level, uint32_t items, uint32_t argument) {
  const GladGLContext& gl = context_.gl();
  gl.UseProgram(program.id());
  if (level.items) {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kSourceBinding, level.items.id());
  } else if (blocks_ != nullptr) {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kSourceBinding, blocks_->id());
  }
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kGroupsBinding, groups_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kCodes, codes_.id());
  gl.Uniform1ui(0, level.next);
  gl.Uniform1ui(1, items);
  if (level.kind != Level::Kind::kClips) {
    gl.Uniform1ui(2, argument);
  }
  gl.DispatchCompute(groupsOf(items, groupOf(level)), 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

GlObject PieceSplitter::takeList() {
  if (spare_.empty()) {
    return makeBuffer(context_, kPieceCapacity * kPieceBytes);
  }
  GlObject list = std::move(spare_.back());
  spare_.pop_back();
  return list;
}

void PieceSplitter::drawLeaves() {
  if (leafCount_ == 0) {
    return;
  }
  const GladGLContext& gl = context_.gl();
  gl.UseProgram(programs_->drawLeaves.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kLeaves, leaves_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * leafCount_));
  leafCount_ = 0;
}

}  // namespace ocelli
