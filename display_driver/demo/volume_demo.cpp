#include "display_driver/demo/volume_demo.h"

#include "display_driver/demo/demo_folder.h"
#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {
namespace {

// Coordinates of a fitted scene, in the sphere of radius 1.
constexpr double kOpenAbove = 0.2;
constexpr double kFovDegrees = 6;
const glm::vec3 kAbove(0, 4.6f, 8.8f);

/// As docs/cameras/examples/skull_curved.json: rays of the view that pass over the front bend down behind it.
CurvedRayCamera bentOver(const PinholeCamera& view) {
  const glm::dvec3 line(0, -1, 0.3);
  constexpr double kTilt = 0.08;
  CurvedRayCamera camera(view);
  camera.bend(
      {Plane::through(line, {0, kTilt, -1}), Plane::through(line, {0, 0, -1}), Plane::through(line, {0, -kTilt, -1})},
      {0, 4.7, 9});
  return camera;
}

}  // namespace

DemoScene runVolumeDemo(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                        const std::string& name, const DemoOptions& options, const Progress& progress) {
  const DemoFolder images(folder, name);
  const VolumeRenderer renderer(
      loadVolumeScene(source, {.clips = {{.normal = {0, -1, 0}, .distance = -kOpenAbove}}}, progress));
  const PinholeCamera front(View{.fovVerticalDegrees = kFovDegrees}, options.width, options.height);
  const PinholeCamera above(View{.eye = kAbove, .fovVerticalDegrees = kFovDegrees}, options.width, options.height);
  const auto write = [&](const std::string& file, const auto& camera, const std::string& what,
                         const std::string& caption) {
    return images.write(file, imageBefore(glm::vec3(0), renderVolume(camera, renderer, progress)), what, caption);
  };
  DemoScene scene;
  scene.title = title;
  scene.source = source;
  scene.rows.push_back(
      {"A volume along bent rays",
       "Not triangles but a field of numbers, as scanners give: light is gained and lost along each ray. What is above "
       "a "
       "plane is taken away. A curved ray camera sees the front as the pinhole does, and over it into the inside: its "
       "rays run straight up to the front, and bend down behind it.",
       {write("front", front, "Pinhole in front", "The inside is hidden."),
        write("above", above, "Pinhole above", "The inside shows; the front is seen from above, too."),
        write("curved", bentOver(front), "Curved ray camera", "The front and the inside, in one image.")}});
  return scene;
}

}  // namespace ocelli
