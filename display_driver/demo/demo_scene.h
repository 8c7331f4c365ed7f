// One scene of `ocelli demo`: the whole way from the scene to what an observer sees, as images and figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "display_sim/solidity/solidity.h"
#include "oc_core/base/progress.h"
#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

struct DemoImage {
  std::string file;     ///< relative to the page
  std::string name;     ///< what it shows, in two or three words
  std::string caption;  ///< one sentence more
  int width = 0;
  int height = 0;
};

/// Images that stand side by side and can take each other's place: the same view of several representations.
struct DemoRow {
  std::string title;
  std::string text;
  std::vector<DemoImage> images;
};

struct DemoScene {
  std::string title;
  std::string source;  ///< what to give to the other commands
  std::vector<DemoRow> rows;
  size_t geometryTriangles = 0;
  double geometrySliceMilliseconds = 0;
  std::vector<RepresentationFigures> figures;  ///< of the depth image first; empty where there are rows alone
  std::vector<std::string> solidityEyes;       ///< where the eyes are of the figures that follow
  std::vector<SolidityFigures> solidity;       ///< of the full geometry first
};

struct DemoOptions {
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  int observedSide = 640;  ///< of the observer's images, pixels
  DisplayProfile profile;
};

/// `source` as loadScene() takes it. Writes the images below `folder`/`name`; throws what the rooms throw.
DemoScene runDemoScene(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                       const std::string& name, const DemoOptions& options, const Progress& progress);

}  // namespace ocelli
