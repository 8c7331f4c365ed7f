#include "oc_core/labels/label_table.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/base/trimmed.h"
#include "oc_core/base/utf8.h"
#include "oc_core/image/color_text.h"

namespace ocelli {
namespace {

class LabelReader {
 public:
  LabelReader(std::string_view bytes, const std::string& where) : reader_(bytes, where) {
    if (!reader_.next(fields_)) {
      throw InputError("this table of labels is empty", where, "begin it with x,y,z,text");
    }
    for (size_t i = 0; i < fields_.size(); ++i) {
      std::string name(trimmed(fields_[i]));
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      columns_.emplace(name == "colour" ? "color" : name, i);
    }
    for (const char* name : {"x", "y", "z", "text"}) {
      if (!columns_.contains(name)) {
        throw InputError("there is no column \"" + std::string(name) + "\"", reader_.place(),
                         "name the columns in the first row: x,y,z,text, and perhaps size,color,nx,ny,nz");
      }
    }
  }

  bool next(SceneLabel& label) {
    do {
      if (!reader_.next(fields_)) {
        return false;
      }
    } while (std::ranges::all_of(fields_, [](const std::string& field) { return trimmed(field).empty(); }));
    label = {};
    label.position = {needed("x"), needed("y"), needed("z")};
    label.text = cleanText(textOfCsv(field("text")));
    if (label.text.find_first_not_of(" \t\n") == std::string::npos ||
        characterCount(label.text) > kMaxLabelCharacters) {
      throw InputError("a label has a text of 1 to " + std::to_string(kMaxLabelCharacters) + " characters",
                       reader_.place(), "shorten it, or leave the row out");
    }
    label.size = number("size");
    if (label.size && !(*label.size > 0)) {
      throw InputError("the size of a label must be positive", reader_.place(),
                       "leave the field empty, so that it fits the scene");
    }
    readColor(label);
    const std::optional<float> x = number("nx");
    const std::optional<float> y = number("ny");
    const std::optional<float> z = number("nz");
    if (x || y || z) {
      label.facing = glm::vec3(x.value_or(0), y.value_or(0), z.value_or(0));
      if (*label.facing == glm::vec3(0)) {
        throw InputError("nx, ny and nz are all 0, which is no direction", reader_.place(),
                         "give the direction from the label to who reads it");
      }
    }
    return true;
  }

 private:
  std::string field(const char* column) const {
    const auto found = columns_.find(column);
    return found == columns_.end() || found->second >= fields_.size() ? "" : fields_[found->second];
  }

  std::optional<float> number(const char* column) const {
    const std::string text(trimmed(textOfCsv(field(column))));
    if (text.empty()) {
      return std::nullopt;
    }
    const std::optional<float> number = numberFromText<float>(text.starts_with('+') ? text.substr(1) : text);
    if (!number) {
      throw InputError("\"" + printableText(text) + "\" in column \"" + column + "\" is no number", reader_.place(),
                       "write it like -1.5");
    }
    return number;
  }

  float needed(const char* column) const {
    const std::optional<float> found = number(column);
    if (!found) {
      throw InputError("column \"" + std::string(column) + "\" is empty", reader_.place(),
                       "each label stands at x, y, z");
    }
    return *found;
  }

  void readColor(SceneLabel& label) const {
    const std::string text(trimmed(field("color")));
    if (text.empty()) {
      return;
    }
    const std::optional<glm::vec3> color = linearFromColorText(text);
    if (!color) {
      throw InputError("\"" + printableText(text) + "\" is no colour", reader_.place(), "write it like #ff8000");
    }
    label.color = *color;
  }

  CsvReader reader_;
  std::vector<std::string> fields_;
  std::map<std::string, size_t> columns_;
};

}  // namespace

std::vector<SceneLabel> readLabels(const std::filesystem::path& path) {
  const std::string bytes = readFile(path, kMaxTextBytes);
  LabelReader reader(bytes, path.string());
  std::vector<SceneLabel> labels;
  for (SceneLabel label; reader.next(label);) {
    labels.push_back(label);
  }
  if (labels.empty()) {
    throw InputError("this table has no labels", path.string(), "add a row: x,y,z,text");
  }
  return labels;
}

}  // namespace ocelli
