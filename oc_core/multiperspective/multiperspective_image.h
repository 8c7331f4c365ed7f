// Images of graph and curved ray cameras: what is drawn of them, and the EXR files that hold them.
//
// The file: OpenEXR, channels R G B (linear), Z (along the ray, graph_camera.h; 0 where nothing is seen), P.X P.Y P.Z
// (the world point of the sample) and "object" (a whole number: which object is seen, 0 for structure, 2^32 - 1 for
// nothing); the camera as JSON, as `--camera` takes it, in the text attribute "ocelli".
#pragma once

#include <filesystem>

#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// What images show where nothing is seen: a light sky, linear.
glm::vec3 skyColor();

/// Draws by projection and rasterisation (section 4.1, 4.4.2).
FragmentImage rasterize(const MultiperspectiveCamera& camera, const Mesh& mesh);
/// Follows the rays: the reference for all others.
FragmentImage raycast(const MultiperspectiveCamera& camera, const Mesh& mesh);
/// By another renderer of the mesh, such as a GPU's.
FragmentImage draw(const MultiperspectiveCamera& camera, const SceneRenderer& renderer);

/// Throws WorkError where the file cannot be written. `fragments` are of the mesh of `scene`.
void writeMultiperspectiveImage(const std::filesystem::path& path, const FragmentImage& fragments,
                                const GuidedScene& scene, const MultiperspectiveCamera& camera);

}  // namespace ocelli
