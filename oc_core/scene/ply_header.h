// The header of a PLY file: which elements of which properties follow. For ply_read.cpp alone.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace ocelli::ply {

enum class Encoding { kAscii, kLittleEndian, kBigEndian };

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

size_t byteSize(Type type);

struct Property {
  std::string name;
  Type type = Type::kFloat32;
  bool isList = false;
  Type countType = Type::kUint8;  ///< of a list
};

struct Element {
  std::string name;
  uint64_t count = 0;
  std::vector<Property> properties;

  /// Bytes that one row takes at the least: what a file must have to be whole.
  uint64_t minRowBytes(Encoding encoding) const;
};

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
};

/// Reads from "ply" up to and including "end_header". Throws InputError naming `where` and the line.
Header readHeader(std::istream& stream, const std::string& where);

}  // namespace ocelli::ply
