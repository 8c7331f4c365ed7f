// Rasterisation for the curved ray camera (section 4.2.2): before, between and behind its bends rays are straight, and
// one matrix each projects what lies there (straight_segment.h); what lies in a bend is split until its pieces come out
// straight (bend_rasterizer.h).
//
// A ray passes segment, bend, segment and so on, so at each pixel the sample of the first of these is kept.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/mesh_blocks.h"
#include "oc_core/render/ordered_buffer.h"

namespace ocelli {

/// The closest fragment along the ray of each pixel; both sides of triangles are drawn.
FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh);
/// The same, of a mesh that is drawn more than once: `blocks` are its own.
FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks);

/// The two steps of it, as rasterize_graph.h has them.
OrderedBuffer drawOrdered(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks);
FragmentImage fragmentsOf(const CurvedRayCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh);

}  // namespace ocelli
