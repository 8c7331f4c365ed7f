// The page of `ocelli evaluate --page`: plain HTML and CSS, no script, nothing from the network, fit to be printed.
#pragma once

#include <string>
#include <vector>

#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

/// What the page shows of one representation, from the example viewpoint: paths relative to the page.
struct EvaluateImages {
  std::string frame;
  std::string errors;
};

struct EvaluatePage {
  std::string scene;    ///< as the user named it
  std::string version;  ///< of the program
  size_t sceneTriangles = 0;
  std::string truthImage;
  std::vector<EvaluateImages> images;  ///< one for each row of figures
  bool complete = true;
  std::string sceneParts{};  ///< what the scene consists of, where that is no triangles
};

/// File names for the images of a representation. `identity` is its name, or tells it from others of the same name.
EvaluateImages imageNames(const std::string& name, const std::string& identity);

/// The whole of index.html.
std::string evaluatePage(const EvaluatePage& page, const EvaluationOptions& options,
                         const std::vector<RepresentationFigures>& figures);

}  // namespace ocelli
