// A camera of one's own: checked, registered under a name, and used like those of the toolkit.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "fisheye_camera.h"
#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/cast_representation.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/worlds/scene_source.h"

using namespace ocelli;

namespace {

/// The contract of oc_core/camera/camera.h, over a grid of pixels and parameters: the farthest that project() comes out
/// beside the pixel whose point it gets, and the farthest that unproject() comes out beside the ray.
struct ContractErrors {
  float pixels = 0;
  float world = 0;
};

ContractErrors checkContract(const FisheyeCamera& camera) {
  ContractErrors worst;
  for (int y = 0; y < camera.height(); y += 7) {
    for (int x = 0; x < camera.width(); x += 7) {
      const glm::vec2 pixel(float(x) + 0.5f, float(y) + 0.5f);
      const RayPath ray = camera.rayPath(pixel);
      for (const float t : {0.1f, 1.0f, 30.0f}) {
        const auto point = camera.unproject({pixel.x, pixel.y, t});
        if (point.has_value() == ray.empty()) {
          return {1e9f, 1e9f};  // a pixel has both, or neither
        }
        if (point) {
          const auto back = camera.project(*point);
          worst.pixels = std::max(worst.pixels, back ? glm::distance(pixel, {back->u, back->v}) : 1e9f);
          worst.world = std::max(worst.world, glm::distance(*point, ray.pointAt(ray.positionAt(t))));
        }
      }
    }
  }
  return worst;
}

/// The share of samples that come out at the same place of the world, within a hundredth of their distance.
double shareThatAgrees(const ReferenceImage& before, const ReferenceImage& after) {
  const PinholeCamera pinhole = before.reference();
  size_t agree = 0;
  for (int y = 0; y < before.height(); ++y) {
    for (int x = 0; x < before.width(); ++x) {
      const auto a = before.pointOf(x, y, pinhole);
      const auto b = after.pointOf(x, y, pinhole);
      agree += a && b && glm::distance(*a, *b) < 0.01f * glm::distance(*a, pinhole.eye());
    }
  }
  return double(agree) / double(before.sampleCount());
}

bool run() {
  registerRepresentation(
      castRepresentation("fisheye", "half of all directions, equidistant, as a disc",
                         [](const RepresentationInputs& in) { return FisheyeCamera(in.reference); }));

  // Above a crossing of the town, which is fitted into the unit sphere.
  const View street{.eye = {0, 0.04f, 0}, .target = {0, 0.04f, -1}, .fovVerticalDegrees = 60, .zNear = 0.001f};
  const PinholeCamera reference(street, 480, 480);
  const ContractErrors errors = checkContract(FisheyeCamera(reference));

  const CameraChoice fisheye = cameraChoice("fisheye");
  const ReferenceImages images = buildReferenceImages(fisheye, reference, loadScene("builtin:town"));
  const Mesh mesh = unionMesh(images);
  writePng("fisheye.png", srgbFromLinear(images.front().color));
  writePly("fisheye.ply", mesh);

  // From its own eye the mesh looks like the scene that it stands for.
  const ReferenceImages again = buildReferenceImages(fisheye, reference, mesh);
  const double agreement = shareThatAgrees(images.front(), again.front());

  std::printf("contract: within %.5f pixels, and %.5f of the rays\n", double(errors.pixels), double(errors.world));
  std::printf("fisheye.png: %zu samples; fisheye.ply: %zu triangles\n", images.front().sampleCount(),
              mesh.triangles.size());
  std::printf("seen again by the fisheye, %.2f %% of the samples are where they were\n", 100 * agreement);
  // Points 30 away are floats with steps of 2e-6, the ends of rays, 1000 away, with steps of 6e-5.
  return errors.pixels < 0.01f && errors.world < 1e-3f && agreement > 0.99;
}

}  // namespace

int main() {
  try {
    return run() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const Error& error) {
    std::fprintf(stderr, "add_a_camera: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
