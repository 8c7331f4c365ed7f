#include "oc_core/scene/ply_header.h"

#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli::ply {
namespace {

constexpr size_t kMaxHeaderLines = 10'000;
constexpr size_t kMaxLineBytes = 10'000;

std::optional<Type> typeNamed(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Type>, 16> kNames{{{"char", Type::kInt8},
                                                                        {"int8", Type::kInt8},
                                                                        {"uchar", Type::kUint8},
                                                                        {"uint8", Type::kUint8},
                                                                        {"short", Type::kInt16},
                                                                        {"int16", Type::kInt16},
                                                                        {"ushort", Type::kUint16},
                                                                        {"uint16", Type::kUint16},
                                                                        {"int", Type::kInt32},
                                                                        {"int32", Type::kInt32},
                                                                        {"uint", Type::kUint32},
                                                                        {"uint32", Type::kUint32},
                                                                        {"float", Type::kFloat32},
                                                                        {"float32", Type::kFloat32},
                                                                        {"double", Type::kFloat64},
                                                                        {"float64", Type::kFloat64}}};
  for (const auto& [known, type] : kNames) {
    if (name == known) {
      return type;
    }
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::istream& stream, const std::string& where) : stream_(stream), where_(where) {}

  Header read() {
    if (nextLine() != "ply") {
      fail("this does not start with 'ply'");
    }
    bool hasFormat = false;
    for (std::string line = nextLine(); line != "end_header"; line = nextLine()) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "format") {
        readFormat(words);
        hasFormat = true;
      } else if (keyword == "element") {
        readElement(words);
      } else if (keyword == "property") {
        readProperty(words);
      } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        fail("unknown keyword '" + keyword + "'");
      }
    }
    if (!hasFormat) {
      fail("the header names no format");
    }
    return header_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what, where_ + ", line " + std::to_string(line_), "export the mesh again as PLY, or convert it");
  }

  std::string nextLine() {
    if (++line_ > kMaxHeaderLines) {
      fail("the header has no end");
    }
    std::string line;
    for (int c = stream_.get(); c != '\n'; c = stream_.get()) {
      if (c == std::istream::traits_type::eof()) {
        fail("the file ends within the header");
      }
      if (line.size() == kMaxLineBytes) {
        fail("this line of the header is too long");
      }
      line += static_cast<char>(c);
    }
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) {
      line.pop_back();
    }
    return line;
  }

  void readFormat(std::istream& words) {
    std::string name;
    words >> name;
    if (name == "ascii") {
      header_.encoding = Encoding::kAscii;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::kBigEndian;
    } else {
      fail("unknown format '" + name + "'");
    }
  }

  void readElement(std::istream& words) {
    Element element;
    std::string count;
    words >> element.name >> count;
    const auto number = numberFromText<decltype(element.count)>(count);
    if (!number) {
      fail("'" + count + "' is not a number of elements");
    }
    element.count = *number;
    header_.elements.push_back(element);
  }

  void readProperty(std::istream& words) {
    if (header_.elements.empty()) {
      fail("a property stands before the first element");
    }
    Property property;
    std::string type;
    words >> type;
    if (type == "list") {
      property.isList = true;
      words >> type;
      property.countType = parseType(type);
      if (property.countType == Type::kFloat32 || property.countType == Type::kFloat64) {
        fail("the length of a list is not a whole number");
      }
      words >> type;
    }
    property.type = parseType(type);
    words >> property.name;
    if (property.name.empty()) {
      fail("a property has no name");
    }
    header_.elements.back().properties.push_back(property);
  }

  Type parseType(const std::string& name) const {
    const std::optional<Type> type = typeNamed(name);
    if (!type) {
      fail("unknown type '" + name + "'");
    }
    return *type;
  }

  std::istream& stream_;
  const std::string& where_;
  size_t line_ = 0;
  Header header_;
};

}  // namespace

size_t byteSize(Type type) {
  switch (type) {
    case Type::kInt8:
    case Type::kUint8:
      return 1;
    case Type::kInt16:
    case Type::kUint16:
      return 2;
    case Type::kInt32:
    case Type::kUint32:
    case Type::kFloat32:
      return 4;
    case Type::kFloat64:
      return 8;
  }
  return 0;
}

uint64_t Element::minRowBytes(Encoding encoding) const {
  uint64_t bytes = 0;
  for (const Property& property : properties) {
    // In ascii, a digit and what parts it from the next.
    bytes += encoding == Encoding::kAscii ? 2 : byteSize(property.isList ? property.countType : property.type);
  }
  return bytes;
}

Header readHeader(std::istream& stream, const std::string& where) {
  return HeaderReader(stream, where).read();
}

}  // namespace ocelli::ply
