// How many bytes a representation takes: as it lies in memory, and compressed with zstd.
#pragma once

#include <cstddef>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct StoredSize {
  size_t raw = 0;
  size_t compressed = 0;  ///< zstd at level 3, each array by itself

  StoredSize& operator+=(const StoredSize& other);
};

/// The colours, depths and displacements of every pixel, as 32-bit floats. Displacements that are all zero (those of a
/// pinhole) are left out, as their pixels say where samples are.
StoredSize storedSize(const ReferenceImage& image);
/// Positions and colours as 32-bit floats, triangles as three 32-bit indices.
StoredSize storedSize(const Mesh& mesh);

}  // namespace ocelli
