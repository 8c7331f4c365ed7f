#include "oc_core/volume/import/meta_image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/trimmed.h"
#include "oc_core/volume/import/number_list.h"
#include "oc_core/volume/import/volume_reader_rows.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxHeaderBytes = 1 << 20;
constexpr const char* kExportAgain = "the header is damaged or of another kind: export the file again";

struct MetaTypeRow {
  std::string_view name;
  StoredType type;
};

constexpr std::array<MetaTypeRow, 12> kMetaTypes{{{"MET_UCHAR", StoredType::kUint8},
                                                  {"MET_CHAR", StoredType::kInt8},
                                                  {"MET_USHORT", StoredType::kUint16},
                                                  {"MET_SHORT", StoredType::kInt16},
                                                  {"MET_UINT", StoredType::kUint32},
                                                  {"MET_INT", StoredType::kInt32},
                                                  {"MET_ULONG", StoredType::kUint32},  // 4 bytes in MetaIO's files
                                                  {"MET_LONG", StoredType::kInt32},
                                                  {"MET_ULONG_LONG", StoredType::kUint64},
                                                  {"MET_LONG_LONG", StoredType::kInt64},
                                                  {"MET_FLOAT", StoredType::kFloat32},
                                                  {"MET_DOUBLE", StoredType::kFloat64}}};

/// What is read of it, or says nothing that a volume of scalars could keep.
constexpr std::array<std::string_view, 34> kKnownFields{"ObjectType",
                                                        "ObjectSubType",
                                                        "NDims",
                                                        "DimSize",
                                                        "BinaryData",
                                                        "BinaryDataByteOrderMSB",
                                                        "ElementByteOrderMSB",
                                                        "CompressedData",
                                                        "CompressedDataSize",
                                                        "CompressionLevel",
                                                        "TransformMatrix",
                                                        "Rotation",
                                                        "Orientation",
                                                        "Offset",
                                                        "Position",
                                                        "Origin",
                                                        "CenterOfRotation",
                                                        "AnatomicalOrientation",
                                                        "ElementSpacing",
                                                        "ElementSize",
                                                        "ElementType",
                                                        "ElementNumberOfChannels",
                                                        "ElementDataFile",
                                                        "ElementMin",
                                                        "ElementMax",
                                                        "ElementNBits",
                                                        "ElementToIntensityFunctionSlope",
                                                        "ElementToIntensityFunctionOffset",
                                                        "HeaderSize",
                                                        "Modality",
                                                        "DistanceUnits",
                                                        "Comment",
                                                        "ID",
                                                        "Name"};

class MetaImageFields {
 public:
  explicit MetaImageFields(const ByteSource& source) : where_(source.name()) {
    std::vector<std::byte> bytes(static_cast<size_t>(std::min<uint64_t>(source.size(), kMaxHeaderBytes)));
    source.read(0, bytes);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    size_t begin = 0;
    for (int line = 1;; ++line) {
      const size_t end = text.find('\n', begin);
      if (begin >= text.size()) {
        break;
      }
      add(std::string(text.substr(begin, std::min(end, text.size()) - begin)), line);
      begin = end == std::string_view::npos ? text.size() : end + 1;
      if (values_.count("ElementDataFile") != 0) {
        end_ = begin;
        rest_ = text.substr(std::min(begin, text.size()));
        return;
      }
    }
    fail("there is no ElementDataFile, which ends the header", kExportAgain);
  }

  [[noreturn]] void fail(const std::string& what, const std::string& next) const {
    throw InputError(what, where_, next);
  }

  uint64_t end() const { return end_; }
  const std::string& rest() const { return rest_; }
  const std::map<std::string, std::string>& all() const { return values_; }

  bool has(const std::string& name) const { return values_.count(name) != 0; }
  std::string text(const std::string& name, const std::string& otherwise = "") const {
    const auto at = values_.find(name);
    return at == values_.end() ? otherwise : at->second;
  }
  /// Of the first of these names that there is; empty where there is none.
  std::vector<double> numbers(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (has(name)) {
        return numbersOf(name);
      }
    }
    return {};
  }
  double number(const char* name, double otherwise) const {
    const std::vector<double> numbers = this->numbers({name});
    if (numbers.size() > 1) {
      fail(fmt::format("{} has several numbers", name), kExportAgain);
    }
    return numbers.empty() ? otherwise : numbers.front();
  }
  bool flag(const char* name) const {
    const std::string value = text(name, "False");
    return value.starts_with('T') || value.starts_with('t') || value == "1";
  }

 private:
  void add(const std::string& line, int number) {
    if (trimmed(line).empty()) {
      return;
    }
    const size_t equals = line.find_first_of("=:");
    const std::string name(trimmed(std::string_view(line).substr(0, equals)));
    if (equals == std::string::npos || name.empty()) {
      fail(fmt::format("line {} of the header is not \"Name = value\"", number), kExportAgain);
    }
    if (!values_.emplace(name, trimmed(std::string_view(line).substr(equals + 1))).second) {
      fail(fmt::format("line {} of the header repeats {}", number, name), kExportAgain);
    }
  }

  std::vector<double> numbersOf(const std::string& name) const {
    const std::optional<std::vector<double>> numbers = numbersFromText(text(name), " \t");
    if (!numbers) {
      fail(fmt::format("{} = {}: these are no numbers", name, text(name)), kExportAgain);
    }
    return *numbers;
  }

  std::string where_;
  std::map<std::string, std::string> values_;
  uint64_t end_ = 0;
  std::string rest_;  ///< of what was read: what follows the header
};

StoredType storedTypeOf(const MetaImageFields& fields) {
  const std::string name = fields.text("ElementType");
  const auto* row = std::find_if(kMetaTypes.begin(), kMetaTypes.end(), [&](const auto& r) { return r.name == name; });
  if (row == kMetaTypes.end()) {
    std::string known;
    for (const MetaTypeRow& type : kMetaTypes) {
      known += (known.empty() ? "" : ", ") + std::string(type.name);
    }
    fields.fail(fmt::format("voxels of ElementType {} are not read", name.empty() ? "(missing)" : name),
                "convert them to one of " + known);
  }
  return row->type;
}

/// The letters that MetaIO writes for axes that run along the columns of a matrix, whose frame is LPS: each the side
/// where its axis comes from. "RAI" for the identity.
std::string anatomicalLetters(const glm::dmat4& worldFromIndex) {
  constexpr std::array<std::array<char, 2>, 3> kFrom{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  std::string letters;
  for (int column = 0; column < 3; ++column) {
    int along = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(worldFromIndex[column][axis]) > std::abs(worldFromIndex[column][along])) {
        along = axis;
      }
    }
    letters += kFrom[along][worldFromIndex[column][along] < 0 ? 1 : 0];
  }
  return letters;
}

/// Sizes of the axes; 3 of them, or 4 with that of time.
std::vector<double> sizesOf(const MetaImageFields& fields) {
  const double dimensions = fields.number("NDims", 0);
  if (dimensions != 3 && dimensions != 4) {
    fields.fail(fmt::format("the file has {} dimensions", dimensions),
                "give a volume, of 3, or one at several times, of 4 dimensions");
  }
  std::vector<double> sizes = fields.numbers({"DimSize"});
  if (static_cast<double>(sizes.size()) != dimensions) {
    fields.fail(fmt::format("DimSize has {} numbers, and NDims is {}", sizes.size(), dimensions), kExportAgain);
  }
  for (const double size : sizes) {
    if (size != std::floor(size)) {
      fields.fail("DimSize has a number that is not whole", kExportAgain);
    }
  }
  return sizes;
}

void setGeometry(const MetaImageFields& fields, size_t dimensions, MetaImageHeader& header) {
  const auto ofDimensions = [&](std::initializer_list<const char*> names, size_t count) {
    std::vector<double> numbers = fields.numbers(names);
    if (!numbers.empty() && numbers.size() != count) {
      fields.fail(fmt::format("{} has {} numbers, and must have {}", *names.begin(), numbers.size(), count),
                  kExportAgain);
    }
    return numbers;
  };
  std::vector<double> spacing = ofDimensions({"ElementSpacing", "ElementSize"}, dimensions);
  std::vector<double> matrix = ofDimensions({"TransformMatrix", "Rotation", "Orientation"}, dimensions * dimensions);
  std::vector<double> origin = ofDimensions({"Offset", "Position", "Origin"}, dimensions);
  const std::vector<double> center = ofDimensions({"CenterOfRotation"}, dimensions);
  VolumeRecord& record = header.record;
  if (spacing.empty()) {
    spacing.assign(dimensions, 1);
    record.warnings.emplace_back("the file does not say how far apart its voxels are: 1 is taken");
  }
  origin.resize(dimensions, 0);
  glm::dmat4& world = record.grid.worldFromIndex;
  for (size_t column = 0; column < 3; ++column) {
    for (size_t row = 0; row < 3; ++row) {
      // Each dimension of the file has `dimensions` numbers of the matrix, one after the other.
      const double direction = matrix.empty() ? (row == column ? 1 : 0) : matrix[column * dimensions + row];
      world[int(column)][int(row)] = direction * spacing[column];
    }
  }
  world[3] = glm::dvec4(origin[0], origin[1], origin[2], 1);
  if (!center.empty() && std::any_of(center.begin(), center.end(), [](double x) { return x != 0; })) {
    record.warnings.emplace_back(
        "the file names a centre of rotation, which is not kept: Offset says where voxel 0 is");
  }
  const std::string letters = fields.text("AnatomicalOrientation", "???");
  record.grid.isAnatomical = letters != "???" && letters != "UNKNOWN";
  record.grid.unit = fields.text("DistanceUnits", record.grid.isAnatomical ? "mm" : "");
  if (record.grid.isAnatomical && letters != anatomicalLetters(world)) {
    record.warnings.push_back(
        fmt::format("the file says AnatomicalOrientation = {}, but its TransformMatrix is {}: the "
                    "matrix is taken, as ITK does",
                    letters, anatomicalLetters(world)));
  }
  if (dimensions == 4 && header.volumes > 1) {
    for (uint64_t at = 0; at < header.volumes; ++at) {
      record.times.push_back(origin[3] + static_cast<double>(at) * spacing[3]);
    }
    if (!(spacing[3] > 0)) {
      fields.fail(fmt::format("the times of the volumes are {} apart", spacing[3]), kExportAgain);
    }
  }
}

std::string modalityOf(const std::string& text) {
  const std::string name = text.starts_with("MET_MOD_") ? text.substr(8) : text;
  return name == "UNKNOWN" || name == "OTHER" ? "" : name == "MRI" ? "MR" : name;
}

/// The names of the files of ElementDataFile: one, a list, or a pattern with its first and last number and its step.
std::vector<std::string> dataFilesOf(const MetaImageFields& fields, double slices) {
  const std::string name = fields.text("ElementDataFile");
  if (name == "LOCAL" || name == "Local" || name == "local") {
    return {};
  }
  std::vector<std::string> files;
  // A number may follow it, of the dimensions of each file.
  if (name == "LIST" || name.starts_with("LIST ") || name.starts_with("LIST\t")) {
    const std::string& rest = fields.rest();
    for (size_t begin = 0; begin < rest.size();) {
      const size_t end = std::min(rest.find('\n', begin), rest.size());
      if (std::string file(trimmed(std::string_view(rest).substr(begin, end - begin))); !file.empty()) {
        files.push_back(std::move(file));
      }
      begin = end + 1;
    }
    if (files.empty()) {
      fields.fail("ElementDataFile = LIST is followed by no names", kExportAgain);
    }
    return files;
  }
  const size_t percent = name.find('%');
  // What can be no conversion, such as that of "50%_ct.raw", is a part of a name.
  const bool isPattern = percent != std::string::npos && percent + 1 < name.size() &&
                         std::isalnum(static_cast<unsigned char>(name[percent + 1])) != 0;
  if (!isPattern) {
    return {name};
  }
  // "slice_%03d.raw 1 100 1"
  const size_t conversion = name.find('d', percent);
  const size_t space = name.find(' ', percent);
  std::array<int, 3> numbers{1, static_cast<int>(std::min(slices, 1e6)), 1};
  int width = 0;
  bool isSound = conversion != std::string::npos && (space == std::string::npos || conversion < space) &&
                 name.find('%', percent + 1) == std::string::npos;
  for (size_t at = percent + 1; isSound && at < conversion; ++at) {
    isSound = name[at] >= '0' && name[at] <= '9' && width < 10;
    width = 10 * width + (name[at] - '0');
  }
  const std::optional<std::vector<double>> given =
      numbersFromText(space == std::string::npos ? "" : name.substr(space), " ");
  isSound = isSound && given && given->size() <= numbers.size();
  for (size_t at = 0; isSound && at < given->size(); ++at) {
    const double number = (*given)[at];
    isSound = number == std::floor(number) && std::abs(number) < 1e9;
    numbers[at] = isSound ? static_cast<int>(number) : 0;
  }
  constexpr int kMaxFiles = 1'000'000;
  isSound = isSound && numbers[2] >= 1 && numbers[0] >= 0 && numbers[1] >= numbers[0] &&
            (numbers[1] - numbers[0]) / numbers[2] < kMaxFiles;
  if (!isSound) {
    fields.fail(fmt::format("ElementDataFile = {}: this pattern of names is not understood", name),
                "write it as NAME%03d.raw FIRST LAST STEP");
  }
  for (int64_t number = numbers[0]; number <= numbers[1]; number += numbers[2]) {
    files.push_back(fmt::format("{}{:0{}}{}", name.substr(0, percent), number, width,
                                name.substr(conversion + 1, std::min(space, name.size()) - conversion - 1)));
  }
  return files;
}

}  // namespace

MetaImageHeader parseMetaImage(const ByteSource& source) {
  const MetaImageFields fields(source);
  MetaImageHeader header;
  VolumeRecord& record = header.record;
  record.facts.format = "MetaImage";
  if (const std::string type = fields.text("ObjectType", "Image"); type != "Image") {
    fields.fail(fmt::format("ObjectType = {}: this is no image", type), "give a MetaImage of ObjectType Image");
  }
  const std::vector<double> sizes = sizesOf(fields);
  const double volumes = sizes.size() > 3 ? sizes[3] : 1;
  checkVolumeSize({sizes[0], sizes[1], sizes[2]}, volumes, source.name());
  record.grid.size = glm::ivec3(glm::dvec3(sizes[0], sizes[1], sizes[2]));
  header.volumes = static_cast<uint64_t>(volumes);
  header.voxels.type = storedTypeOf(fields);
  if (const double channels = fields.number("ElementNumberOfChannels", 1); channels != 1) {
    fields.fail(fmt::format("the voxels have {} numbers each, such as colours", channels),
                "give a volume of one number a voxel: convert colours to grey first");
  }
  if (fields.has("BinaryData") && !fields.flag("BinaryData")) {
    fields.fail("the voxels are written as text (BinaryData = False)", "export the file with binary data");
  }
  header.voxels.isSwapped =
      fields.flag(fields.has("ElementByteOrderMSB") ? "ElementByteOrderMSB" : "BinaryDataByteOrderMSB");
  header.voxels.isDeflated = fields.flag("CompressedData");
  record.scale = fields.number("ElementToIntensityFunctionSlope", 1);
  record.offset = fields.number("ElementToIntensityFunctionOffset", 0);
  record.facts.modality = modalityOf(fields.text("Modality"));
  setGeometry(fields, sizes.size(), header);
  header.files = dataFilesOf(fields, sizes[2] * volumes);
  const double headerSize = fields.number("HeaderSize", 0);
  if (headerSize < -1 || headerSize > 9e15 || headerSize != std::floor(headerSize)) {
    fields.fail(fmt::format("HeaderSize = {} is out of range", headerSize), kExportAgain);
  }
  header.isOffsetFromEnd = headerSize == -1;
  if (!header.isOffsetFromEnd) {
    header.voxels.offset = (header.files.empty() ? fields.end() : 0) + static_cast<uint64_t>(headerSize);
  } else if (header.voxels.isDeflated) {
    fields.fail("HeaderSize = -1 says that the voxels are the last bytes, which compressed ones cannot", kExportAgain);
  }
  std::string unknown;
  for (const auto& [name, value] : fields.all()) {
    if (std::find(kKnownFields.begin(), kKnownFields.end(), name) == kKnownFields.end()) {
      unknown += (unknown.empty() ? "" : ", ") + name;
    }
  }
  constexpr size_t kMaxShown = 200;
  if (!unknown.empty()) {
    record.warnings.push_back("what the file says of these is not kept: " + unknown.substr(0, kMaxShown) +
                              (unknown.size() > kMaxShown ? "..." : ""));
  }
  return header;
}

namespace {

uint64_t voxelsBegin(const MetaImageHeader& header, uint64_t bytes, const ByteSource& source) {
  if (!header.isOffsetFromEnd) {
    return header.voxels.offset;
  }
  return source.size() - std::min(bytes, source.size());
}

/// Voxels in several files, an equal share of them in each.
void appendFiles(const MetaImageHeader& header, const fs::path& folder, VolumeRecord& record, ScratchOutput& scratch,
                 ReadingBudget* budget, const std::string& where) {
  const uint64_t slices = header.volumes * static_cast<uint64_t>(record.grid.size.z);
  if (header.voxels.isDeflated || slices % header.files.size() != 0) {
    throw InputError(fmt::format("{} slices lie in {}{} files", slices, header.files.size(),
                                 header.voxels.isDeflated ? " compressed" : ""),
                     where, "write a file for each slice, without compression, or one for all");
  }
  const uint64_t each = slices / header.files.size() * static_cast<uint64_t>(record.grid.size.x) *
                        static_cast<uint64_t>(record.grid.size.y) * bytesOf(header.voxels.type);
  scratch.expect(header.volumes * record.grid.voxelCount() * bytesOf(voxelTypeOf(header.voxels.type)));
  VoxelWriter writer(record, header.volumes, header.voxels.type, header.voxels.isSwapped, scratch);
  std::vector<std::byte> piece(1 << 18);
  for (const std::string& name : header.files) {
    const FileSource source(folder / name, budget);
    uint64_t at = voxelsBegin(header, each, source);
    for (uint64_t left = each; left > 0;) {
      const auto count = static_cast<size_t>(std::min<uint64_t>(left, piece.size()));
      source.read(at, std::span(piece).first(count));
      writer.append(std::span(piece).first(count), source.name());
      at += count;
      left -= count;
    }
  }
  writer.finish(where);
}

}  // namespace

VolumeRecord readMetaImage(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const fs::path& path = task.path;
  const FileSource headerSource(path, budget);
  MetaImageHeader header = parseMetaImage(headerSource);
  VolumeRecord record = header.record;
  if (header.files.size() > 1) {
    appendFiles(header, path.parent_path(), record, scratch, budget, path.string());
    return record;
  }
  std::unique_ptr<FileSource> data;
  const fs::path dataPath = header.files.empty() ? path : path.parent_path() / header.files.front();
  if (!header.files.empty()) {
    std::error_code ignored;
    if (!fs::exists(dataPath, ignored)) {
      throw InputError(fmt::format("the voxels lie in {}, which is not there", header.files.front()), path.string(),
                       "copy this file, too, into the same folder");
    }
    data = std::make_unique<FileSource>(dataPath, budget);
  }
  const ByteSource& source = data ? *data : headerSource;
  header.voxels.offset =
      voxelsBegin(header, header.volumes * record.grid.voxelCount() * bytesOf(header.voxels.type), source);
  placeVoxels(record, header.volumes, header.voxels, source, dataPath.string(), scratch);
  return record;
}

}  // namespace ocelli
