// NIfTI-1 and NIfTI-2 (.nii, .nii.gz) through the reference library of the format: https://nifti.nimh.nih.gov
#include <fmt/format.h>
#include <nifti2_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/inflate.h"
#include "oc_core/volume/import/volume_reader_rows.h"

namespace ocelli {
namespace {

constexpr const char* kNiftiExportAgain = "the file is damaged or of another kind: export it again";

struct NiftiTypeRow {
  int nifti;
  StoredType type;
};

constexpr std::array<NiftiTypeRow, 10> kNiftiTypes{{{DT_UINT8, StoredType::kUint8},
                                                    {DT_INT8, StoredType::kInt8},
                                                    {DT_UINT16, StoredType::kUint16},
                                                    {DT_INT16, StoredType::kInt16},
                                                    {DT_UINT32, StoredType::kUint32},
                                                    {DT_INT32, StoredType::kInt32},
                                                    {DT_FLOAT32, StoredType::kFloat32},
                                                    {DT_FLOAT64, StoredType::kFloat64},
                                                    {DT_UINT64, StoredType::kUint64},
                                                    {DT_INT64, StoredType::kInt64}}};

using NiftiImage = std::unique_ptr<nifti_image, decltype(&nifti_image_free)>;

StoredType storedTypeOf(const nifti_image& image, const std::string& where) {
  for (const NiftiTypeRow& row : kNiftiTypes) {
    if (row.nifti == image.datatype) {
      return row.type;
    }
  }
  throw InputError(fmt::format("voxels of type {} are not read", nifti_datatype_to_string(image.datatype)), where,
                   "give a volume of one number a voxel, of 8 to 64 bits: convert colours and complex numbers first");
}

std::string unitOf(const nifti_image& image, VolumeRecord& record) {
  switch (image.xyz_units) {
    case NIFTI_UNITS_METER:
      return "m";
    case NIFTI_UNITS_MM:
      return "mm";
    case NIFTI_UNITS_MICRON:
      return "um";
    default:
      record.warnings.emplace_back("the file does not say in which unit its lengths are: mm is taken");
      return "mm";
  }
}

glm::dmat4 fromRows(const nifti_dmat44& rows) {
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = rows.m[row][column];
    }
  }
  return matrix;
}

void setGrid(const nifti_image& image, VolumeRecord& record) {
  record.grid.unit = unitOf(image, record);
  const glm::dmat4 lpsFromRas(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 1, 0),
                              glm::dvec4(0, 0, 0, 1));
  record.grid.isAnatomical = image.sform_code > 0 || image.qform_code > 0;
  if (record.grid.isAnatomical) {
    record.grid.worldFromIndex = lpsFromRas * fromRows(image.sform_code > 0 ? image.sto_xyz : image.qto_xyz);
  } else {
    record.grid.worldFromIndex = glm::dmat4(glm::dvec4(image.dx, 0, 0, 0), glm::dvec4(0, image.dy, 0, 0),
                                            glm::dvec4(0, 0, image.dz, 0), glm::dvec4(0, 0, 0, 1));
    record.warnings.emplace_back("the file does not say how its voxels lie in the patient: its axes stay as they are");
  }
  if (image.sform_code > 0 && image.qform_code > 0) {
    const glm::dmat4 other = lpsFromRas * fromRows(image.qto_xyz);
    const double voxel = std::cbrt(std::abs(glm::determinant(glm::dmat3(record.grid.worldFromIndex))));
    const glm::dvec4 last(glm::dvec3(record.grid.size - 1), 1);
    const glm::dvec4 apart = other * last - record.grid.worldFromIndex * last;
    // Half a voxel is what one would see.
    if (glm::length(glm::dvec3(apart)) > 0.5 * voxel) {
      record.warnings.emplace_back("the file's sform and qform differ: the sform is taken");
    }
  }
}

void setTimes(const nifti_image& image, uint64_t volumes, VolumeRecord& record) {
  if (volumes < 2) {
    return;
  }
  const double unit = image.time_units == NIFTI_UNITS_MSEC ? 1e-3 : image.time_units == NIFTI_UNITS_USEC ? 1e-6 : 1;
  double step = image.dt * unit;
  const bool isTime = image.time_units == NIFTI_UNITS_SEC || unit != 1 || image.time_units == NIFTI_UNITS_UNKNOWN;
  if (!isTime || !(step > 0) || !std::isfinite(step)) {
    record.warnings.emplace_back("the file does not say how many seconds its volumes are apart: 1 is taken");
    step = 1;
  }
  const double first = std::isfinite(image.toffset) ? image.toffset * unit : 0;
  for (uint64_t at = 0; at < volumes; ++at) {
    record.times.push_back(first + static_cast<double>(at) * step);
  }
}

constexpr size_t kNifti1Bytes = 348;
constexpr size_t kNifti2Bytes = 540;

/// As it stands in the file; shorter where that is.
std::string niftiHeaderOf(const ByteSource& source, bool isDeflated) {
  std::string header(static_cast<size_t>(std::min<uint64_t>(source.size(), 1 << 16)), '\0');
  source.read(0, std::as_writable_bytes(std::span(header)));
  if (isDeflated) {
    std::span<const std::byte> all = std::as_bytes(std::span(header));
    const ByteFeed once = [&] { return std::exchange(all, {}); };
    std::string inflated;
    inflateBytes(once, kNifti2Bytes, source.name(), [&](std::span<const std::byte> bytes) {
      inflated.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
    header = inflated;
  }
  return header;
}

bool isNifti2OfOnePiece(std::string_view header) {
  using namespace std::string_view_literals;
  return header.size() >= kNifti2Bytes && header.substr(4, 4) == "n+2\0"sv;
}

/// The library takes files without the mark for those of Analyze, which have no orientation.
bool isNiftiOfOnePiece(std::string_view header) {
  using namespace std::string_view_literals;
  return isNifti2OfOnePiece(header) || (header.size() >= kNifti1Bytes && header.substr(344, 4) == "n+1\0"sv);
}

template <class Number>
double numberAt(std::string_view header, size_t at, bool isSwapped) {
  std::array<char, sizeof(Number)> bytes{};
  header.copy(bytes.data(), bytes.size(), at);
  if (isSwapped) {
    std::reverse(bytes.begin(), bytes.end());
  }
  Number number{};
  std::memcpy(&number, bytes.data(), sizeof(number));
  return static_cast<double>(number);
}

/// What the library reads as something else: sizes of 0 and below as 1, and any offset. `header` has the mark.
void checkNiftiHeader(std::string_view header, const std::string& where) {
  const bool isSecond = isNifti2OfOnePiece(header);
  const bool isSwapped =
      numberAt<int32_t>(header, 0, false) != static_cast<double>(isSecond ? kNifti2Bytes : kNifti1Bytes);
  const auto sizeAt = [&](size_t at) {
    return isSecond ? numberAt<int64_t>(header, 16 + 8 * at, isSwapped)
                    : numberAt<int16_t>(header, 40 + 2 * at, isSwapped);
  };
  const double dimensions = sizeAt(0);
  for (size_t at = 1; at <= 7 && static_cast<double>(at) <= dimensions; ++at) {
    // Some programs write 0 for an axis behind those of space that there is not.
    if (sizeAt(at) < (at > 3 ? 0 : 1)) {
      throw InputError(fmt::format("the header says {} samples along axis {}", sizeAt(at), at), where,
                       kNiftiExportAgain);
    }
  }
  constexpr double kMaxOffset = 4e18;  // more is no size of a file
  const double offset = isSecond ? numberAt<int64_t>(header, 168, isSwapped) : numberAt<float>(header, 108, isSwapped);
  if (!(offset >= 0 && offset <= kMaxOffset) || offset != std::floor(offset)) {
    throw InputError(fmt::format("the header says that the voxels begin at byte {:g}", offset), where,
                     kNiftiExportAgain);
  }
}

}  // namespace

VolumeRecord readNifti(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const std::filesystem::path& path = task.path;
  const std::string where = path.string();
  const FileSource source(path, budget);
  const bool isDeflated = nifti_is_gzfile(path.c_str()) != 0;
  const std::string header = niftiHeaderOf(source, isDeflated);
  if (!isNiftiOfOnePiece(header)) {
    throw InputError("this is no NIfTI file of one piece: the mark \"n+1\" or \"n+2\" is missing", where,
                     "convert it to one file, .nii or .nii.gz");
  }
  checkNiftiHeader(header, where);
  const NiftiImage image(nifti_image_read(path.c_str(), 0), &nifti_image_free);
  if (!image) {
    throw InputError("this is no NIfTI file that can be read: its header is damaged", where, kNiftiExportAgain);
  }
  if (image->iname == nullptr || path != std::filesystem::path(image->iname)) {
    throw InputError("the voxels lie in another file", where, "give the volume as one file, .nii or .nii.gz");
  }
  if (image->ndim < 3 || image->nu > 1 || image->nv > 1 || image->nw > 1) {
    throw InputError(image->ndim < 3 ? fmt::format("the file has {} dimensions", image->ndim)
                                     : "the voxels have several numbers each, such as vectors",
                     where, "give a volume of one number a voxel, at one time or several");
  }
  VolumeRecord record;
  record.facts.format = "NIfTI";
  const double volumes = image->ndim > 3 ? static_cast<double>(image->nt) : 1;
  checkVolumeSize({image->nx, image->ny, image->nz}, volumes, where);
  record.grid.size = {static_cast<int>(image->nx), static_cast<int>(image->ny), static_cast<int>(image->nz)};
  const StoredType type = storedTypeOf(*image, where);
  // A slope of 0 says that there is none.
  if (image->scl_slope != 0 && std::isfinite(image->scl_slope) && std::isfinite(image->scl_inter)) {
    record.scale = image->scl_slope;
    record.offset = image->scl_inter;
  }
  setGrid(*image, record);
  setTimes(*image, static_cast<uint64_t>(volumes), record);
  if (image->intent_code != NIFTI_INTENT_NONE) {
    record.warnings.push_back(fmt::format("the file says what its values are for ({}), which is not kept",
                                          nifti_intent_string(image->intent_code)));
  }
  if (image->iname_offset < 0) {
    throw InputError("the header says that the voxels begin before the file", where, kNiftiExportAgain);
  }
  const bool isSwapped = image->byteorder != nifti_short_order();
  const auto offset = static_cast<uint64_t>(image->iname_offset);
  placeVoxels(record, static_cast<uint64_t>(volumes),
              {type, isSwapped, isDeflated ? 0 : offset, isDeflated, isDeflated ? offset : 0}, source, where, scratch);
  return record;
}

}  // namespace ocelli
