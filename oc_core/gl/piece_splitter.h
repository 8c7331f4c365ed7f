// Splits the triangles of a mesh until they are about a pixel in size (section 6.1.3), in compute shaders, and draws
// what is left undivided. For SubdivisionPass, which holds the programs of each camera model.
#pragma once

#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

/// The programs that split for one camera model, and draw what is split.
struct SplitPrograms {
  GlObject decideTriangles;
  GlObject decidePieces;
  GlObject emitTriangles;
  GlObject emitPieces;
  GlObject countClipped;
  GlObject emitClipped;
  GlObject prefixSum;
  GlObject drawLeaves;
};

/// Splitting goes depth first, so many pieces at a time: memory is bounded, whatever the scene and the size of the
/// image. It is kept from one drawing to the next.
class PieceSplitter {
 public:
  static constexpr uint32_t kClipGroup = 32;  ///< invocations in a group of shaders/clip.comp

  /// Hold a GlScope, here and below.
  explicit PieceSplitter(GlContext& context);

  /// Draws to the bound framebuffer, with the bound uniforms of the camera; the mesh is bound too (bindMesh()).
  void draw(const SplitPrograms& programs, const GlMesh& mesh);
  /// The same for the triangles of `count` blocks (mesh_blocks.h), whose numbers are listed; for programs that are made
  /// with BLOCKS (shaders/split_codes.glsl).
  void drawBlocks(const SplitPrograms& programs, const GlObject& blocks, size_t count);

 private:
  /// What waits to be split or clipped. Pieces of triangles, but the triangles of the scene at depth 0, and indices of
  /// triangles where they are to be clipped.
  struct Level {
    enum class Kind { kTriangles, kPieces, kClips };
    Kind kind = Kind::kTriangles;
    uint32_t depth = 0;
    GlObject items;
    uint32_t next = 0;
    uint32_t count = 0;
  };
  struct Counts {
    uint32_t leaves = 0;
    uint32_t children = 0;
    uint32_t clips = 0;
  };

  void drawTriangles(const SplitPrograms& programs, uint32_t count);
  static uint32_t groupOf(const Level& level);
  void splitNext();
  Counts countNext(const Level& level, uint32_t items);
  void run(const GlObject& program, const Level& level, uint32_t items, uint32_t argument);
  GlObject takeList();
  void drawLeaves();

  GlContext& context_;
  const SplitPrograms* programs_ = nullptr;  ///< while drawing
  const GlObject* blocks_ = nullptr;         ///< whose triangles are drawn; null for all
  GlObject groups_;
  GlObject codes_;
  GlObject leaves_;
  uint32_t leafCount_ = 0;
  std::vector<Level> levels_;
  std::vector<GlObject> spare_;
};

}  // namespace ocelli
