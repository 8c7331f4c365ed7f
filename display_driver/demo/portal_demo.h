// Someone who walks in a scene, on the demo's page: what a pinhole shows from there, and what a graph camera does whose
// rays turn in openings to look straight in (section 4.3.1.1).
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>

#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// Where someone stands, in the coordinates of the scene, which is not fitted, and what he sees.
struct PortalDemoView {
  glm::vec3 eye{0};
  glm::vec3 target{0, 0, -1};
  std::string place;        ///< "A corridor": what he stands in
  std::string seen;         ///< a sentence: what the pinhole shows
  std::string seenBesides;  ///< a sentence: what the graph camera shows
};

/// `source` as loadScene() takes it; the scene must know its portals. Writes the images below `folder`/`name`. The
/// scene that it gives has rows, and no figures. Throws what the rooms throw.
DemoScene runPortalDemo(const std::string& title, const std::string& source, const PortalDemoView& view,
                        const std::filesystem::path& folder, const std::string& name, const DemoOptions& options,
                        const Progress& progress);

}  // namespace ocelli
