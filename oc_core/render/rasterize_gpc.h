// Feed-forward rasterisation for the general pinhole camera (section 5.2.1.3), piece by piece: its rays are those of a
// pinhole, so every triangle is projected as by a pinhole, and only where the samples bend is anything else done.
//
// Around the regions the image is the pinhole's, and inside of a region it is that of a pinhole that zooms: straight
// edges stay straight, and triangles are filled as ever. In a transition so are triangles whose edges stray from
// straight ones by less than 1/64 pixel, which a bound at their corners tells (gpc_raster_zone.h). For the others each
// pixel that may be covered evaluates the triangle's edges where its sample lies in the pinhole's image: exact, without
// subdivision. Each pixel belongs to one of these parts, by its centre, and within each neighbouring triangles leave no
// gap. In transitions both triangles at an edge draw the pixels within a chord of it: the nearer one shows, as ever,
// and of two as near the first.
#pragma once

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/projected_mesh.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {

/// The closest fragment at each pixel of `camera`; both sides of triangles are drawn.
FragmentImage rasterizeGpc(const GpcCamera& camera, const Mesh& mesh);
/// The same for a mesh that was projected by the camera's reference.
FragmentImage rasterizeGpc(const GpcCamera& camera, const ProjectedMesh& projected);
/// The same without straight edges in transitions: each pixel there is tried where its sample lies. Slower; what the
/// others are tested against.
FragmentImage rasterizeGpcExactly(const GpcCamera& camera, const ProjectedMesh& projected);

/// With which subdivision (rasterize_subdivided.h) draws this camera without tearing what it zooms.
SubdivisionOptions gpcSubdivision(const GpcCamera& camera);

}  // namespace ocelli
