// Where rays at reference images lose what tracing finds: each lost ray of `ocelli shade`, sorted by what stands in the
// place of the traced hit. Images may be finer than the yardstick, which stays that of 720x480 pixels: so what is lost
// to the spacing of samples is told from what no sample shows.
//
//   before, square   the square of a sample at a rim stands before the traced hit
//   before, skin     a surface between samples does, which is no surface of the scene
//   passed           the ray passes the image's surface at a distance of less than 1.5 footprints from the traced hit
//   not held         the image has no surface within that distance
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/ray_view.h"
#include "oc_core/shade/scene_proxies.h"

namespace ocelli {
namespace {

constexpr int kYardstickWidth = 720;

struct LossesChoice {
  std::string scene = "builtin:mirror";
  bool refracts = false;
  bool ofMiddle = false;
  std::vector<std::string> cameras{"di", "cell"};
  int scale = 1;  ///< of the size of images
};

enum Loss : size_t { kSquareBefore, kSkinBefore, kPassed, kNotHeld, kLosses };

/// A ray that first meets what is cast, and where.
struct TrueHit {
  RayPath path;
  Hit hit;
};

class LossMeter {
 public:
  LossMeter(const LossesChoice& choice, const ShadedScene& scene)
      : choice_(choice),
        scene_(scene),
        senders_(boundsOf(choice.refracts ? scene.lenses : scene.mirrors)),
        reference_(referenceView(scene.cast, senders_, kYardstickWidth, 480), kYardstickWidth, 480) {
    const FirstSurfaces surfaces(scene, choice.refracts ? scene.lenses : scene.mirrors);
    const PinholeCamera picture(pictureView(senders_), kYardstickWidth, 480);
    const SecondaryRays rays = choice.refracts ? refractedRays(surfaces, picture) : reflectedRays(surfaces, picture);
    const glm::vec3 size = senders_.size();
    cell_.shape = ViewCell::Shape::kSphere;
    cell_.sideRadii = std::max({size.x, size.y, size.z});
    const auto fitted = viewOfRays(rays.rays, scene.cast, senders_.center(), kYardstickWidth, 480);
    if (fitted && !choice.ofMiddle) {
      reference_ = PinholeCamera(fitted->view, kYardstickWidth, 480);
      cell_.sideRadii = fitted->cellSide;
    }
    findTrueHits(rays);
    fmt::print("{}: {} rays, {} at the objects; view from ({:.3f}, {:.3f}, {:.3f}), {:.1f} degrees, cell {:.3f}\n",
               choice.scene, rays.rays.size(), trueHits_.size(), reference_.eye().x, reference_.eye().y,
               reference_.eye().z, reference_.view().fovVerticalDegrees, cell_.sideRadii);
  }

  void print(const std::string& camera) const {
    const PinholeCamera reference(reference_.view(), choice_.scale * reference_.width(),
                                  choice_.scale * reference_.height());
    const ReferenceImages images = buildReferenceImages(cameraChoice(camera, cell_), reference, scene_.cast);
    const DepthImageTarget target(images);
    std::vector<uint32_t> sampleOfVertex;
    size_t samples = 0;
    for (const MeshedImages& part : meshEach(images)) {
      sampleOfVertex.insert(sampleOfVertex.end(), part.sampleOfVertex.begin(), part.sampleOfVertex.end());
    }
    for (const ReferenceImage& image : images) {
      samples += image.sampleCount();
    }
    const Mesh& mesh = target.cells().mesh;
    const RayScene surfaces(mesh);
    const RayScene billboards(scene_.billboards);
    std::array<size_t, kLosses> losses{};
    for (const TrueHit& truth : trueHits_) {
      std::optional<Hit> hit = target.hit(truth.path);
      const std::optional<Hit> billboard = billboards.hit(truth.path);
      if (hit && billboard && billboard->t < hit->t) {
        hit.reset();
      }
      const float reach = nearReach(reference_, truth.hit.position);
      if (hit && std::abs(hit->t - truth.hit.t) <= reach) {
        continue;
      }
      if (hit && hit->t < truth.hit.t) {
        const glm::uvec3& t = mesh.triangles[hit->element];
        const bool isSquare = sampleOfVertex[t.x] == sampleOfVertex[t.y] && sampleOfVertex[t.y] == sampleOfVertex[t.z];
        ++losses[isSquare ? kSquareBefore : kSkinBefore];
      } else {
        ++losses[surfaces.hasSurfaceNear(truth.hit.position, reach) ? kPassed : kNotHeld];
      }
    }
    const auto percent = [&](size_t count) {
      return 100 * static_cast<double>(count) / static_cast<double>(trueHits_.size());
    };
    fmt::print("  {:<12} {:>9} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f}\n", camera, samples,
               percent(losses[0] + losses[1] + losses[2] + losses[3]), percent(losses[kSquareBefore]),
               percent(losses[kSkinBefore]), percent(losses[kPassed]), percent(losses[kNotHeld]));
  }

 private:
  void findTrueHits(const SecondaryRays& rays) {
    Mesh all = scene_.cast;
    append(all, scene_.billboards);
    append(all, scene_.surroundings);
    const RayScene truth(all);
    constexpr float kReach = 10;
    for (const SecondaryRay& ray : rays.rays) {
      const RayPath path{ray.origin, ray.origin + ray.direction * kReach};
      const std::optional<Hit> hit = truth.hit(path);
      if (hit && hit->element < scene_.cast.triangles.size()) {
        trueHits_.push_back({path, *hit});
      }
    }
  }

  const LossesChoice& choice_;
  const ShadedScene& scene_;
  Box senders_;
  PinholeCamera reference_;
  ViewCell cell_;
  std::vector<TrueHit> trueHits_;
};

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  ocelli::LossesChoice choice;
  CLI::App app("Why rays at reference images are lost");
  app.add_option("scene", choice.scene)->capture_default_str();
  app.add_flag("--refracts", choice.refracts, "the rays of what refracts, and not of what mirrors");
  app.add_flag("--middle", choice.ofMiddle, "images for the middle of what sends the rays");
  app.add_option("--by", choice.cameras, "cameras of the images")->delimiter(',');
  app.add_option("--scale", choice.scale, "of the sides of the images: 2 for 1440x960 pixels")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const ocelli::ShadedScene scene = ocelli::loadShadedScene(choice.scene, ocelli::rolesFor(choice.scene, ""));
  const ocelli::LossMeter meter(choice, scene);
  fmt::print("  {:<12} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "by", "samples", "lost %", "square", "skin", "passed",
             "not held");
  for (const std::string& camera : choice.cameras) {
    meter.print(camera);
  }
  return 0;
}
