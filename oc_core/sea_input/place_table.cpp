#include "oc_core/sea_input/place_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "oc_core/base/conventions.h"
#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/base/trimmed.h"

namespace ocelli {
namespace {

constexpr const char* kColumnsNext =
    "name the columns in the first row: x,y,z, and perhaps file, and yaw or qw,qx,qy,qz";

class PlaceReader {
 public:
  PlaceReader(std::string_view bytes, const std::string& where) : reader_(bytes, where) {
    if (!reader_.next(fields_)) {
      throw InputError("this table of places is empty", where, kColumnsNext);
    }
    for (size_t i = 0; i < fields_.size(); ++i) {
      std::string name(trimmed(fields_[i]));
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      columns_.emplace(std::move(name), i);
    }
    for (const char* name : {"x", "y", "z"}) {
      if (!has(name)) {
        throw InputError("there is no column \"" + std::string(name) + "\"", reader_.place(), kColumnsNext);
      }
    }
    const std::array quaternion{"qw", "qx", "qy", "qz"};
    const auto given = std::count_if(quaternion.begin(), quaternion.end(), [&](const char* name) { return has(name); });
    if ((given != 0 && given != 4) || (given == 4 && has("yaw"))) {
      throw InputError("a rotation is either yaw or all of qw, qx, qy, qz", reader_.place(), kColumnsNext);
    }
    hasQuaternion_ = given == 4;
  }

  bool has(const std::string& column) const { return columns_.contains(column); }

  bool next(SeaPose& pose, std::string& file) {
    do {
      if (!reader_.next(fields_)) {
        return false;
      }
    } while (
        std::all_of(fields_.begin(), fields_.end(), [](const std::string& field) { return trimmed(field).empty(); }));
    pose = {{number("x"), number("y"), number("z")}, glm::dquat(1, 0, 0, 0)};
    if (hasQuaternion_) {
      pose.worldFromCamera = {number("qw"), number("qx"), number("qy"), number("qz")};
      const double length = glm::length(pose.worldFromCamera);
      if (!(std::abs(length - 1) < 1e-3)) {
        throw InputError("qw, qx, qy, qz are no rotation: their squares must sum up to 1", reader_.place(),
                         "divide them by the root of that sum");
      }
      pose.worldFromCamera = glm::normalize(pose.worldFromCamera);
    } else if (has("yaw")) {
      pose.worldFromCamera = glm::angleAxis(radiansFromDegrees(number("yaw")), glm::dvec3(0, 1, 0));
    }
    file = has("file") ? textOfCsv(std::string(trimmed(field("file")))) : "";
    if (has("file") && file.empty()) {
      throw InputError("this row names no file", reader_.place(), "name the image, or leave the row out");
    }
    return true;
  }

 private:
  const std::string& field(const std::string& column) {
    static const std::string kMissing;
    const size_t index = columns_.at(column);
    return index < fields_.size() ? fields_[index] : kMissing;
  }
  double number(const std::string& column) {
    const std::string text(trimmed(field(column)));
    const auto value = numberFromText<double>(text);
    if (!value || !std::isfinite(*value)) {
      throw InputError("\"" + printableText(text) + "\" of column " + column + " is no number", reader_.place(),
                       "write it as 1.25");
    }
    return *value;
  }

  CsvReader reader_;
  std::vector<std::string> fields_;
  std::map<std::string, size_t> columns_;
  bool hasQuaternion_ = false;
};

}  // namespace

PlaceTable placesFromCsv(std::string_view bytes, const std::string& where) {
  PlaceReader reader(bytes, where);
  PlaceTable table;
  SeaPose pose;
  std::string file;
  while (reader.next(pose, file)) {
    table.poses.push_back(pose);
    if (reader.has("file")) {
      table.files.push_back(file);
    }
  }
  return table;
}

}  // namespace ocelli
