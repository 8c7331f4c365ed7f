#include "oc_core/scene/pcd_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>
#include <istream>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/lzf.h"

namespace ocelli {
namespace {

constexpr size_t kMaxPcdLineBytes = 1 << 16;
constexpr size_t kMaxPcdHeaderLines = 1000;
constexpr uint64_t kMaxPointBytes = 1 << 16;

/// A value of each point, or some.
struct PcdField {
  std::string name;
  uint64_t bytes = 4;  ///< of one value
  char type = 'F';     ///< I whole, U whole without a sign, F any
  uint64_t count = 1;
  uint64_t offset = 0;  ///< bytes of the fields before it in a point
  uint64_t column = 0;  ///< values of the fields before it
};

/// What there is of a point that is used: places in the list of fields.
struct PcdSlots {
  std::array<std::optional<size_t>, 3> position;
  std::array<std::optional<size_t>, 3> normal;
  std::optional<size_t> color;
};

template <class Value>
double valueOf(const std::byte* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

double valueAt(const std::byte* bytes, const PcdField& field) {
  const bool isSigned = field.type == 'I';
  switch (field.bytes) {
    case 1:
      return isSigned ? valueOf<int8_t>(bytes) : valueOf<uint8_t>(bytes);
    case 2:
      return isSigned ? valueOf<int16_t>(bytes) : valueOf<uint16_t>(bytes);
    case 4:
      return field.type == 'F' ? valueOf<float>(bytes) : isSigned ? valueOf<int32_t>(bytes) : valueOf<uint32_t>(bytes);
    default:
      return field.type == 'F' ? valueOf<double>(bytes) : isSigned ? valueOf<int64_t>(bytes) : valueOf<uint64_t>(bytes);
  }
}

class PcdReader {
 public:
  PcdReader(std::istream& stream, uint64_t size, const std::string& where)
      : stream_(stream), size_(size), where_(where) {}

  PointCloud read() {
    readHeader();
    findSlots();
    if (data_ == "ascii") {
      readAscii();
    } else if (data_ == "binary") {
      readBinary();
    } else {
      readCompressed();
    }
    return std::move(cloud_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& next = "write the file again as PCD, or as PLY") {
    throw InputError(what, where_, next);
  }
  [[noreturn]] void failShort() {
    fail("the file is too short for " + std::to_string(points_) + " points",
         "copy or write it again: it looks truncated");
  }

  /// False at the end of the file.
  bool nextLine(std::string& line) {
    line.clear();
    ++lines_;
    for (int c = stream_.get(); c != std::istream::traits_type::eof(); c = stream_.get()) {
      if (c == '\n') {
        return true;
      }
      if (line.size() == kMaxPcdLineBytes) {
        fail("line " + std::to_string(lines_) + " is too long");
      }
      line += static_cast<char>(c);
    }
    if (stream_.bad()) {
      fail("the file cannot be read to its end", "check its disk, or copy it again");
    }
    return !line.empty();
  }

  void readHeader() {
    std::string line;
    while (data_.empty()) {
      if (lines_ == kMaxPcdHeaderLines || !nextLine(line)) {
        fail("the header has no line DATA");
      }
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword.empty() || keyword.front() == '#') {
        continue;
      }
      std::vector<std::string> values;
      for (std::string word; words >> word;) {
        values.push_back(word);
      }
      take(keyword, values);
    }
    if (!hasPoints_) {
      if (width_ != 0 && height_ > std::numeric_limits<uint64_t>::max() / width_) {
        fail("WIDTH and HEIGHT are impossible");
      }
      points_ = width_ * height_;
    }
    if (points_ > kMaxScenePoints) {
      fail("the file has more than " + std::to_string(kMaxScenePoints) + " points", "leave points out");
    }
  }

  void take(const std::string& keyword, const std::vector<std::string>& values) {
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      fields_.resize(values.size());
      for (size_t i = 0; i < values.size(); ++i) {
        fields_[i].name = values[i];
      }
    } else if (keyword == "SIZE" || keyword == "TYPE" || keyword == "COUNT") {
      takeOfFields(keyword, values);
    } else if (keyword == "WIDTH") {
      width_ = wholeNumber(keyword, values);
    } else if (keyword == "HEIGHT") {
      height_ = wholeNumber(keyword, values);
    } else if (keyword == "POINTS") {
      points_ = wholeNumber(keyword, values);
      hasPoints_ = true;
    } else if (keyword == "DATA") {
      if (values.size() != 1 || (values[0] != "ascii" && values[0] != "binary" && values[0] != "binary_compressed")) {
        fail("DATA must be ascii, binary or binary_compressed");
      }
      data_ = values[0];
    } else if (keyword != "VERSION" && keyword != "VIEWPOINT") {
      fail("line " + std::to_string(lines_) + " is no line of a PCD header: '" + printableText(keyword) + "'");
    }
  }

  void takeOfFields(const std::string& keyword, const std::vector<std::string>& values) {
    if (fields_.empty() || values.size() != fields_.size()) {
      fail(keyword + " does not have a value for each of the FIELDS");
    }
    for (size_t i = 0; i < values.size(); ++i) {
      PcdField& field = fields_[i];
      if (keyword == "TYPE") {
        if (values[i] != "F" && values[i] != "I" && values[i] != "U") {
          fail("a TYPE must be F, I or U");
        }
        field.type = values[i].front();
        continue;
      }
      const auto number = numberFromText<uint64_t>(values[i]);
      const bool isSize = keyword == "SIZE";
      if (!number ||
          (isSize ? *number != 1 && *number != 2 && *number != 4 && *number != 8 : *number > kMaxPointBytes)) {
        fail("'" + printableText(values[i]) + "' is no " + keyword + " of a field");
      }
      (isSize ? field.bytes : field.count) = *number;
    }
  }

  uint64_t wholeNumber(const std::string& keyword, const std::vector<std::string>& values) {
    const auto number = values.size() == 1 ? numberFromText<uint64_t>(values[0]) : std::nullopt;
    if (!number) {
      fail(keyword + " is not one whole number");
    }
    return *number;
  }

  void findSlots() {
    static constexpr std::array<const char*, 3> kPosition{"x", "y", "z"};
    static constexpr std::array<const char*, 3> kNormal{"normal_x", "normal_y", "normal_z"};
    for (size_t i = 0; i < fields_.size(); ++i) {
      PcdField& field = fields_[i];
      if (field.type == 'F' && field.bytes < 4) {
        fail("field '" + printableText(field.name) + "' has a SIZE and a TYPE that do not fit");
      }
      field.offset = pointBytes_;
      field.column = columns_;
      pointBytes_ += field.bytes * field.count;
      columns_ += field.count;
      if (pointBytes_ > kMaxPointBytes) {
        fail("a point has more than " + std::to_string(kMaxPointBytes) + " bytes", "leave fields out");
      }
      if (field.count == 0) {
        continue;
      }
      for (size_t k = 0; k < 3; ++k) {
        if (field.name == kPosition[k]) {
          slots_.position[k] = i;
        } else if (field.name == kNormal[k]) {
          slots_.normal[k] = i;
        }
      }
      // Of other sizes they are no packed colours.
      if ((field.name == "rgb" || field.name == "rgba") && field.bytes == 4) {
        slots_.color = i;
      }
    }
    if (!std::ranges::all_of(slots_.position, [](const auto& slot) { return slot.has_value(); })) {
      fail("the points do not have x, y and z", "write them again with positions");
    }
    hasNormals_ = std::ranges::all_of(slots_.normal, [](const auto& slot) { return slot.has_value(); });
  }

  /// `value(i)` is the first value of field i, `bits(i)` the one of a colour as it is stored.
  template <class Value, class Bits>
  void addPoint(const Value& value, const Bits& bits) {
    const auto three = [&](const std::array<std::optional<size_t>, 3>& slots) {
      return glm::vec3(value(*slots[0]), value(*slots[1]), value(*slots[2]));
    };
    const glm::vec3 position = three(slots_.position);
    if (!isFinite(position)) {
      return;
    }
    cloud_.positions.push_back(position);
    if (hasNormals_) {
      const glm::vec3 normal = three(slots_.normal);
      cloud_.normals.push_back(isFinite(normal) ? normal : glm::vec3(0));
    }
    if (slots_.color) {
      cloud_.colors.push_back(colorOf(bits(*slots_.color)));
    }
  }

  /// 0xAARRGGBB. As a float it may be no number, whose bits do not outlive a conversion.
  static uint32_t bitsAt(const std::byte* bytes) {
    uint32_t bits = 0;
    std::memcpy(&bits, bytes, sizeof(bits));
    return bits;
  }

  /// The same of a number in text.
  static uint32_t bitsOf(double value, char type) {
    if (type == 'F') {
      return std::bit_cast<uint32_t>(static_cast<float>(value));
    }
    return value >= -0x1p31 && value < 0x1p32 ? static_cast<uint32_t>(static_cast<int64_t>(value)) : 0;
  }

  static glm::vec3 colorOf(uint32_t bits) {
    const auto channel = [&](uint32_t shift) { return linearFromSrgbByte(static_cast<uint8_t>(bits >> shift & 255U)); };
    return {channel(16), channel(8), channel(0)};
  }

  void readAscii() {
    std::string line;
    std::vector<double> values;
    for (uint64_t found = 0; found < points_;) {
      if (!nextLine(line)) {
        failShort();
      }
      values.clear();
      const char* first = line.data();
      const char* const end = first + line.size();
      const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
      while (true) {
        first = std::find_if_not(first, end, isBlank);
        const char* const last = std::find_if(first, end, isBlank);
        if (first == last) {
          break;
        }
        double number = 0;
        const auto [stop, error] = std::from_chars(*first == '+' ? first + 1 : first, last, number);
        if (error == std::errc::invalid_argument || stop != last || values.size() == columns_) {
          failLine();
        }
        values.push_back(number);
        first = last;
      }
      if (values.empty()) {
        continue;
      }
      if (values.size() != columns_) {
        failLine();
      }
      const auto value = [&](size_t field) { return values[fields_[field].column]; };
      addPoint(value, [&](size_t field) { return bitsOf(value(field), fields_[field].type); });
      ++found;
    }
  }

  [[noreturn]] void failLine() {
    fail("line " + std::to_string(lines_) + " does not have " + std::to_string(columns_) + " numbers",
         "repair or leave out this line");
  }

  uint64_t bytesLeft() {
    const std::streamoff at = stream_.tellg();
    return at < 0 || static_cast<uint64_t>(at) > size_ ? 0 : size_ - static_cast<uint64_t>(at);
  }

  void readBytes(std::span<std::byte> bytes) {
    stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<size_t>(stream_.gcount()) != bytes.size()) {
      failShort();
    }
  }

  void readBinary() {
    if (points_ > bytesLeft() / pointBytes_) {
      failShort();
    }
    constexpr uint64_t kPointsAtOnce = 1024;
    std::vector<std::byte> rows(std::min(points_, kPointsAtOnce) * pointBytes_);
    for (uint64_t done = 0; done < points_;) {
      const uint64_t count = std::min(points_ - done, kPointsAtOnce);
      readBytes(std::span(rows).first(count * pointBytes_));
      for (uint64_t i = 0; i < count; ++i) {
        const std::byte* row = rows.data() + i * pointBytes_;
        addPoint([&](size_t field) { return valueAt(row + fields_[field].offset, fields_[field]); },
                 [&](size_t field) { return bitsAt(row + fields_[field].offset); });
      }
      done += count;
    }
  }

  /// All values of one field, then all of the next.
  void readCompressed() {
    std::array<uint32_t, 2> sizes{};  // compressed, and not
    readBytes(std::as_writable_bytes(std::span(sizes)));
    if (sizes[0] > bytesLeft()) {
      failShort();
    }
    if (sizes[1] != points_ * pointBytes_ || sizes[1] / kMaxLzfCopy > sizes[0]) {
      fail("the size of the compressed points is not that of " + std::to_string(points_) + " points");
    }
    std::vector<std::byte> compressed(sizes[0]);
    readBytes(compressed);
    const auto values = lzfDecompressed(compressed, sizes[1]);
    if (!values) {
      fail("the compressed points are damaged", "copy or write the file again");
    }
    for (uint64_t i = 0; i < points_; ++i) {
      const auto bytesOf = [&](const PcdField& field) {
        return values->data() + field.offset * points_ + i * field.bytes * field.count;
      };
      addPoint([&](size_t field) { return valueAt(bytesOf(fields_[field]), fields_[field]); },
               [&](size_t field) { return bitsAt(bytesOf(fields_[field])); });
    }
  }

  std::istream& stream_;
  uint64_t size_;
  const std::string& where_;
  size_t lines_ = 0;
  std::vector<PcdField> fields_;
  uint64_t width_ = 0;
  uint64_t height_ = 1;
  uint64_t points_ = 0;
  bool hasPoints_ = false;
  std::string data_;
  uint64_t pointBytes_ = 0;
  uint64_t columns_ = 0;
  PcdSlots slots_;
  bool hasNormals_ = false;
  PointCloud cloud_;
};

}  // namespace

bool isPcdFile(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".pcd";
}

PointCloud readPcdPoints(const std::filesystem::path& path) {
  std::error_code error;
  const uint64_t bytes = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) {
    throw InputError("cannot open this file", path.string(), "check that it exists and may be read");
  }
  return readPcdPoints(stream, bytes, path.string());
}

PointCloud readPcdPoints(std::istream& stream, uint64_t size, const std::string& where) {
  return PcdReader(stream, size, where).read();
}

}  // namespace ocelli
