// A folder that a browser opens without a server and without a network: a walk through a sea of images (section 3.5.4).
//
//   index.html, *.css, *.js   the page (WebGL2)
//   sea.js                    "ocelliSea.open(JSON);": title, spacing, places and their axes, the proxy
//   images/NNNNN.js           "ocelliSea.take(N, \"data:image/jpeg;base64,...\");": the image of place N, from 0
//
// Images stand in scripts because browsers keep pages of files from reading the pixels of image files.
//
// From a place between the images the page blends those of the three nearest, weighted by barycentric coordinates; with
// a proxy each is looked up where its ray meets that box.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// Where an image was taken: all directions, equirectangular (camera/panorama_camera.h). `forward` is in its middle.
struct SeaPagePlace {
  glm::dvec3 eye{0};
  glm::dvec3 forward{0, 0, -1};
  glm::dvec3 up{0, 1, 0};
};

struct SeaPage {
  std::string title;
  std::vector<SeaPagePlace> places;  ///< in the units of the scene
  std::optional<Box> proxy;  ///< a box whose inside stands for what is seen, such as a room; it holds all places
  double quality = 75;       ///< of JPEG
};

/// Writes the folder, which is made where there is none; files of an earlier page of the same name are replaced.
/// `imageOf(k)` gives the image of place k and is called once for each, in their order; it may throw, and what was
/// written so far stays. Throws InputError for a sea without places, a place that is not finite or whose axes are not,
/// ups that cancel out, a proxy that does not hold a place, and an image without pixels; WorkError where a file cannot
/// be written.
void writeSeaPage(const SeaPage& page, const std::function<Image<Rgb8>(size_t)>& imageOf,
                  const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace ocelli
