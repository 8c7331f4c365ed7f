#include "oc_core/sea_input/sea_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/number_text.h"
#include "oc_core/sea_input/image_folder.h"
#include "oc_core/sea_input/place_table.h"
#include "oc_core/sea_input/rendered_images.h"
#include "oc_core/sea_input/sea_proxies.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr double kUsualSpacing = 0.05;  ///< metres, of scenes that say none

struct Grid {
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  double spacing = 0;
};

Grid gridFromText(const std::string& text) {
  std::vector<double> values;
  size_t begin = 0;
  while (begin <= text.size()) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const auto value = numberFromText<double>(std::string_view(text).substr(begin, end - begin));
    if (!value || !std::isfinite(*value)) {
      values.clear();
      break;
    }
    values.push_back(*value);
    begin = end + 1;
  }
  if (values.size() != 5 || !(values[4] > 0)) {
    throw InputError("\"" + text + "\" is no grid", "--grid", "give X0,Z0,X1,Z1,SPACING, for example 0,0,4,4,0.1");
  }
  return {{std::min(values[0], values[2]), std::min(values[1], values[3])},
          {std::max(values[0], values[2]), std::max(values[1], values[3])},
          values[4]};
}

std::vector<SeaPose> posesOnGrid(const Grid& grid, double height) {
  const auto steps = [&](double length) { return std::floor(length / grid.spacing + 1e-9) + 1; };
  const double columns = steps(grid.to.x - grid.from.x);
  const double rows = steps(grid.to.y - grid.from.y);
  constexpr double kMost = 1 << 24;
  if (columns * rows > kMost) {
    throw InputError(fmt::format("this grid has {:.0f} places", columns * rows), "--grid", "take them farther apart");
  }
  std::vector<SeaPose> poses;
  for (int row = 0; row < static_cast<int>(rows); ++row) {
    for (int column = 0; column < static_cast<int>(columns); ++column) {
      poses.push_back(
          {{grid.from.x + column * grid.spacing, height, grid.from.y + row * grid.spacing}, glm::dquat(1, 0, 0, 0)});
    }
  }
  return poses;
}

void keepChosen(std::vector<SeaPose>& poses, const SeaInputOptions& options, const std::string& where) {
  if (options.first >= poses.size()) {
    throw InputError(fmt::format("there are {} images, none behind the first {}", poses.size(), options.first), where,
                     "choose a smaller --first");
  }
  poses.erase(poses.begin(), poses.begin() + static_cast<ptrdiff_t>(options.first));
  if (options.count > 0 && options.count < poses.size()) {
    poses.resize(options.count);
  }
}

double lengthOf(const std::vector<glm::vec3>& path) {
  double length = 0;
  for (size_t i = 1; i < path.size(); ++i) {
    length += glm::distance(glm::dvec3(path[i - 1]), glm::dvec3(path[i]));
  }
  return length;
}

std::vector<SeaPose> posesInScene(const std::string& input, const SceneGuides& guides, const SeaInputOptions& options) {
  if (!options.positions.empty() && !options.grid.empty()) {
    throw InputError("a table of places and a grid do not go together", "--grid", "leave one of them out");
  }
  if (!options.positions.empty()) {
    return placesFromCsv(readFile(options.positions, kMaxTextBytes), options.positions).poses;
  }
  if (!options.grid.empty()) {
    return posesOnGrid(gridFromText(options.grid), options.eyeHeight);
  }
  if (guides.path.size() < 2) {
    throw InputError("this scene knows no path to take images along", input,
                     "give --positions FILE.csv, or --grid X0,Z0,X1,Z1,SPACING");
  }
  SeaWalk walk = guides.sea.value_or(SeaWalk{0, static_cast<float>(kUsualSpacing)});
  if (options.spacing || walk.count == 0) {
    walk.spacing = static_cast<float>(options.spacing.value_or(walk.spacing));
    walk.count = static_cast<size_t>(lengthOf(guides.path) / walk.spacing) + 1;
  }
  std::vector<SeaPose> poses;
  for (const glm::vec3& position : seaPositions(guides.path, walk)) {
    poses.push_back({glm::dvec3(position), glm::dquat(1, 0, 0, 0)});
  }
  return poses;
}

std::vector<glm::dvec3> positionsOf(const std::vector<SeaPose>& poses) {
  std::vector<glm::dvec3> positions;
  positions.reserve(poses.size());
  for (const SeaPose& pose : poses) {
    positions.push_back(pose.position);
  }
  return positions;
}

SeaInput openFolder(const std::string& input, const SeaInputOptions& options) {
  if (!options.positions.empty() || !options.grid.empty() || options.spacing) {
    throw InputError("images in a folder have their places already", input,
                     "leave --positions, --grid and --spacing out");
  }
  PosedImages folder = readImageFolder(input);
  const std::vector<glm::dvec3> points = std::move(folder.points);
  if (folder.poses.size() > options.first) {
    const auto keep = [&](auto& list) {
      list.erase(list.begin(), list.begin() + static_cast<ptrdiff_t>(options.first));
      if (options.count > 0 && options.count < list.size()) {
        list.resize(options.count);
      }
    };
    keep(folder.names);
    keep(folder.files);
  }
  keepChosen(folder.poses, options, input);
  SeaInput opened;
  const std::string proxy = !options.proxy.empty() ? options.proxy : points.empty() ? "none" : "box";
  opened.proxy = makeSeaProxy(proxy, {nullptr, positionsOf(folder.poses), points, options.proxyTriangles, input});
  opened.source = std::make_unique<FolderImages>(input, std::move(folder));
  return opened;
}

}  // namespace

SeaInput openSeaInput(const std::string& input, SceneOptions sceneOptions, const SeaInputOptions& options,
                      const Progress& progress) {
  std::error_code ignored;
  if (fs::is_directory(input, ignored)) {
    return openFolder(input, options);
  }
  sceneOptions.fit = false;
  GuidedScene scene = loadGuidedScene(input, sceneOptions, progress);
  std::vector<SeaPose> poses = posesInScene(input, scene.guides, options);
  keepChosen(poses, options, input);
  validatePoses(poses, {}, input);
  const SeaProjection projection{SeaProjectionKind::kPanorama, options.size.x, options.size.y, glm::dvec2(1),
                                 glm::dvec2(0)};
  validate(projection, "--size");
  SeaInput opened;
  opened.arePosesExact = true;
  opened.scene = std::make_shared<const Mesh>(std::move(scene.mesh));
  report(progress, "making the proxy", 0);
  opened.proxy = makeSeaProxy(options.proxy.empty() ? "scene" : options.proxy,
                              {opened.scene.get(), positionsOf(poses), {}, options.proxyTriangles});
  opened.source = std::make_unique<RenderedImages>(input, *opened.scene, std::move(poses),
                                                   RenderedImages::Options{projection, options.samples, glm::vec3(0)});
  return opened;
}

SeaInput openSeaSource(const std::string& input, SceneOptions sceneOptions, const SeaFile& sea, int samples,
                       const Progress& progress) {
  SeaInput opened;
  std::error_code ignored;
  if (fs::is_directory(input, ignored)) {
    PosedImages all = readImageFolder(input);
    PosedImages chosen;
    chosen.projection = all.projection;
    for (const std::string& name : sea.names()) {
      const auto found = std::find(all.names.begin(), all.names.end(), name);
      if (found == all.names.end()) {
        throw InputError("an image of the sea is not in this folder: " + name, input,
                         "give the folder that it was made of");
      }
      const auto index = static_cast<size_t>(found - all.names.begin());
      chosen.names.push_back(name);
      chosen.poses.push_back(all.poses[index]);
      chosen.files.push_back(all.files[index]);
    }
    opened.source = std::make_unique<FolderImages>(input, std::move(chosen));
    return opened;
  }
  sceneOptions.fit = false;
  opened.scene = std::make_shared<const Mesh>(loadScene(input, sceneOptions, progress));
  std::vector<SeaPose> poses;
  for (uint32_t i = 0; i < sea.count(); ++i) {
    poses.push_back(sea.pose(i));
  }
  opened.source =
      std::make_unique<RenderedImages>(input, *opened.scene, std::move(poses),
                                       RenderedImages::Options{sea.settings().projection, samples, glm::vec3(0)});
  return opened;
}

}  // namespace ocelli
