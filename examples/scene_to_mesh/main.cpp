// Scene, camera, reference image, bounded mesh: the whole way in a few lines.
#include <cstdio>

#include "oc_core/image/png_file.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/worlds/scene_source.h"

int main() {
  using namespace ocelli;
  const Mesh scene = loadScene("builtin:fence");     // or a file: "bunny.obj"
  const PinholeCamera reference(View{}, 720, 480);   // the default view, from (0, 0, 10)
  const CameraChoice camera = cameraChoice("ddoc");  // what `--camera` takes
  const ReferenceImages images = buildReferenceImages(camera, reference, scene);
  const Mesh mesh = unionMesh(images);
  writePng("scene_to_mesh.png", srgbFromLinear(images.front().color));
  writePly("scene_to_mesh.ply", mesh);
  std::printf("%zu triangles of the scene became %zu samples and %zu triangles\n", scene.triangles.size(),
              images.front().sampleCount(), mesh.triangles.size());
}
