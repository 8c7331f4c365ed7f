#include "display_driver/demo/portal_demo.h"

#include "display_driver/demo/demo_folder.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/image/color.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr double kPortalDemoFovDegrees = 50;
// Metres.
constexpr float kPortalDemoNear = 0.05f;
constexpr float kPortalDemoFar = 1000;
const glm::vec3 kPortalDemoSky = linearFromSrgb({0.8f, 0.87f, 0.95f});

}  // namespace

DemoScene runPortalDemo(const std::string& title, const std::string& source, const PortalDemoView& view,
                        const std::filesystem::path& folder, const std::string& name, const DemoOptions& options,
                        const Progress& progress) {
  const DemoFolder images(folder, name);
  const GuidedScene walked = loadGuidedScene(source, {.fit = false}, progress);
  const PinholeCamera pinhole(View{.eye = view.eye,
                                   .target = view.target,
                                   .fovVerticalDegrees = kPortalDemoFovDegrees,
                                   .zNear = kPortalDemoNear,
                                   .zFar = kPortalDemoFar},
                              options.width, options.height);
  const GraphCamera graph = buildPortalCamera({}, walked.guides, pinhole);
  const auto write = [&](const std::string& file, const FragmentImage& seen, const std::string& what,
                         const std::string& caption) {
    return images.write(file, colorImage(seen, walked.mesh, kPortalDemoSky), what, caption);
  };
  DemoScene scene;
  scene.title = title;
  scene.source = source;
  scene.geometryTriangles = walked.mesh.triangles.size();
  scene.rows.push_back({"Walk in: " + view.place,
                        "A graph camera joins several pinholes in one image without a gap. Here its rays turn in doors "
                        "and mouths of streets to look straight in, so that someone who walks by sees what is there "
                        "without going to look.",
                        {write("pinhole", rasterize(pinhole, walked.mesh), "Pinhole", view.seen),
                         write("graph", rasterize(graph, walked.mesh), "Graph camera", view.seenBesides)}});
  return scene;
}

}  // namespace ocelli
