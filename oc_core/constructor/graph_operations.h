// Graph cameras made by hand: a list of bend, split, merge and limit operations (section 4.1) as JSON, in which frusta
// have names.
//
//   {"camera": "graph", "view": {...}, "size": {"width": 1280, "height": 720}, "overlap": "refused",
//    "operations": [
//      {"operation": "bend", "of": "root", "into": {"name": "street", "plane": {...}, "viewpoint": [x, y, z],
//       "part": [[0, 0], [0.5, 0], [0.5, 1], [0, 1]]}},
//      {"operation": "split", "of": "street", "into": [{"name": "left", ...}, {"name": "right", ...}]},
//      {"operation": "merge", "of": ["left", "right"], "into": {"name": "behind", ...}},
//      {"operation": "limit", "of": "behind", "plane": {...}}]}
//
// The view is that of the root (oc_core/camera/view.schema.json), the user's where it is missing. The size, which may
// be missing, is the shape of the images that parts are shares of. With an overlap "allowed" frusta may overlap, such
// as behind walls that hide it.
//
// A plane is {"point": [x, y, z], "normal": [x, y, z]}; its normal points the way that rays run. A part is a convex
// polygon, clockwise as seen, in shares of the image's width and height. Operations may stand in any order.
//
// What a merge makes is one viewpoint for the rays of two frusta, and goes by one name: what is done to it is done to
// both sub-frusta, which the camera calls "behind of left" and "behind of right".
#pragma once

#include <string>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class JsonFields;

/// Reads the fields above but for "camera". Throws InputError, naming the operation and the field or the frusta, for
/// what cannot be read, for names that are unknown or given twice, for frusta that come from each other in a circle,
/// and for such as overlap within `world`, the bounds of the scene; and where GraphCamera does. Where `world` is empty,
/// overlaps are not looked for.
GraphCamera readGraphCamera(JsonFields& fields, const PinholeCamera& reference, const Box& world = {});

/// The same as JSON text, its root's view with it: each frustum as a bend of its parent. Overlaps are allowed.
std::string jsonText(const GraphCamera& camera);

}  // namespace ocelli
