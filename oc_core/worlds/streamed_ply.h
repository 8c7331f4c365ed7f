// PLY files whose mesh does not fit into memory, as parts for packScene() (oc_core/pack).
#pragma once

#include <filesystem>
#include <memory>

#include "oc_core/base/progress.h"
#include "oc_core/pack/triangle_source.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// The triangles of a file in its order, fitted and shaded as loadScene() does it, a million at a time.
///
/// DEVIATION: at a crease, a vertex of which some face is farther than kCreaseDegrees from its normal, each corner
/// takes the shade of its face alone, not of all faces on its side of the crease. Without creases both are the same.
class StreamedPly final : public TriangleSource {
 public:
  /// Most triangles of a file, and vertices: those of an index of 32 bits.
  static constexpr uint64_t kMaxTriangles = 1'400'000'000;

  /// Reads the file once, and keeps 12 bytes a triangle and up to 36 bytes a vertex of it in files without a name in
  /// `scratch`, and two bits a vertex in memory. Throws InputError as readPly() and unitFromWorld() do, WorkError where
  /// the disk is full, and what `progress` throws.
  StreamedPly(const std::filesystem::path& path, const SceneOptions& options, const std::filesystem::path& scratch,
              const Progress& progress = {});
  ~StreamedPly() override;

  void forEachPart(const std::function<void(const Mesh& part)>& visit) const override;

 private:
  struct Arrays;
  std::unique_ptr<Arrays> arrays_;
  Shading shading_;
};

}  // namespace ocelli
