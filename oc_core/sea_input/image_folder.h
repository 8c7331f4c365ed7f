// Folders of images with known poses: which kinds of folders there are, and the images as a source of seas.
//
// Recipe for a new kind: oc_core/sea_input/NAME_folder.h and .cpp with its function, and a row of the table in
// oc_core/sea_input/image_folder.cpp.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/sea/sea_source.h"

namespace ocelli {

/// What such a folder says.
struct PosedImages {
  SeaProjection projection;
  std::vector<SeaPose> poses;
  std::vector<std::string> names;            ///< as the folder calls them
  std::vector<std::filesystem::path> files;  ///< one a pose
  std::vector<glm::dvec3> points;            ///< of surfaces, where the folder knows some
};

/// Throws InputError for a folder of no kind that is known, with what it should hold, and for what is wrong in it.
PosedImages readImageFolder(const std::filesystem::path& folder);

class FolderImages final : public SeaSource {
 public:
  /// `description`: the folder as the user wrote it. The files are looked for at once. Throws InputError as above.
  FolderImages(std::string description, PosedImages folder);

  std::string description() const override { return description_; }
  const SeaProjection& projection() const override { return folder_.projection; }
  const std::vector<SeaPose>& poses() const override { return folder_.poses; }
  const std::vector<std::string>& names() const override { return folder_.names; }
  Image<Rgb8> image(uint32_t index) const override;

 private:
  std::string description_;
  PosedImages folder_;
};

}  // namespace ocelli
