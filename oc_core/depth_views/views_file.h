// views.json: which PNG files of a folder are colours and depths, and from where they were seen.
// views.schema.json describes it, and docs/views_with_depth.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/depth_views/depth_levels.h"

namespace ocelli {

/// What views.json says of one view.
struct ListedView {
  std::string name;
  std::string colorFile;  ///< in the folder
  std::string depthFile;
  View view;
  DepthLevels levels;
};

/// Throws InputError naming file, line and field: also for files outside of the folder, two views of one name, and a
/// near that is not less than far. `where` names the text.
std::vector<ListedView> viewsFromJsonText(const std::string& text, const std::string& where);

/// All of one scale.
std::string viewsJsonText(const std::vector<ListedView>& views);

}  // namespace ocelli
