// A reflecting object in a maze (section 4.3.4.3, Figure 4.28): each reflected ray is intersected with one depth image
// of a graph camera that sees the whole maze: frustum by frustum, and through a pyramid over its samples; and, to
// compare, with the maze itself.
//
// Writes both images side by side, and prints how far apart they are and what a ray costs in steps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/base/error.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/depth_rays/graph_depth_image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/teapot.h"

namespace ocelli {
namespace {

constexpr glm::vec3 kBackground(0.05f);

struct DemoChoice {
  std::string scene = "builtin:maze,seed=1";
  std::string object = "teapot";
  std::filesystem::path image = "reflection.png";
  int row = 3;
  int column = 3;
  double turnDegrees = 30;
  double distance = 1.1;
  int depthWidth = 1920;
  int depthHeight = 1200;
  int size = 480;
};

/// A mesh with a normal at each vertex.
struct Reflector {
  Mesh mesh;
  std::vector<glm::vec3> normals;

  glm::vec3 normalAt(const Fragment& f) const {
    const glm::uvec3& t = mesh.triangles[f.triangle];
    return glm::normalize(normals[t.x] * (1 - f.b1 - f.b2) + normals[t.y] * f.b1 + normals[t.z] * f.b2);
  }
};

Reflector makeReflector(const std::string& object, const glm::vec3& place, float height) {
  const bool isTeapot = object == "teapot";
  const Mesh own = isTeapot ? makeTeapot(24) : makeSphere(128);
  const Box bounds = boundsOf(own);
  const float scale = height / bounds.size().y;
  Reflector reflector;
  append(reflector.mesh, own,
         glm::translate(glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(scale)),
                        -glm::vec3(bounds.center().x, bounds.lower.y, bounds.center().z)));
  reflector.normals.resize(reflector.mesh.positions.size());
  for (const glm::uvec3& t : reflector.mesh.triangles) {
    const glm::vec3& a = reflector.mesh.positions[t.x];
    const glm::vec3 normal = glm::cross(reflector.mesh.positions[t.y] - a, reflector.mesh.positions[t.z] - a);
    for (int k = 0; k < 3; ++k) {
      reflector.normals[t[k]] += normal;
    }
  }
  return reflector;
}

/// What rays see: a colour, or nothing.
struct Images {
  Image<glm::vec3> truth;
  Image<glm::vec3> approximation;
};

struct Tally {
  size_t rays = 0;
  size_t seen = 0;   ///< by the camera, where they meet the maze
  size_t right = 0;  ///< of these, those that meet the image within 5 cm of there
  double difference = 0;
  size_t fine = 0;
  size_t coarse = 0;
  double milliseconds = 0;
  size_t pyramidRight = 0;  ///< as `right`, by the pyramid
  RayCost pyramid;
  double pyramidMilliseconds = 0;
};

class Demo {
 public:
  Demo(const DemoChoice& choice, const GuidedScene& scene, const GraphCamera& camera)
      : scene_(scene),
        fragments_(rasterize(camera, scene.mesh)),
        depthImage_(camera, fragments_),
        samples_({placedImage(camera, fragments_, scene.mesh, camera.root().view(), "graph camera")}),
        sceneRays_(scene.mesh),
        reflector_(makeReflector(choice.object, floorOf(choice), 0.22f * scene.guides.maze->cellSize)),
        objectRays_(reflector_.mesh),
        pinhole_(viewOf(choice), choice.size, choice.size),
        images_{Image<glm::vec3>(choice.size, choice.size, kBackground),
                Image<glm::vec3>(choice.size, choice.size, kBackground)} {}

  void draw() {
    for (int y = 0; y < pinhole_.height(); ++y) {
      for (int x = 0; x < pinhole_.width(); ++x) {
        drawPixel(x, y);
      }
    }
  }
  const Tally& tally() const { return tally_; }
  const GraphCamera& camera() const { return depthImage_.camera(); }

  Image<glm::vec3> sideBySide() const {
    Image<glm::vec3> both(2 * pinhole_.width(), pinhole_.height());
    for (int y = 0; y < pinhole_.height(); ++y) {
      for (int x = 0; x < pinhole_.width(); ++x) {
        both(x, y) = images_.approximation(x, y);
        both(x + pinhole_.width(), y) = images_.truth(x, y);
      }
    }
    return both;
  }

 private:
  glm::vec3 floorOf(const DemoChoice& choice) const {
    return scene_.guides.maze->centerOf({choice.row, choice.column});
  }
  View viewOf(const DemoChoice& choice) const {
    const Box bounds = boundsOf(reflector_.mesh);
    const double angle = radiansFromDegrees(choice.turnDegrees);
    View view;
    view.target = bounds.center();
    view.eye = view.target + static_cast<float>(choice.distance) * glm::vec3(std::sin(angle), 0.5, std::cos(angle));
    view.fovVerticalDegrees = 60;
    return view;
  }

  void drawPixel(int x, int y) {
    const RayPath path = pinhole_.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
    const Fragment object = objectRays_.intersect(path);
    const Fragment wall = sceneRays_.intersect(path);
    const auto distance = [&](const glm::vec3& p) { return glm::distance(p, path.front()); };
    if (object.covered() &&
        (!wall.covered() || distance(positionOf(object, reflector_.mesh)) < distance(positionOf(wall, scene_.mesh)))) {
      reflect(x, y, object, glm::normalize(path.back() - path.front()));
    } else if (wall.covered()) {
      images_.truth(x, y) = images_.approximation(x, y) = colorOf(wall, scene_.mesh);
    }
  }

  void reflect(int x, int y, const Fragment& object, const glm::vec3& incoming) {
    const glm::vec3 normal = glm::faceforward(reflector_.normalAt(object), incoming, reflector_.normalAt(object));
    const glm::vec3 direction = glm::reflect(incoming, normal);
    const glm::vec3 origin = positionOf(object, reflector_.mesh) + normal * 1e-3f;
    ++tally_.rays;
    const Fragment truth = sceneRays_.intersect({origin, origin + direction * 1e3f});
    const glm::vec3 meets = truth.covered() ? positionOf(truth, scene_.mesh) : glm::vec3(0);
    if (truth.covered()) {
      images_.truth(x, y) = colorOf(truth, scene_.mesh);
    }
    depthImage_.intersect(glm::dvec3(origin), glm::dvec3(direction), {0.05, false}, &tally_.fine);
    const auto start = std::chrono::steady_clock::now();
    const auto hit = depthImage_.intersect(glm::dvec3(origin), glm::dvec3(direction), {0.05, true}, &tally_.coarse);
    tally_.milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const auto pyramidStart = std::chrono::steady_clock::now();
    const auto sample = samples_.hit({origin, origin + direction * 1e3f}, tally_.pyramid);
    tally_.pyramidMilliseconds +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - pyramidStart).count();
    if (hit) {
      const auto at = glm::clamp(glm::ivec2(hit->place), glm::ivec2(0),
                                 glm::ivec2(fragments_.width() - 1, fragments_.height() - 1));
      const Fragment& seen = fragments_(at.x, at.y);
      images_.approximation(x, y) = seen.covered() ? colorOf(seen, scene_.mesh) : kBackground;
    }
    if (truth.covered() && isSeen(meets)) {
      ++tally_.seen;
      tally_.pyramidRight += sample && std::abs(sample->t - glm::distance(origin, meets)) < 0.05f;
      tally_.right += hit && std::abs(hit->distance - static_cast<double>(glm::distance(origin, meets))) < 0.05;
    }
    const glm::vec3 apart = glm::abs(images_.truth(x, y) - images_.approximation(x, y));
    tally_.difference += static_cast<double>(apart.x + apart.y + apart.z) / 3;
  }

  /// Whether a point of the maze is the first that the camera's ray to it meets.
  bool isSeen(const glm::vec3& point) const {
    const auto q = camera().project(point);
    const Fragment seen = q ? sceneRays_.intersect(camera().rayPath({q->u, q->v})) : Fragment{};
    return seen.covered() && glm::distance(positionOf(seen, scene_.mesh), point) < 0.01f;
  }

  const GuidedScene& scene_;
  FragmentImage fragments_;
  GraphDepthImage depthImage_;
  DepthImageTarget samples_;
  RayScene sceneRays_;
  Reflector reflector_;
  RayScene objectRays_;
  PinholeCamera pinhole_;
  Images images_;
  Tally tally_;
};

void run(const DemoChoice& choice) {
  SceneOptions options;
  options.fit = false;
  const GuidedScene scene = loadGuidedScene(choice.scene, options);
  if (!scene.guides.maze || !scene.guides.maze->contains({choice.row, choice.column})) {
    throw InputError("the scene has no maze with that cell", choice.scene, "choose a builtin:maze and a cell of it");
  }
  const GraphCamera camera = makeComprehensiveCamera(*scene.guides.maze, {}, choice.depthWidth, choice.depthHeight);
  const Box bounds = boundsOf(scene.mesh);
  fmt::print("{} frusta, {} pairs of them overlap\n", camera.frusta().size(),
             overlapsOf(camera, glm::dvec3(bounds.lower), glm::dvec3(bounds.upper)).size());
  Demo demo(choice, scene, camera);
  demo.draw();
  const Tally& tally = demo.tally();
  const auto rays = static_cast<double>(tally.rays);
  fmt::print("{} reflected rays, of which {:.1f} % meet what the camera sees; {:.1f} % of these found it within 5 cm\n",
             tally.rays, 100 * static_cast<double>(tally.seen) / rays,
             100 * static_cast<double>(tally.right) / static_cast<double>(tally.seen));
  fmt::print("mean colour difference {:.4f} (linear, of 1)\n", tally.difference / rays);
  fmt::print("steps a ray: {:.1f} pixel by pixel, {:.1f} with tiles; {:.1f} us a ray\n",
             static_cast<double>(tally.fine) / rays, static_cast<double>(tally.coarse) / rays,
             1000 * tally.milliseconds / rays);
  fmt::print("pyramid: {:.1f} % found within 5 cm, {:.1f} steps a ray and {:.1f} boxes; {:.1f} us a ray\n",
             100 * static_cast<double>(tally.pyramidRight) / static_cast<double>(tally.seen),
             static_cast<double>(tally.pyramid.steps()) / rays, static_cast<double>(tally.pyramid.boxes) / rays,
             1000 * tally.pyramidMilliseconds / rays);
  writePng(choice.image, srgbFromLinear(demo.sideBySide()));
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  ocelli::DemoChoice choice;
  CLI::App app("A reflecting object in a maze, by a graph camera's depth image and by ray tracing");
  app.add_option("--scene", choice.scene, "a maze")->capture_default_str();
  app.add_option("--object", choice.object, "what reflects")
      ->check(CLI::IsMember({"teapot", "ball"}))
      ->capture_default_str();
  app.add_option("--row", choice.row, "of the cell where it stands")->capture_default_str();
  app.add_option("--column", choice.column, "of the cell where it stands")->capture_default_str();
  app.add_option("--turn", choice.turnDegrees, "from which side it is seen, degrees")->capture_default_str();
  app.add_option("--distance", choice.distance, "from which it is seen")->capture_default_str();
  app.add_option("--depth-width", choice.depthWidth, "of the depth image")->capture_default_str();
  app.add_option("--depth-height", choice.depthHeight, "of the depth image")->capture_default_str();
  app.add_option("--size", choice.size, "of the image, a side")->capture_default_str();
  app.add_option("--picture", choice.image, "PNG: depth image to the left, ray tracing to the right")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    ocelli::run(choice);
  } catch (const ocelli::Error& error) {
    fmt::print(stderr, "graph_reflection_demo: {}\n", error.what());
    return 1;
  }
  return 0;
}
