// A representation of one's own: registered under a name, and compared with the depth image.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/worlds/scene_source.h"
#include "ring_representation.h"

using namespace ocelli;

namespace {

/// The share of what `eye` sees of the scene that the mesh of a representation lacks.
double missing(const Mesh& mesh, const Mesh& scene, const PinholeCamera& eye) {
  return countMissing(compareFrames(eye, positionImage(eye, scene), positionImage(eye, mesh))).strictRatio();
}

bool run() {
  registerRepresentation(ringRepresentation());
  // Options of its own stand in a camera file like those of the toolkit.
  std::ofstream("high_ring.json") << R"({"camera": "ring-8", "name": "high ring", "ring_elevation_degrees": 30})";

  const Mesh scene = loadScene("builtin:teapot");
  const PinholeCamera reference(View{}, 360, 360);
  const PinholeCamera fromBehind(View{.eye = {0, 5, -9}}, 360, 360);

  std::printf("missing, seen from behind and above:\n");
  std::vector<double> shares;
  for (const char* name : {"di", "ring-6", "high_ring.json"}) {
    const Representation made = buildRepresentation(cameraChoice(name), reference, scene);
    shares.push_back(missing(made.mesh, scene, fromBehind));
    std::printf("%10s: %5.1f %%, of %zu images and %zu triangles\n", made.name.c_str(), 100 * shares.back(),
                made.images.size(), made.mesh.triangles.size());
    writePly("ring.ply", made.mesh);
    writePng("ring_from_behind.png",
             srgbFromLinear(colorImage(rasterize(fromBehind, made.mesh), made.mesh, glm::vec3(0))));
  }
  return shares[0] > 0.5 && shares[1] < 0.05 && shares[2] < 0.02;
}

}  // namespace

int main() {
  try {
    return run() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const Error& error) {
    std::fprintf(stderr, "add_a_representation: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
