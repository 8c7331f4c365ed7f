#include "oc_core/sea_input/image_folder.h"

#include <array>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/sea_input/colmap_folder.h"
#include "oc_core/sea_input/image_file.h"
#include "oc_core/sea_input/place_table.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPositions = "positions.csv";

bool isPositionFolder(const fs::path& folder) {
  return fs::is_regular_file(folder / kPositions);
}

/// Omnidirectional images, and a table of where they were taken.
PosedImages readPositionFolder(const fs::path& folder) {
  const std::string where = (folder / kPositions).string();
  PlaceTable table = placesFromCsv(readFile(folder / kPositions, kMaxTextBytes), where);
  if (table.files.empty()) {
    throw InputError("this table names no images", where, "add a column \"file\"");
  }
  PosedImages read;
  read.poses = std::move(table.poses);
  read.names = std::move(table.files);
  for (const std::string& name : read.names) {
    read.files.push_back(folder / name);
  }
  const glm::ivec2 size = imageFileSize(read.files[0]);
  read.projection = {SeaProjectionKind::kPanorama, size.x, size.y, glm::dvec2(1), glm::dvec2(0)};
  return read;
}

struct FolderKind {
  const char* holds;  ///< in messages
  bool (*is)(const fs::path& folder);
  PosedImages (*read)(const fs::path& folder);
};

constexpr std::array kFolderKinds{FolderKind{"positions.csv (columns file, x, y, z) and omnidirectional images",
                                             isPositionFolder, readPositionFolder},
                                  FolderKind{"COLMAP's cameras.txt and images.txt", isColmapFolder, readColmapFolder}};

}  // namespace

PosedImages readImageFolder(const fs::path& folder) {
  std::string known;
  for (const FolderKind& kind : kFolderKinds) {
    if (kind.is(folder)) {
      return kind.read(folder);
    }
    known += (known.empty() ? "" : ", or ") + std::string(kind.holds);
  }
  throw InputError("this folder does not say where its images were taken", folder.string(), "it should hold " + known);
}

FolderImages::FolderImages(std::string description, PosedImages folder)
    : description_(std::move(description)), folder_(std::move(folder)) {
  validate(folder_.projection, description_);
  validatePoses(folder_.poses, folder_.names, description_);
  for (const fs::path& file : folder_.files) {
    if (!fs::is_regular_file(file)) {
      throw InputError("there is no such image", file.string(), "put it there, or take it out of the table of poses");
    }
  }
}

Image<Rgb8> FolderImages::image(uint32_t index) const {
  return readImageFile(folder_.files[index], {folder_.projection.width, folder_.projection.height});
}

}  // namespace ocelli
