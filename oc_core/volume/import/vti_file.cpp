#include "oc_core/volume/import/vti_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/number_list.h"
#include "oc_core/volume/import/volume_reader_rows.h"

namespace ocelli {
namespace {

constexpr uint64_t kMaxXmlBytes = 1 << 30;
constexpr const char* kVtiExportAgain = "the file is damaged or of another kind: export it again";
constexpr std::string_view kAppendedTag = "<AppendedData";
constexpr std::string_view kGhostArray = "vtkGhostType";  // of VTK itself

struct VtiTypeRow {
  std::string_view name;
  StoredType type;
};

constexpr std::array<VtiTypeRow, 10> kVtiTypes{{{"UInt8", StoredType::kUint8},
                                                {"Int8", StoredType::kInt8},
                                                {"UInt16", StoredType::kUint16},
                                                {"Int16", StoredType::kInt16},
                                                {"UInt32", StoredType::kUint32},
                                                {"Int32", StoredType::kInt32},
                                                {"Float32", StoredType::kFloat32},
                                                {"Float64", StoredType::kFloat64},
                                                {"UInt64", StoredType::kUint64},
                                                {"Int64", StoredType::kInt64}}};

/// The XML of a file without what is appended to it, which is none.
struct VtiXml {
  std::string text;
  uint64_t appended = 0;  ///< where it begins in the file: behind its "_"; 0 where there is none
};

VtiXml readVtiXml(const ByteSource& source) {
  VtiXml xml;
  size_t searched = 0;
  size_t tag = std::string::npos;
  while (tag == std::string::npos) {
    constexpr uint64_t kPiece = 1 << 16;
    const uint64_t count = std::min(kPiece, source.size() - xml.text.size());
    if (count == 0) {
      return xml;
    }
    if (xml.text.size() + count > kMaxXmlBytes) {
      throw InputError("the XML of this file is larger than 1 GiB", source.name(),
                       "write it with appended data, in raw encoding");
    }
    const size_t before = xml.text.size();
    xml.text.resize(before + static_cast<size_t>(count));
    source.read(before, std::as_writable_bytes(std::span(xml.text)).subspan(before));
    tag = xml.text.find(kAppendedTag, searched);
    searched = xml.text.size() - std::min(xml.text.size(), kAppendedTag.size());
  }
  // Whatever follows the tag: its attributes, white space and the mark.
  constexpr uint64_t kMaxTagBytes = 1024;
  std::string after(static_cast<size_t>(std::min(kMaxTagBytes, source.size() - tag)), '\0');
  source.read(tag, std::as_writable_bytes(std::span(after)));
  const size_t close = after.find('>');
  const size_t mark = close == std::string::npos ? close : after.find_first_not_of(" \t\r\n", close + 1);
  if (mark == std::string::npos || after[mark] != '_') {
    throw InputError("the appended data do not begin with \"_\"", source.name(), kVtiExportAgain);
  }
  xml.text.resize(tag);
  xml.text += after.substr(0, close + 1) + "</AppendedData></VTKFile>";
  xml.appended = tag + mark + 1;
  return xml;
}

class VtiParser {
 public:
  explicit VtiParser(const ByteSource& source) : source_(source), xml_(readVtiXml(source)) {}

  VtiHeader parse() {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(xml_.text.data(), xml_.text.size());
    if (!result) {
      fail(fmt::format("this is no sound XML ({} at byte {})", result.description(), result.offset));
    }
    const pugi::xml_node file = document.child("VTKFile");
    const std::string type = file.attribute("type").value();
    if (type != "ImageData") {
      fail(fmt::format("this is no image data of VTK, but \"{}\"", type.empty() ? "other XML" : type));
    }
    setEncoding(file);
    const pugi::xml_node image = file.child("ImageData");
    const pugi::xml_node piece = image.child("Piece");
    if (!piece || piece.next_sibling("Piece")) {
      fail(piece ? "the volume comes in several pieces" : "there is no Piece",
           piece ? "write it in one piece (in ParaView, apply Merge Blocks first)" : kVtiExportAgain);
    }
    const pugi::xml_node array = chooseArray(piece);
    setGrid(image, piece, std::string_view(array.parent().name()) == "CellData");
    setArray(file, array);
    if (image.child("FieldData") || piece.child("FieldData")) {
      header_.record.warnings.emplace_back("what the file says in FieldData is not kept");
    }
    header_.record.facts.format = "VTI";
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& next = kVtiExportAgain) const {
    throw InputError(what, source_.name(), next);
  }

  void setEncoding(const pugi::xml_node& file) {
    const std::string order = file.attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") {
      fail(fmt::format("byte_order is \"{}\"", order));
    }
    header_.encoding.isSwapped = order == "BigEndian";
    const std::string words = file.attribute("header_type").as_string("UInt32");
    if (words != "UInt32" && words != "UInt64") {
      fail(fmt::format("header_type is \"{}\"", words));
    }
    header_.encoding.wordBytes = words == "UInt64" ? 8 : 4;
    const std::string compressor = file.attribute("compressor").value();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      fail(fmt::format("arrays are compressed by {}", compressor), "write them with zlib, or without compression");
    }
    header_.encoding.isDeflated = !compressor.empty();
  }

  /// The active scalars, those of points first; else the first array of one number each. The others are named.
  pugi::xml_node chooseArray(const pugi::xml_node& piece) {
    std::vector<pugi::xml_node> scalars;
    pugi::xml_node active;
    size_t vectors = 0;
    for (const char* kind : {"PointData", "CellData"}) {
      const pugi::xml_node data = piece.child(kind);
      const std::string_view name = data.attribute("Scalars").value();
      for (const pugi::xml_node& array : data.children("DataArray")) {
        if (std::string_view(array.attribute("Name").value()) == kGhostArray) {
          header_.record.warnings.push_back(
              fmt::format("{}, which says which voxels are hidden, is not kept", kGhostArray));
          continue;
        }
        if (array.attribute("NumberOfComponents").as_int(1) != 1) {
          ++vectors;
          continue;
        }
        scalars.push_back(array);
        if (!active && !name.empty() && name == array.attribute("Name").value()) {
          active = array;
        }
      }
    }
    if (scalars.empty()) {
      fail(vectors > 0 ? "all arrays have several numbers a voxel, such as colours or vectors" : "there is no array",
           vectors > 0 ? "write one with one number a voxel, such as a magnitude" : kVtiExportAgain);
    }
    const pugi::xml_node chosen = active ? active : scalars.front();
    if (scalars.size() + vectors > 1) {
      header_.record.warnings.push_back(
          fmt::format("of {} arrays, \"{}\" is taken", scalars.size() + vectors, chosen.attribute("Name").value()));
    }
    return chosen;
  }

  template <size_t Count>
  std::array<double, Count> numbers(const pugi::xml_node& node, const char* name,
                                    const std::array<double, Count>* otherwise = nullptr) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute && otherwise != nullptr) {
      return *otherwise;
    }
    const std::string_view text = attribute.value();
    const std::optional<std::vector<double>> read = numbersFromText(text, " \t\r\n");
    if (!read || read->size() != Count) {
      fail(fmt::format("{} of {} is \"{}\", and must be {} numbers", name, node.name(), text, Count));
    }
    std::array<double, Count> numbers{};
    std::copy(read->begin(), read->end(), numbers.begin());
    return numbers;
  }

  void setGrid(const pugi::xml_node& image, const pugi::xml_node& piece, bool isOfCells) {
    const auto extent = numbers<6>(piece, "Extent");
    const std::array<double, 3> zeros{};
    const std::array<double, 3> ones{1, 1, 1};
    const std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const auto origin = numbers<3>(image, "Origin", &zeros);
    const auto spacing = numbers<3>(image, "Spacing", &ones);
    const auto direction = numbers<9>(image, "Direction", &identity);
    glm::dvec3 size;
    glm::dvec3 first;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = extent[2 * axis] + (isOfCells ? 0.5 : 0);
      size[axis] = extent[2 * axis + 1] - extent[2 * axis] + (isOfCells ? 0 : 1);
      if (extent[2 * axis] != std::floor(extent[2 * axis]) || size[axis] != std::floor(size[axis])) {
        fail("Extent of Piece has a number that is not whole");
      }
    }
    checkVolumeSize(size, 1, source_.name());
    VolumeGrid& grid = header_.record.grid;
    grid.size = glm::ivec3(size);
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        grid.worldFromIndex[column][row] = direction[3 * row + column] * spacing[column];
      }
    }
    const glm::dvec3 start = glm::dmat3(grid.worldFromIndex) * first;
    grid.worldFromIndex[3] = glm::dvec4(origin[0] + start.x, origin[1] + start.y, origin[2] + start.z, 1);
  }

  void setArray(const pugi::xml_node& file, const pugi::xml_node& array) {
    const std::string type = array.attribute("type").value();
    const auto* row = std::find_if(kVtiTypes.begin(), kVtiTypes.end(), [&](const auto& r) { return r.name == type; });
    if (row == kVtiTypes.end()) {
      fail(fmt::format("voxels of type \"{}\" are not read", type),
           "convert them to one of Int8 to Int64, UInt8 to UInt64, Float32 and Float64");
    }
    header_.type = row->type;
    const std::string format = array.attribute("format").as_string("ascii");
    if (format == "appended") {
      setAppended(file, array);
      return;
    }
    if (format != "ascii" && format != "binary") {
      fail(fmt::format("the format of the array is \"{}\"", format), "write it as ascii, binary or appended");
    }
    header_.isText = format == "ascii";
    header_.isInline = true;
    header_.encoding.isBase64 = true;
    header_.content = array.text().get();
  }

  void setAppended(const pugi::xml_node& file, const pugi::xml_node& array) {
    const std::string encoding = file.child("AppendedData").attribute("encoding").as_string("base64");
    if (xml_.appended == 0) {
      fail("the array is appended data, and the file has none");
    }
    if (encoding != "raw" && encoding != "base64") {
      fail(fmt::format("the encoding of appended data is \"{}\"", encoding), "write it as raw or base64");
    }
    header_.encoding.isBase64 = encoding == "base64";
    const std::string_view text = array.attribute("offset").value();
    const std::optional<uint64_t> offset = numberFromText<uint64_t>(text);
    if (!offset || *offset > source_.size() - xml_.appended) {
      fail(fmt::format("the offset \"{}\" of the array is not in the file", text));
    }
    header_.offset = xml_.appended + *offset;
  }

  const ByteSource& source_;
  VtiXml xml_;
  VtiHeader header_;
};

template <class Number>
void appendNumber(std::string_view token, VoxelWriter& writer, const std::string& where) {
  const std::optional<Number> number = numberFromText<Number>(token);
  if (!number) {
    throw InputError(fmt::format("\"{}\" is no number of the array's type", token.substr(0, 40)), where,
                     kVtiExportAgain);
  }
  writer.append(std::as_bytes(std::span(&*number, 1)), where);
}

void appendNumberOf(StoredType type, std::string_view token, VoxelWriter& writer, const std::string& where) {
  switch (type) {
    case StoredType::kUint8:
      return appendNumber<uint8_t>(token, writer, where);
    case StoredType::kInt8:
      return appendNumber<int8_t>(token, writer, where);
    case StoredType::kUint16:
      return appendNumber<uint16_t>(token, writer, where);
    case StoredType::kInt16:
      return appendNumber<int16_t>(token, writer, where);
    case StoredType::kUint32:
      return appendNumber<uint32_t>(token, writer, where);
    case StoredType::kInt32:
      return appendNumber<int32_t>(token, writer, where);
    case StoredType::kFloat32:
      return appendNumber<float>(token, writer, where);
    case StoredType::kFloat64:
      return appendNumber<double>(token, writer, where);
    case StoredType::kUint64:
      return appendNumber<uint64_t>(token, writer, where);
    case StoredType::kInt64:
      return appendNumber<int64_t>(token, writer, where);
  }
}

void appendText(const VtiHeader& header, VoxelWriter& writer, const std::string& where) {
  constexpr const char* kSpace = " \t\r\n";
  const std::string_view text = header.content;
  for (size_t at = text.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    if (writer.missingBytes() == 0) {
      throw InputError("the array has more numbers than its extent has voxels", where, kVtiExportAgain);
    }
    appendNumberOf(header.type, text.substr(at, end - at), writer, where);
    at = text.find_first_not_of(kSpace, end);
  }
}

}  // namespace

VtiHeader parseVti(const ByteSource& source) {
  return VtiParser(source).parse();
}

void placeVtiVoxels(VtiHeader& header, const ByteSource& source, const std::string& path, ScratchOutput& scratch) {
  VolumeRecord& record = header.record;
  const uint64_t bytes = record.grid.voxelCount() * bytesOf(header.type);
  if (!header.isInline && !header.encoding.isBase64 && !header.encoding.isDeflated) {
    const VtiEncoding& encoding = header.encoding;
    const uint64_t seen = readVtiWord(encoding, source, header.offset);
    if (seen != bytes) {
      throw InputError(fmt::format("the array has {} bytes, and its extent and type need {}", seen, bytes),
                       source.name(), "copy or export the file again");
    }
    placeVoxels(record, 1, {header.type, encoding.isSwapped, header.offset + encoding.wordBytes}, source, path,
                scratch);
    return;
  }
  // Text has a character a number at least, and a space; zlib makes no more than 1032 bytes of one.
  constexpr uint64_t kMaxMadeOfByte = 1032 * 8;
  if (bytes / kMaxMadeOfByte > source.size()) {
    throw InputError(fmt::format("the header says {} bytes of voxels, far more than the file can hold", bytes),
                     source.name(), "copy or export the file again");
  }
  scratch.expect(record.grid.voxelCount() * bytesOf(voxelTypeOf(header.type)));
  VoxelWriter writer(record, 1, header.type, header.encoding.isSwapped && !header.isText, scratch);
  const ByteSink sink = [&](std::span<const std::byte> some) { writer.append(some, source.name()); };
  if (header.isText) {
    appendText(header, writer, source.name());
  } else if (header.isInline) {
    const MemorySource content(std::as_bytes(std::span(header.content)), source.name());
    decodeVtiArray(header.encoding, content, 0, bytes, sink);
  } else {
    decodeVtiArray(header.encoding, source, header.offset, bytes, sink);
  }
  writer.finish(source.name());
}

VolumeRecord readVti(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const std::filesystem::path& path = task.path;
  const FileSource source(path, budget);
  VtiHeader header = parseVti(source);
  placeVtiVoxels(header, source, path.string(), scratch);
  return header.record;
}

}  // namespace ocelli
