// Rasterisation for the graph camera, frustum by frustum (section 4.1): triangles are clipped with a frustum, projected
// with its matrix and filled, as the image of one frustum is that of a pinhole (straight_segment.h).
//
// A ray meets what its first frustum holds before anything that later ones do, so at each pixel the sample of the
// frustum nearest to the root is kept. Within a frustum the closest fragment wins, the lower triangle index on a tie:
// the same image for any number of threads.
#pragma once

#include <functional>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/mesh_blocks.h"
#include "oc_core/render/ordered_buffer.h"
#include "oc_core/render/region_buffer.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// The closest fragment along the ray of each pixel; both sides of triangles are drawn.
FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh);
/// The same, of a mesh that is drawn more than once: `blocks` are its own.
FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks);

/// Calls `visit(run)` for all samples of that image, from several threads at once, each pixel once, and leaves out how
/// far away they are, which is a third of the work: for pictures of scenes of which all lies before zFar.
void visitSamples(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks,
                  const std::function<void(const RegionBuffer::SampleRun& run)>& visit);
/// Whether nothing within `bounds`, which is not empty, is at zFar or beyond for sure, along any ray. A ray that bends
/// at c, away from a viewpoint v, goes straight from v through c: so it is no longer than the way over the viewpoints.
bool endsBeforeZFar(const GraphCamera& camera, const Box& bounds);

/// The two steps of it, for those who draw a mesh part by part: the nearest of what each part leaves in a buffer is the
/// image of all. The mesh of the second is the one whose triangles the buffer names.
OrderedBuffer drawOrdered(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks);
FragmentImage fragmentsOf(const GraphCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh);

}  // namespace ocelli
