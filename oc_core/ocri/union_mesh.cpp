#include "oc_core/ocri/union_mesh.h"

#include <utility>

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/layered_mesh.h"
#include "oc_core/ocri/row_mesh.h"

namespace ocelli {
namespace {

/// Less leaves holes in grazing surfaces, more lets squares stand out: measured on builtin:room with four viewers.
constexpr float kDeepestSquareFromAside = 2;

/// Calls `body(first, end, options)` for each range of images that is meshed as one.
template <class Body>
void forMeshedRanges(const ReferenceImages& images, const Body& body) {
  for (size_t first = 0; first < images.size();) {
    size_t end = first + 1;
    while (end < images.size() && images[end].layer > 0) {
      ++end;
    }
    ImageMeshOptions options;
    if (images[first].seenFromAside) {
      options.deepestSquareFootprints = kDeepestSquareFromAside;
    }
    body(first, end, options);
    first = end;
  }
}

Mesh meshOfRange(const ReferenceImages& images, size_t first, size_t end, const ImageMeshOptions& options,
                 std::vector<uint32_t>* sampleOfVertex) {
  const auto part = images.begin() + static_cast<std::ptrdiff_t>(first);
  if (end - first > 1) {
    return layeredMesh({part, part + static_cast<std::ptrdiff_t>(end - first)}, options, sampleOfVertex);
  }
  return part->rows == ImageRows::kAligned ? imageMesh(*part, options, sampleOfVertex)
                                           : rowMesh(*part, options, sampleOfVertex);
}

}  // namespace

Mesh unionMesh(const ReferenceImages& images) {
  Mesh mesh;
  forMeshedRanges(images, [&](size_t first, size_t end, const ImageMeshOptions& options) {
    Mesh part = meshOfRange(images, first, end, options, nullptr);
    if (mesh.positions.empty()) {
      mesh = std::move(part);
    } else {
      append(mesh, part);
    }
  });
  return mesh;
}

std::vector<MeshedImages> meshEach(const ReferenceImages& images) {
  std::vector<MeshedImages> parts;
  forMeshedRanges(images, [&](size_t first, size_t end, const ImageMeshOptions& options) {
    MeshedImages part{first, end, {}, {}};
    part.mesh = meshOfRange(images, first, end, options, &part.sampleOfVertex);
    parts.push_back(std::move(part));
  });
  return parts;
}

}  // namespace ocelli
