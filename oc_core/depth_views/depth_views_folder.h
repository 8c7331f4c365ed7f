// Folders of views with depth: EXR files of this toolkit, or PNG files that views.json lists.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/depth_views/depth_view.h"

namespace ocelli {

/// The views that views.json lists, in its order; where there is none, those of all .exr files, by name. Throws
/// InputError where the folder is missing or has neither, a file is missing or broken, colours and depths differ in
/// size, two views are the same, or one is of another camera.
std::vector<DepthView> readDepthViews(const std::filesystem::path& folder, const Progress& progress = {});

/// How views stand in a folder.
struct DepthViewsFormat {
  const char* name;
  const char* meaning;
  void (*write)(const std::filesystem::path& folder, const std::vector<DepthView>& views, const Progress& progress);
};
const std::array<DepthViewsFormat, 2>& depthViewsFormats();

/// Makes the folder where it is not there. Throws InputError where it holds views already, and for panoramas as PNG
/// files; WorkError where something cannot be written: what was written stays.
void writeDepthViews(const std::filesystem::path& folder, const std::vector<DepthView>& views,
                     const DepthViewsFormat& format, const Progress& progress = {});

}  // namespace ocelli
