// Folders of COLMAP's text files: cameras.txt, images.txt and, where it is there, points3D.txt, in the folder, in
// sparse/ or in sparse/0/; images in the folder or in images/.
//
// Lenses must have been taken out before (COLMAP: image_undistorter): cameras are PINHOLE or SIMPLE_PINHOLE, and all
// images are of one camera. COLMAP's cameras look along +z with y down; its poses take the world to the camera.
#pragma once

#include <filesystem>

#include "oc_core/sea_input/image_folder.h"

namespace ocelli {

bool isColmapFolder(const std::filesystem::path& folder);
/// Throws InputError with file and line.
PosedImages readColmapFolder(const std::filesystem::path& folder);

}  // namespace ocelli
