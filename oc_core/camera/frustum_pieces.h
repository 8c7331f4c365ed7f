// What a frustum of a graph camera holds, as convex pieces: beyond its plane, within the pyramid of a part of the image
// from its viewpoint, up to the plane of the child that takes the rays of that part, or, where none does, up to its
// limits. zFar ends no piece: it is no plane behind a bend.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"

namespace ocelli {

struct FrustumPiece {
  int frustum = GraphCamera::kRoot;
  int child = -1;              ///< its rays go on to; -1 for none
  std::vector<Plane> sides{};  ///< normals point out of it
};

std::vector<FrustumPiece> piecesOf(const GraphCamera& camera, int frustum);
/// Of all frusta, in their order.
std::vector<FrustumPiece> piecesOf(const GraphCamera& camera);

}  // namespace ocelli
