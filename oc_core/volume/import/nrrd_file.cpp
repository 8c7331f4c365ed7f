// NRRD (.nrrd, .nhdr) through Teem, whose format it is: http://teem.sourceforge.net/nrrd/format.html
#include <fmt/format.h>
#include <teem/biff.h>
#include <teem/nrrd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/volume_reader_rows.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNrrdExportAgain = "the file is damaged or of another kind: export it again";

struct NrrdTypeRow {
  int nrrd;
  StoredType type;
};

constexpr std::array<NrrdTypeRow, 10> kNrrdTypes{{{nrrdTypeUChar, StoredType::kUint8},
                                                  {nrrdTypeChar, StoredType::kInt8},
                                                  {nrrdTypeUShort, StoredType::kUint16},
                                                  {nrrdTypeShort, StoredType::kInt16},
                                                  {nrrdTypeUInt, StoredType::kUint32},
                                                  {nrrdTypeInt, StoredType::kInt32},
                                                  {nrrdTypeFloat, StoredType::kFloat32},
                                                  {nrrdTypeDouble, StoredType::kFloat64},
                                                  {nrrdTypeULLong, StoredType::kUint64},
                                                  {nrrdTypeLLong, StoredType::kInt64}}};

/// Spaces that are those of patients, and what takes them to LPS: the signs of x and y.
struct NrrdSpaceRow {
  int space;
  double signX;
  double signY;
};

constexpr std::array<NrrdSpaceRow, 6> kPatientSpaces{{{nrrdSpaceRightAnteriorSuperior, -1, -1},
                                                      {nrrdSpaceLeftAnteriorSuperior, 1, -1},
                                                      {nrrdSpaceLeftPosteriorSuperior, 1, 1},
                                                      {nrrdSpaceRightAnteriorSuperiorTime, -1, -1},
                                                      {nrrdSpaceLeftAnteriorSuperiorTime, 1, -1},
                                                      {nrrdSpaceLeftPosteriorSuperiorTime, 1, 1}}};

/// The last sentence of Teem's account, which is the cause.
std::string teemMessage() {
  std::unique_ptr<char, decltype(&std::free)> all(biffGetDone(NRRD), &std::free);
  std::string text = all ? all.get() : "";
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
    text.pop_back();
  }
  text.erase(0, text.rfind('\n') + 1);
  const size_t name = text.find(": ");
  return text.starts_with("[nrrd]") && name != std::string::npos ? text.substr(name + 2) : text;
}

/// A file that Teem has read: its header, and the voxels where they were asked for.
class NrrdReading {
 public:
  NrrdReading(const fs::path& path, bool withVoxels) : nrrd_(nrrdNew()), state_(nrrdIoStateNew()) {
    state_->skipData = withVoxels ? 0 : 1;
    state_->keepNrrdDataFileOpen = withVoxels ? 0 : 1;
    if (nrrdLoad(nrrd_, path.c_str(), state_) != 0) {
      const std::string message = teemMessage();
      release();
      throw InputError("this is no NRRD file that can be read: " + message, path.string(), kNrrdExportAgain);
    }
  }
  ~NrrdReading() { release(); }
  NrrdReading(const NrrdReading&) = delete;
  NrrdReading& operator=(const NrrdReading&) = delete;

  const Nrrd& nrrd() const { return *nrrd_; }
  const NrrdIoState& state() const { return *state_; }

 private:
  void release() {
    if (state_->dataFile != nullptr) {
      std::fclose(state_->dataFile);
    }
    nrrdIoStateNix(state_);
    nrrdNuke(nrrd_);
  }

  Nrrd* nrrd_;
  NrrdIoState* state_;
};

class NrrdHeader {
 public:
  NrrdHeader(const Nrrd& nrrd, const std::string& where) : nrrd_(nrrd), where_(where) {
    chooseAxes();
    const auto sizeOf = [&](int axis) { return static_cast<double>(nrrd_.axis[axes_[size_t(axis)]].size); };
    const double count = time_ ? static_cast<double>(nrrd_.axis[*time_].size) : 1;
    checkVolumeSize({sizeOf(0), sizeOf(1), sizeOf(2)}, count, where_);
    record.grid.size = glm::ivec3(glm::dvec3(sizeOf(0), sizeOf(1), sizeOf(2)));
    volumes = static_cast<uint64_t>(count);
    record.facts.format = "NRRD";
    record.facts.valueUnit = text(nrrd_.sampleUnits);
    if (nrrd_.spaceDim > 0) {
      setSpace();
    } else {
      setSpacing();
    }
    setTimes();
    noteWhatIsNotKept();
  }

  VolumeRecord record;
  uint64_t volumes = 1;

 private:
  static std::string text(const char* text) { return text == nullptr ? "" : text; }

  [[noreturn]] void fail(const std::string& what, const std::string& next = kNrrdExportAgain) const {
    throw InputError(what, where_, next);
  }

  bool hasDirection(unsigned axis) const {
    return nrrd_.spaceDim > 0 && std::isfinite(nrrd_.axis[axis].spaceDirection[0]);
  }

  /// Three axes of space, and one of time behind them or none.
  void chooseAxes() {
    const std::vector<unsigned> axes = axesThatCount();
    if (axes.size() < 3 || axes.size() > 4) {
      fail(fmt::format("the file has {} dimensions", nrrd_.dim),
           "give a volume, of 3, or one at several times, of 4 dimensions");
    }
    for (size_t at = 0; at < 3; ++at) {
      checkIsOfSpace(axes[at], axes.size());
    }
    if (axes.size() == 4) {
      time_ = axes[3];
      const int kind = nrrd_.axis[axes[3]].kind;
      if (isOfRange(kind) && kind != nrrdKindList) {
        fail("the voxels have several numbers each, one volume after the other",
             fmt::format("give a volume of one number a voxel: unu slice -a {} -p 0 -i IN -o OUT takes the first one",
                         axes[3]));
      }
      if (kind != nrrdKindTime && kind != nrrdKindList) {
        record.warnings.emplace_back("the fourth axis is taken for time");
      }
    }
    axes_ = {axes[0], axes[1], axes[2]};
  }

  /// Those that are neither of space nor of more than one sample are left out, down to three; of more than four, all of
  /// one sample without a direction, the last first.
  std::vector<unsigned> axesThatCount() const {
    std::vector<unsigned> axes(nrrd_.dim);
    std::iota(axes.begin(), axes.end(), 0U);
    const auto isStub = [&](unsigned axis) {
      // Where nothing says what an axis between others is, it may be a volume's of one slice.
      const bool isEnd = axis == 0 || axis + 1 == nrrd_.dim;
      const int kind = nrrd_.axis[axis].kind;
      return nrrd_.axis[axis].size == 1 && !hasDirection(axis) && !isKindOfSpace(kind) &&
             (kind != nrrdKindUnknown || isEnd || isNotSpace(axis) || isBesideSpace(axis));
    };
    for (size_t at = axes.size(); at-- > 0 && axes.size() > 3;) {
      if (isStub(axes[at])) {
        axes.erase(axes.begin() + static_cast<ptrdiff_t>(at));
      }
    }
    for (size_t at = axes.size(); at-- > 0 && axes.size() > 4;) {
      if (nrrd_.axis[axes[at]].size == 1 && !hasDirection(axes[at])) {
        axes.erase(axes.begin() + static_cast<ptrdiff_t>(at));
      }
    }
    return axes;
  }

  /// Of one of the first three axes that count.
  void checkIsOfSpace(unsigned axis, size_t axes) {
    const int kind = nrrd_.axis[axis].kind;
    if (axes == 4 && isBesideSpace(axis)) {
      fail(fmt::format("axis {} of the file (the first is 0) has the kind none, and the three others are of space: "
                       "nothing says what it is",
                       axis),
           fmt::format("write its kind into the header: list or time, and move it to the end; or take the first of its "
                       "volumes: unu slice -a {} -p 0 -i IN -o OUT",
                       axis));
    }
    if (axes == 3 && kind == nrrdKindUnknown && spaceAxes() == 2) {
      record.warnings.push_back(
          fmt::format("axis {} of the file (the first is 0) has the kind none: it is taken for one of space", axis));
    }
    if (!isOfRange(kind) && kind != nrrdKindTime && !isNotSpace(axis)) {
      return;
    }
    const bool isOfTimes = kind == nrrdKindTime || kind == nrrdKindList;
    if (axes == 4 && isOfTimes) {
      std::string order;
      for (unsigned other = 0; other < nrrd_.dim; ++other) {
        order += other == axis ? "" : fmt::format("{} ", other);
      }
      fail(fmt::format("axis {} of the file (the first is 0) is that of the volumes, which must be the last", axis),
           fmt::format("move it to the end: unu permute -p {}{} -i IN -o OUT", order, axis));
    }
    if (axes == 4) {
      fail(fmt::format("the voxels have {} numbers each, such as colours or vectors", nrrd_.axis[axis].size),
           fmt::format("give a volume of one number a voxel: unu slice -a {} -p 0 -i IN -o OUT takes the first one",
                       axis));
    }
    fail(isOfTimes ? "the file has a plane at several times" : "the voxels have several numbers each, in a plane",
         "give a volume of one number a voxel, with three axes of space");
  }

  size_t spaceAxes() const {
    size_t count = 0;
    for (unsigned axis = 0; axis < nrrd_.dim; ++axis) {
      count += isKindOfSpace(nrrd_.axis[axis].kind) ? 1 : 0;
    }
    return count;
  }
  /// An axis without a kind in a file whose kinds name the three axes of space.
  bool isBesideSpace(unsigned axis) const { return nrrd_.axis[axis].kind == nrrdKindUnknown && spaceAxes() == 3; }
  static bool isKindOfSpace(int kind) { return kind == nrrdKindDomain || kind == nrrdKindSpace; }
  /// Of an axis along which the numbers of one voxel stand.
  static bool isOfRange(int kind) { return kind >= nrrdKindList; }
  /// Where the file has a space: an axis that has no direction in it.
  bool isNotSpace(unsigned axis) const { return nrrd_.spaceDim > 0 && !hasDirection(axis); }

  void setSpace() {
    glm::dvec2 signs(1);
    for (const NrrdSpaceRow& row : kPatientSpaces) {
      if (row.space == nrrd_.space) {
        record.grid.isAnatomical = true;
        signs = {row.signX, row.signY};
      }
    }
    if (nrrd_.space == nrrdSpaceScannerXYZ || nrrd_.space == nrrdSpaceScannerXYZTime) {
      record.warnings.emplace_back("the file's space is the scanner's, not the patient's: its axes stay as they are");
    }
    if (nrrd_.spaceDim < 3) {
      fail(fmt::format("the file's space has {} dimensions", nrrd_.spaceDim), "give a volume in a space of 3");
    }
    glm::dmat4& world = record.grid.worldFromIndex;
    for (int column = 0; column < 3; ++column) {
      const double* direction = nrrd_.axis[axes_[size_t(column)]].spaceDirection;
      world[column] = glm::dvec4(signs.x * direction[0], signs.y * direction[1], direction[2], 0);
    }
    glm::dvec3 origin(nrrd_.spaceOrigin[0], nrrd_.spaceOrigin[1], nrrd_.spaceOrigin[2]);
    if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(origin.z)) {
      origin = glm::dvec3(0);
      record.warnings.emplace_back("the file does not say where its first voxel is: the origin is taken");
    }
    world[3] = glm::dvec4(signs.x * origin.x, signs.y * origin.y, origin.z, 1);
    std::string unit = text(nrrd_.spaceUnits[0]);
    if (unit != text(nrrd_.spaceUnits[1]) || unit != text(nrrd_.spaceUnits[2])) {
      record.warnings.emplace_back("the axes of the file's space have several units, which are not kept");
      unit.clear();
    }
    if (unit.empty() && record.grid.isAnatomical) {
      unit = "mm";
    }
    record.grid.unit = unit == "\xc2\xb5m" || unit == "microns" ? "um" : unit;
  }

  /// Without a space: each axis by itself.
  void setSpacing() {
    bool isGuessed = false;
    std::string unit = text(nrrd_.axis[axes_[0]].units);
    for (int column = 0; column < 3; ++column) {
      const NrrdAxisInfo& axis = nrrd_.axis[axes_[size_t(column)]];
      const bool isCell = axis.center == nrrdCenterCell;
      const double intervals = static_cast<double>(axis.size) - (isCell ? 0 : 1);
      double spacing = axis.spacing;
      if (!std::isfinite(spacing) && std::isfinite(axis.min) && std::isfinite(axis.max) && intervals > 0) {
        spacing = (axis.max - axis.min) / intervals;
      }
      if (!std::isfinite(spacing)) {
        spacing = 1;
        isGuessed = true;
      }
      record.grid.worldFromIndex[column] = glm::dvec4(0);
      record.grid.worldFromIndex[column][column] = spacing;
      if (std::isfinite(axis.min)) {
        record.grid.worldFromIndex[3][column] = axis.min + (isCell ? spacing / 2 : 0);
      }
      unit = unit == text(axis.units) ? unit : "";
    }
    record.grid.unit = unit;
    if (isGuessed) {
      record.warnings.emplace_back("the file does not say how far apart its voxels are along each axis: 1 is taken");
    }
  }

  void setTimes() {
    if (!time_ || volumes < 2) {
      return;
    }
    const NrrdAxisInfo& axis = nrrd_.axis[*time_];
    double step = axis.spacing;
    double first = std::isfinite(axis.min) ? axis.min : 0;
    if (nrrd_.spaceDim > 3 && std::isfinite(axis.spaceDirection[3])) {
      step = axis.spaceDirection[3];
      first = std::isfinite(nrrd_.spaceOrigin[3]) ? nrrd_.spaceOrigin[3] : 0;
    }
    const bool isSeconds = text(axis.units).empty() || text(axis.units) == "s";
    const double unit = isSeconds ? 1 : text(axis.units) == "ms" ? 1e-3 : 0;
    step *= unit;
    first *= unit;
    if (!std::isfinite(step) || !(step > 0)) {
      record.warnings.emplace_back("the file does not say how many seconds its volumes are apart: 1 is taken");
      step = 1;
    }
    for (uint64_t at = 0; at < volumes; ++at) {
      record.times.push_back(first + static_cast<double>(at) * step);
    }
  }

  void noteWhatIsNotKept() {
    if (std::isfinite(nrrd_.oldMin) || std::isfinite(nrrd_.oldMax)) {
      record.warnings.push_back(
          fmt::format("the file's values were {:g} to {:g} before they became integers, which is "
                      "not undone",
                      nrrd_.oldMin, nrrd_.oldMax));
    }
    for (unsigned at = 0; at < nrrd_.kvpArr->len; ++at) {
      const std::string key = text(nrrd_.kvp[2 * at]);
      if (key == "modality" || key == "Modality") {
        record.facts.modality = text(nrrd_.kvp[2 * at + 1]);
      }
    }
  }

  const Nrrd& nrrd_;
  const std::string& where_;
  std::array<unsigned, 3> axes_{};
  std::optional<unsigned> time_;
};

StoredType storedTypeOf(const Nrrd& nrrd, const std::string& where) {
  for (const NrrdTypeRow& row : kNrrdTypes) {
    if (row.nrrd == nrrd.type) {
      return row.type;
    }
  }
  throw InputError("voxels that are blocks of bytes are not read", where, "convert them to integers or floats");
}

/// Voxels that Teem has decoded, from text, bzip2, or several files.
void placeDecoded(const fs::path& path, NrrdHeader& header, StoredType type, ScratchOutput& scratch,
                  ReadingBudget* budget) {
  const uint64_t bytes = header.volumes * header.record.grid.voxelCount() * bytesOf(type);
  scratch.expect(header.volumes * header.record.grid.voxelCount() * bytesOf(voxelTypeOf(type)));
  if (budget != nullptr) {
    budget->addMemory(2 * bytes);
  }
  const NrrdReading all(path, true);
  VoxelWriter writer(header.record, header.volumes, type, false, scratch);
  writer.append({static_cast<const std::byte*>(all.nrrd().data), bytes}, path.string());
  writer.finish(path.string());
}

}  // namespace

VolumeRecord readNrrd(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const fs::path& path = task.path;
  const std::string where = path.string();
  {
    const FileSource start(path, budget);
    std::array<char, 4> magic{};
    start.read(0, std::as_writable_bytes(std::span(magic)).first(std::min<uint64_t>(magic.size(), start.size())));
    if (std::string_view(magic.data(), magic.size()) != "NRRD") {
      throw InputError("this is no NRRD file: it does not begin with \"NRRD\"", where, kNrrdExportAgain);
    }
  }
  const NrrdReading reading(path, false);
  const NrrdIoState& state = reading.state();
  NrrdHeader header(reading.nrrd(), where);
  const StoredType type = storedTypeOf(reading.nrrd(), where);
  const bool isRaw = state.encoding == nrrdEncodingRaw;
  const bool isDeflated = state.encoding == nrrdEncodingGzip;
  if (isDeflated && state.byteSkip < 0) {
    throw InputError(fmt::format("byte skip {} says that the voxels are the last bytes, which compressed ones cannot",
                                 state.byteSkip),
                     where, "write the byte at which they begin");
  }
  if (state.dataFile == nullptr || (!isRaw && !isDeflated)) {
    placeDecoded(path, header, type, scratch, budget);
    return header.record;
  }
  // Teem leaves the file open where the voxels begin.
  const long offset = std::ftell(state.dataFile);
  std::error_code error;
  const fs::path data = fs::read_symlink("/proc/self/fd/" + std::to_string(fileno(state.dataFile)), error);
  if (offset < 0 || error) {
    throw InputError("the file with the voxels cannot be read", where, kNrrdExportAgain);
  }
  const FileSource source(data, budget);
  constexpr bool kIsLittle = std::endian::native == std::endian::little;
  const bool isSwapped = bytesOf(type) > 1 && state.endian == (kIsLittle ? airEndianBig : airEndianLittle);
  placeVoxels(header.record, header.volumes,
              {type, isSwapped, static_cast<uint64_t>(offset), isDeflated,
               isDeflated && state.byteSkip > 0 ? static_cast<uint64_t>(state.byteSkip) : 0},
              source, data.string(), scratch);
  return header.record;
}

}  // namespace ocelli
