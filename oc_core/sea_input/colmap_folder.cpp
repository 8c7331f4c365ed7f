#include "oc_core/sea_input/colmap_folder.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> modelFolder(const fs::path& folder) {
  for (const fs::path& place : {folder, folder / "sparse", folder / "sparse" / "0"}) {
    if (fs::is_regular_file(place / "cameras.txt") && fs::is_regular_file(place / "images.txt")) {
      return place;
    }
  }
  return std::nullopt;
}

/// Lines of words; comments begin with #.
class ColmapLines {
 public:
  explicit ColmapLines(const fs::path& path) : path_(path), text_(readFile(path)) {}

  /// The next line that is no comment. Empty lines count where `emptyToo`.
  bool next(bool emptyToo = false) {
    while (std::getline(text_, line_)) {
      ++number_;
      if (!line_.empty() && line_.back() == '\r') {
        line_.pop_back();
      }
      const bool isComment = !line_.empty() && line_[0] == '#';
      if (!isComment && (emptyToo || line_.find_first_not_of(" \t") != std::string::npos)) {
        words_.clear();
        std::istringstream stream(line_);
        std::string word;
        while (stream >> word) {
          words_.push_back(word);
        }
        return true;
      }
    }
    return false;
  }

  const std::vector<std::string>& words() const { return words_; }
  double number(size_t word) const {
    const auto value = word < words_.size() ? numberFromText<double>(words_[word]) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      fail(word < words_.size() ? "\"" + printableText(words_[word]) + "\" is no number" : "a number is missing");
    }
    return *value;
  }
  int wholeNumber(size_t word) const {
    const auto value = word < words_.size() ? numberFromText<int>(words_[word]) : std::nullopt;
    if (!value) {
      fail("a whole number is missing");
    }
    return *value;
  }
  /// The rest of the line from a word on: names may have spaces.
  std::string rest(size_t word) const {
    size_t at = 0;
    for (size_t i = 0; i < word; ++i) {
      at = line_.find_first_not_of(" \t", at);
      at = line_.find_first_of(" \t", at);
    }
    at = at == std::string::npos ? line_.size() : line_.find_first_not_of(" \t", at);
    return at == std::string::npos ? "" : line_.substr(at);
  }
  [[noreturn]] void fail(const std::string& what, const std::string& next = "export the model anew as text") const {
    throw InputError(what, fmt::format("{}:{}", path_.string(), number_), next);
  }

 private:
  fs::path path_;
  std::istringstream text_;
  std::string line_;
  int64_t number_ = 0;
  std::vector<std::string> words_;
};

std::map<int, SeaProjection> readCameras(const fs::path& path) {
  std::map<int, SeaProjection> cameras;
  ColmapLines lines(path);
  while (lines.next()) {
    SeaProjection camera;
    camera.kind = SeaProjectionKind::kPinhole;
    const int id = lines.wholeNumber(0);
    const std::string model = lines.words().size() > 1 ? lines.words()[1] : "";
    camera.width = lines.wholeNumber(2);
    camera.height = lines.wholeNumber(3);
    if (model == "PINHOLE") {
      camera.focal = {lines.number(4), lines.number(5)};
      camera.center = {lines.number(6), lines.number(7)};
    } else if (model == "SIMPLE_PINHOLE") {
      camera.focal = glm::dvec2(lines.number(4));
      camera.center = {lines.number(5), lines.number(6)};
    } else {
      lines.fail("cameras of the model \"" + printableText(model) + "\" are not taken",
                 "take the lens out with COLMAP's image_undistorter: it gives PINHOLE");
    }
    if (!cameras.emplace(id, camera).second) {
      lines.fail(fmt::format("camera {} stands there twice", id));
    }
  }
  return cameras;
}

SeaPose poseOfColmap(const ColmapLines& lines) {
  glm::dquat cameraFromWorld(lines.number(1), lines.number(2), lines.number(3), lines.number(4));
  if (!(std::abs(glm::length(cameraFromWorld) - 1) < 1e-2)) {
    lines.fail("QW QX QY QZ are no rotation: their squares must sum up to 1");
  }
  cameraFromWorld = glm::normalize(cameraFromWorld);
  const glm::dvec3 translation{lines.number(5), lines.number(6), lines.number(7)};
  const glm::dquat worldFromColmap = glm::conjugate(cameraFromWorld);
  // Half a turn about x takes y down and z forward to ours.
  return {-(worldFromColmap * translation), worldFromColmap * glm::dquat(0, 1, 0, 0)};
}

fs::path imagePath(const fs::path& folder, const std::string& name) {
  const fs::path inside = folder / "images" / name;
  return fs::is_regular_file(inside) ? inside : folder / name;
}

}  // namespace

bool isColmapFolder(const fs::path& folder) {
  return modelFolder(folder).has_value();
}

PosedImages readColmapFolder(const fs::path& folder) {
  const fs::path model = *modelFolder(folder);
  const std::map<int, SeaProjection> cameras = readCameras(model / "cameras.txt");
  PosedImages read;
  std::optional<int> first;
  ColmapLines lines(model / "images.txt");
  while (lines.next()) {
    const int camera = lines.wholeNumber(8);
    const auto found = cameras.find(camera);
    if (found == cameras.end()) {
      lines.fail(fmt::format("there is no camera {} in cameras.txt", camera));
    }
    if (first && !(cameras.at(*first) == found->second)) {
      lines.fail(
          fmt::format("this image is of camera {}, the first one of camera {}, which is another", camera, *first),
          "make a sea of the images of each camera");
    }
    first = first.value_or(camera);
    read.projection = found->second;
    const std::string name = lines.rest(9);
    if (name.empty()) {
      lines.fail("this image has no name");
    }
    read.poses.push_back(poseOfColmap(lines));
    read.names.push_back(name);
    read.files.push_back(imagePath(folder, name));
    lines.next(true);  // the points that were seen in it
  }
  if (fs::is_regular_file(model / "points3D.txt")) {
    ColmapLines points(model / "points3D.txt");
    while (points.next()) {
      read.points.emplace_back(points.number(1), points.number(2), points.number(3));
    }
  }
  return read;
}

}  // namespace ocelli
