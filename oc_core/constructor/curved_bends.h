// Curved ray cameras made by hand (section 4.3.2.1): a list of bends as JSON.
//
//   {"camera": "curved", "view": {...}, "size": {"width": 1280, "height": 720}, "arcs": "conic",
//    "turns": [
//      {"name": "into the street", "from": {...}, "middle": {...}, "to": {...}, "viewpoint": [x, y, z]}]}
//
// The view is that of the root (oc_core/camera/view.schema.json), the user's where it is missing. The size, which may
// be missing, is the shape of the images that it is made for. Arcs are "conic", or "bezier" as in the text's first
// model. The planes of the transition (ray_transition.h) are {"point": [x, y, z], "normal": [x, y, z]}, meet in a line,
// and their normals point the way that rays run. Rays pass the bends in the order of the list. Names are for people.
#pragma once

#include <string>

#include "oc_core/camera/curved_ray_camera.h"

namespace ocelli {

class JsonFields;

/// Reads the fields above but for "camera". Throws InputError, naming the bend and the field, for what cannot be read,
/// and where CurvedRayCamera does.
CurvedRayCamera readCurvedRayCamera(JsonFields& fields, const PinholeCamera& reference);

/// The same as JSON text, its root's view with it.
std::string jsonText(const CurvedRayCamera& camera);

}  // namespace ocelli
