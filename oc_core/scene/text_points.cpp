#include "oc_core/scene/text_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

constexpr size_t kMaxLineBytes = 1000;
constexpr size_t kMaxColumns = 9;

/// Which of its numbers a line has at which column; nothing where it has none.
struct LineLayout {
  size_t columns;
  std::optional<size_t> color;
  std::optional<size_t> normal;

  bool isEither() const { return color && color == normal; }
};

constexpr std::array<LineLayout, 5> kLayouts{{{3, {}, {}}, {4, {}, {}}, {6, 3, 3}, {7, 4, {}}, {9, 3, 6}}};

class PointTextReader {
 public:
  PointTextReader(std::istream& stream, const std::string& where) : stream_(stream), where_(where) {}

  PointCloud read() {
    std::string line;
    while (nextLine(line)) {
      readLine(line);
    }
    if (told_ && *told_ != cloud_.positions.size()) {
      throw InputError(
          "the file tells of " + std::to_string(*told_) + " points and has " + std::to_string(cloud_.positions.size()),
          where_, "copy or export it again: it looks truncated");
    }
    if (layout_ != nullptr && layout_->isEither()) {
      (areColors_ && !areAxes_ ? cloud_.normals : cloud_.colors) = {};
    }
    for (glm::vec3& color : cloud_.colors) {
      for (glm::length_t i = 0; i < 3; ++i) {
        color[i] = linearFromSrgbByte(static_cast<uint8_t>(std::lround(color[i])));
      }
    }
    return std::move(cloud_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& next) const {
    throw InputError(what, where_ + ", line " + std::to_string(lineNumber_), next);
  }

  /// The end of the file where there is no more; a disk that fails is not taken for that.
  int nextByte() {
    try {
      if (!stream_.bad()) {
        return stream_.rdbuf()->sbumpc();
      }
    } catch (const std::ios_base::failure&) {  // a buffer that is read without its stream says so
    }
    fail("the file cannot be read from here on", "check its disk, or copy it again");
  }

  bool nextLine(std::string& line) {
    line.clear();
    ++lineNumber_;
    for (int c = nextByte(); c != std::istream::traits_type::eof(); c = nextByte()) {
      if (c == '\n') {
        return true;
      }
      if (line.size() == kMaxLineBytes) {
        fail("this line is too long", "give a file of points, a line each");
      }
      line += static_cast<char>(c);
    }
    return !line.empty();
  }

  /// The numbers of a line; `size` becomes kMaxColumns + 1 where there are more.
  std::array<float, kMaxColumns> numbersOf(std::string_view line, size_t& size) const {
    const auto isBetween = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; };
    std::array<float, kMaxColumns> numbers{};
    size = 0;
    while (true) {
      const auto* const first = std::ranges::find_if_not(line, isBetween);
      const auto* const last = std::find_if(first, line.end(), isBetween);
      if (first == last) {
        return numbers;
      }
      double value = 0;
      const auto [end, error] = std::from_chars(*first == '+' ? first + 1 : first, last, value);
      if (error != std::errc() || end != last) {
        fail(fmt::format("\"{}\" is not a number", std::string_view(first, last)), "repair or leave out this line");
      }
      if (size == kMaxColumns) {
        ++size;
        return numbers;
      }
      numbers[size++] = static_cast<float>(value);
      line = line.substr(static_cast<size_t>(last - line.begin()));
    }
  }

  void readLine(std::string_view line) {
    const size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string_view::npos || line[start] == '#' || line.substr(start).starts_with("//")) {
      return;
    }
    size_t size = 0;
    const std::array<float, kMaxColumns> numbers = numbersOf(line, size);
    if (layout_ == nullptr && size == 1 && !told_) {
      readCount(line.substr(start));
      return;
    }
    if (layout_ == nullptr) {
      const auto* const known = std::ranges::find(kLayouts, size, &LineLayout::columns);
      if (known == kLayouts.end()) {
        fail("a line of " + (size > kMaxColumns ? "more than 9" : std::to_string(size)) + " numbers is not known",
             "give x y z, and if there are any an intensity, a colour, a normal: 3, 4, 6, 7 or 9 numbers");
      }
      layout_ = known;
    }
    if (size != layout_->columns) {
      fail("this line does not have " + std::to_string(layout_->columns) + " numbers, as the first one has",
           "repair or leave out this line");
    }
    addPoint(numbers);
  }

  void readCount(std::string_view text) {
    uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() ||
        text.substr(static_cast<size_t>(end - text.data())).find_first_not_of(" \t\r") != std::string_view::npos) {
      fail("one number alone is no point, and this is no number of points", "give x, y and z");
    }
    told_ = count;
  }

  void addPoint(const std::array<float, kMaxColumns>& numbers) {
    if (cloud_.positions.size() == kMaxScenePoints) {
      fail("the file has more than " + std::to_string(kMaxScenePoints) + " points", "leave points out");
    }
    const auto three = [&](size_t at) { return glm::vec3(numbers[at], numbers[at + 1], numbers[at + 2]); };
    cloud_.positions.push_back(three(0));
    if (layout_->color && areColors_) {
      const glm::vec3 color = three(*layout_->color);
      if (isColor(color)) {
        cloud_.colors.push_back(color);
      } else if (layout_->isEither()) {
        areColors_ = false;
        cloud_.colors = {};
      } else {
        fail("this colour is not of whole numbers from 0 to 255", "repair or leave out this line");
      }
    }
    if (layout_->normal) {
      const glm::vec3 normal = three(*layout_->normal);
      cloud_.normals.push_back(normal);
      areAxes_ = areAxes_ && isAxis(normal);
    }
  }

  static bool isColor(const glm::vec3& color) {
    for (glm::length_t i = 0; i < 3; ++i) {
      if (!(color[i] >= 0 && color[i] <= 255 && color[i] == std::floor(color[i]))) {
        return false;
      }
    }
    return true;
  }

  /// Whether all but one are 0, and that is 1.
  static bool isAxis(const glm::vec3& normal) {
    return normal == glm::vec3(1, 0, 0) || normal == glm::vec3(0, 1, 0) || normal == glm::vec3(0, 0, 1);
  }

  std::istream& stream_;
  const std::string& where_;
  size_t lineNumber_ = 0;
  std::optional<uint64_t> told_;
  const LineLayout* layout_ = nullptr;
  bool areColors_ = true;  ///< of numbers that may be either: whole ones from 0 to 255
  bool areAxes_ = true;    ///< of normals: each is along x, y or z
  PointCloud cloud_;
};

}  // namespace

bool isPointText(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".xyz" || ending == ".pts";
}

PointCloud readTextPoints(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError("cannot open this file", path.string(), "check that it exists and may be read");
  }
  return readTextPoints(stream, path.string());
}

PointCloud readTextPoints(std::istream& stream, const std::string& where) {
  return PointTextReader(stream, where).read();
}

}  // namespace ocelli
