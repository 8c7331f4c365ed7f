// A folder of DICOM slices, or one DICOM file with several frames, through GDCM: http://gdcm.sourceforge.net
#include <fmt/format.h>
#include <gdcmAttribute.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/dicom_slices.h"
#include "oc_core/volume/import/number_list.h"
#include "oc_core/volume/import/reading_note.h"
#include "oc_core/volume/import/volume_reader_rows.h"
#include "oc_core/volume/volume_formats.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDicomExportAgain = "copy or export this file again, or remove it from the folder";
const gdcm::Tag kModality(0x0008, 0x0060);
const gdcm::Tag kSeriesDescription(0x0008, 0x103e);
const gdcm::Tag kSeriesUid(0x0020, 0x000e);
const gdcm::Tag kSeriesNumber(0x0020, 0x0011);
const gdcm::Tag kAcquisitionNumber(0x0020, 0x0012);
const gdcm::Tag kRescaleType(0x0028, 0x1054);
const gdcm::Tag kUnits(0x0054, 0x1001);  // of PET
const gdcm::Tag kPixelData(0x7fe0, 0x0010);
// Of files with several frames: groups of fields, of all frames and of each.
const gdcm::Tag kSharedGroups(0x5200, 0x9229);
const gdcm::Tag kFrameGroups(0x5200, 0x9230);
const gdcm::Tag kPlanePosition(0x0020, 0x9113);
const gdcm::Tag kPlaneOrientation(0x0020, 0x9116);
const gdcm::Tag kPixelMeasures(0x0028, 0x9110);
const gdcm::Tag kPixelValues(0x0028, 0x9145);

/// A field of decimal strings, and its name in the standard.
struct DicomNumbers {
  gdcm::Tag tag;
  const char* name;
};

const DicomNumbers kFrames{{0x0028, 0x0008}, "NumberOfFrames"};
const DicomNumbers kTriggerTime{{0x0018, 0x1060}, "TriggerTime"};  // in milliseconds
const DicomNumbers kTemporalPosition{{0x0020, 0x0100}, "TemporalPositionIdentifier"};
const DicomNumbers kImagesInAcquisition{{0x0020, 0x1002}, "ImagesInAcquisition"};
const DicomNumbers kImagePosition{{0x0020, 0x0032}, "ImagePositionPatient"};
const DicomNumbers kImageOrientation{{0x0020, 0x0037}, "ImageOrientationPatient"};
const DicomNumbers kPixelSpacing{{0x0028, 0x0030}, "PixelSpacing"};
const DicomNumbers kRescaleIntercept{{0x0028, 0x1052}, "RescaleIntercept"};
const DicomNumbers kRescaleSlope{{0x0028, 0x1053}, "RescaleSlope"};

/// Empty where there is none.
std::string textOf(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) {
    return "";
  }
  const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
  if (value == nullptr || value->GetPointer() == nullptr) {
    return "";
  }
  std::string text(value->GetPointer(), value->GetLength());
  const auto isFill = [](char c) { return c == ' ' || c == '\0' || c == '\n' || c == '\r'; };
  while (!text.empty() && isFill(text.back())) {
    text.pop_back();
  }
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

/// Decimal strings, "0.5\\0.5": empty where there is none. Where one is no number, too, and `malformed` says so.
std::vector<double> numbersOf(const gdcm::DataSet& data, const DicomNumbers& field, std::string& malformed) {
  const std::string text = textOf(data, field.tag);
  const std::optional<std::vector<double>> numbers = numbersFromText(text, " \\");
  if (!numbers) {
    constexpr size_t kMaxShown = 40;
    malformed = fmt::format("its {} is \"{}\", which is no number", field.name, text.substr(0, kMaxShown));
  }
  return numbers.value_or(std::vector<double>());
}

/// The first item of a sequence; null where there is none.
gdcm::SmartPointer<gdcm::SequenceOfItems> itemsOf(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) {
    return nullptr;
  }
  gdcm::SmartPointer<gdcm::SequenceOfItems> items = data.GetDataElement(tag).GetValueAsSQ();
  return items && items->GetNumberOfItems() > 0 ? items : nullptr;
}

/// Numbers that stand in the file itself, in the group of a frame, or in that of all.
class FrameFields {
 public:
  FrameFields(const gdcm::DataSet& file, unsigned frame)
      : file_(file), shared_(itemsOf(file, kSharedGroups)), frames_(itemsOf(file, kFrameGroups)), frame_(frame) {}

  std::vector<double> numbers(const gdcm::Tag& group, const DicomNumbers& field, std::string& malformed) const {
    for (const auto& [items, index] : {std::pair(frames_, frame_ + 1), std::pair(shared_, 1U)}) {
      if (!items || index > items->GetNumberOfItems()) {
        continue;
      }
      const gdcm::SmartPointer<gdcm::SequenceOfItems> inner = itemsOf(items->GetItem(index).GetNestedDataSet(), group);
      if (inner) {
        if (std::vector<double> found = numbersOf(inner->GetItem(1).GetNestedDataSet(), field, malformed);
            !found.empty()) {
          return found;
        }
      }
    }
    return numbersOf(file_, field, malformed);
  }

 private:
  const gdcm::DataSet& file_;
  gdcm::SmartPointer<gdcm::SequenceOfItems> shared_;
  gdcm::SmartPointer<gdcm::SequenceOfItems> frames_;
  unsigned frame_;
};

[[noreturn]] void failDicom(const std::string& what, const fs::path& file,
                            const std::string& next = kDicomExportAgain) {
  throw InputError(what, file.string(), next);
}

glm::dvec3 threeFrom(const std::vector<double>& numbers, size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

/// Where a slice lies, or why nowhere.
void placeSlice(const std::vector<double>& position, const std::vector<double>& orientation,
                const std::vector<double>& spacing, DicomSlice& slice) {
  if (position.size() != 3 || orientation.size() != 6 || spacing.size() != 2) {
    const DicomNumbers& missing = position.size() != 3      ? kImagePosition
                                  : orientation.size() != 6 ? kImageOrientation
                                                            : kPixelSpacing;
    slice.unplaced = fmt::format("this image does not say where it lies in the patient (no {})", missing.name);
    return;
  }
  slice.position = threeFrom(position, 0);
  slice.alongColumns = threeFrom(orientation, 0);
  slice.alongRows = threeFrom(orientation, 3);
  slice.rowSpacing = spacing[0];
  slice.columnSpacing = spacing[1];
  const double sine = glm::length(glm::cross(slice.alongColumns, slice.alongRows));
  if (!(slice.rowSpacing > 0) || !(slice.columnSpacing > 0) || !(std::abs(sine - 1) < 1e-2)) {
    slice.unplaced = "its PixelSpacing or its ImageOrientationPatient is none";
    return;
  }
  slice.alongColumns = glm::normalize(slice.alongColumns);
  slice.alongRows = glm::normalize(slice.alongRows);
}

/// How many images there should be, where a file says so: what is no number there says nothing.
void readCounts(const gdcm::DataSet& data, DicomSlice& slice) {
  std::string ignored;
  if (const std::vector<double> told = numbersOf(data, kImagesInAcquisition, ignored); !told.empty()) {
    slice.imagesInAcquisition = told.front();
  }
  // Of PET.
  gdcm::Attribute<0x0054, 0x0081> slicesOfTime{};
  if (data.FindDataElement(slicesOfTime.GetTag()) && !data.GetDataElement(slicesOfTime.GetTag()).IsEmpty()) {
    slicesOfTime.SetFromDataSet(data);
    slice.slicesOfTime = slicesOfTime.GetValue();
  }
}

/// The slices of a file, without their pixels; none where it is no image, such as an index of the folder.
std::vector<DicomSlice> slicesOf(const fs::path& file) {
  noteFileRead(file);
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.ReadUpToTag(kPixelData)) {
    failDicom("this DICOM file is damaged", file);
  }
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  gdcm::Attribute<0x0028, 0x0010> rows{};
  gdcm::Attribute<0x0028, 0x0011> columns{};
  if (!data.FindDataElement(rows.GetTag()) || !data.FindDataElement(columns.GetTag())) {
    return {};
  }
  rows.SetFromDataSet(data);
  columns.SetFromDataSet(data);
  DicomSlice all;
  const std::vector<double> frames = numbersOf(data, kFrames, all.malformed);
  const double count = frames.empty() ? 1 : frames.front();
  if (!(count >= 1 && count <= VolumeRecord::kMaxEdge)) {
    failDicom(fmt::format("this file has {} frames", count), file);
  }
  all.file = file;
  all.seriesUid = textOf(data, kSeriesUid);
  all.seriesNumber = textOf(data, kSeriesNumber);
  all.seriesDescription = textOf(data, kSeriesDescription);
  all.acquisitionNumber = textOf(data, kAcquisitionNumber);
  readCounts(data, all);
  all.modality = textOf(data, kModality);
  all.valueUnit = textOf(data, kRescaleType);
  if (const std::vector<double> trigger = numbersOf(data, kTriggerTime, all.malformed); !trigger.empty()) {
    all.triggerSeconds = trigger.front() / 1000;
  }
  if (const std::vector<double> number = numbersOf(data, kTemporalPosition, all.malformed); !number.empty()) {
    all.temporalPosition = number.front();
  }
  all.columns = columns.GetValue();
  all.rows = rows.GetValue();
  std::vector<DicomSlice> slices;
  for (unsigned frame = 0; frame < static_cast<unsigned>(count); ++frame) {
    const FrameFields fields(data, frame);
    DicomSlice& slice = slices.emplace_back(all);
    slice.frame = frame;
    const auto numbers = [&](const gdcm::Tag& group, const DicomNumbers& field) {
      return fields.numbers(group, field, slice.malformed);
    };
    const std::vector<double> slope = numbers(kPixelValues, kRescaleSlope);
    const std::vector<double> intercept = numbers(kPixelValues, kRescaleIntercept);
    placeSlice(numbers(kPlanePosition, kImagePosition), numbers(kPlaneOrientation, kImageOrientation),
               numbers(kPixelMeasures, kPixelSpacing), slice);
    slice.slope = slope.empty() ? 1 : slope.front();
    slice.intercept = intercept.empty() ? 0 : intercept.front();
    if (slice.valueUnit.empty() && slice.modality == "CT" && !slope.empty()) {
      slice.valueUnit = "HU";
    } else if (slice.valueUnit.empty()) {
      slice.valueUnit = textOf(data, kUnits);
    }
  }
  return slices;
}

std::vector<fs::path> filesOf(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    return {path};
  }
  std::vector<fs::path> files;
  for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
    const VolumeFormat* named = volumeFormatOfName(at->path());
    const bool isNamed = named != nullptr && named->name == kDicomFormat && at->is_regular_file(error);
    if (isNamed || isDicomFile(at->path())) {
      files.push_back(at->path());
    }
  }
  if (error) {
    throw InputError("cannot read this folder (" + error.message() + ")", path.string(), "check your rights");
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What GDCM says while this lives, instead of on the terminal: it reads damaged files, and warns.
class DicomWarnings {
 public:
  DicomWarnings() { gdcm::Trace::SetStream(text_); }
  ~DicomWarnings() { gdcm::Trace::SetStream(std::cerr); }
  DicomWarnings(const DicomWarnings&) = delete;
  DicomWarnings& operator=(const DicomWarnings&) = delete;

  /// Whether it was that pixels are missing or damaged: each such warning ends with these words.
  bool tellOfDamage() const { return text_.str().find("at own risk") != std::string::npos; }

 private:
  std::ostringstream text_;
};

struct DicomPixels {
  StoredType type = StoredType::kUint8;
  std::vector<char> bytes;  ///< of all frames
};

/// Numbers whose upper bits hold something else, or no sign.
template <class Unsigned, class Signed>
void keepStoredBits(std::vector<char>& bytes, unsigned stored, bool isSigned) {
  const unsigned unused = 8 * sizeof(Unsigned) - stored;
  for (size_t at = 0; at + sizeof(Unsigned) <= bytes.size(); at += sizeof(Unsigned)) {
    Unsigned pixel = 0;
    std::memcpy(&pixel, bytes.data() + at, sizeof(pixel));
    pixel = static_cast<Unsigned>(pixel << unused);
    pixel =
        isSigned ? static_cast<Unsigned>(static_cast<Signed>(pixel) >> unused) : static_cast<Unsigned>(pixel >> unused);
    std::memcpy(bytes.data() + at, &pixel, sizeof(pixel));
  }
}

DicomPixels pixelsOf(const fs::path& file, VolumeRecord& record) {
  noteFileRead(file);
  const DicomWarnings warnings;
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read() || warnings.tellOfDamage()) {
    failDicom("the pixels of this DICOM file are damaged, or coded in a way that is not read", file,
              "export it without compression");
  }
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  if (format.GetSamplesPerPixel() != 1 ||
      image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::PALETTE_COLOR) {
    failDicom("the pixels of this DICOM file are colours", file, "give slices of one number a pixel");
  }
  DicomPixels pixels;
  const bool isSigned = format.GetPixelRepresentation() == 1;
  switch (format.GetBitsAllocated()) {
    case 8:
      pixels.type = isSigned ? StoredType::kInt8 : StoredType::kUint8;
      break;
    case 16:
      pixels.type = isSigned ? StoredType::kInt16 : StoredType::kUint16;
      break;
    case 32:
      pixels.type = isSigned ? StoredType::kInt32 : StoredType::kUint32;
      break;
    default:
      failDicom(fmt::format("pixels of {} bits are not read", format.GetBitsAllocated()), file,
                "export it with 8, 16 or 32 bits a pixel");
  }
  const unsigned stored = format.GetBitsStored();
  // GDCM takes a HighBit that it does not expect for the usual one.
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  gdcm::Attribute<0x0028, 0x0101> saidStored{};
  gdcm::Attribute<0x0028, 0x0102> saidHigh{};
  if (data.FindDataElement(saidStored.GetTag()) && data.FindDataElement(saidHigh.GetTag())) {
    saidStored.SetFromDataSet(data);
    saidHigh.SetFromDataSet(data);
    if (saidHigh.GetValue() + 1 != saidStored.GetValue()) {
      failDicom(fmt::format("the {} bits of a pixel (BitsStored) end at bit {} (HighBit), which is not read",
                            saidStored.GetValue(), saidHigh.GetValue()),
                file, "export it with its pixels in the lowest bits");
    }
  }
  pixels.bytes.resize(image.GetBufferLength());
  if (!image.GetBuffer(pixels.bytes.data())) {
    failDicom("the pixels of this DICOM file are damaged, or coded in a way that is not read", file,
              "export it without compression");
  }
  if (stored < format.GetBitsAllocated() && stored > 0 && format.GetHighBit() + 1U == stored) {
    if (format.GetBitsAllocated() == 16) {
      keepStoredBits<uint16_t, int16_t>(pixels.bytes, stored, isSigned);
    } else if (format.GetBitsAllocated() == 32) {
      keepStoredBits<uint32_t, int32_t>(pixels.bytes, stored, isSigned);
    } else {
      keepStoredBits<uint8_t, int8_t>(pixels.bytes, stored, isSigned);
    }
  }
  const std::string lossy = "the slices were compressed with loss";
  if (image.IsLossy() && std::find(record.warnings.begin(), record.warnings.end(), lossy) == record.warnings.end()) {
    record.warnings.push_back(lossy);
  }
  return pixels;
}

double pixelAt(const DicomPixels& pixels, size_t at) {
  const char* from = pixels.bytes.data() + at * bytesOf(pixels.type);
  const auto as = [&](auto number) {
    std::memcpy(&number, from, sizeof(number));
    return static_cast<double>(number);
  };
  switch (voxelTypeOf(pixels.type)) {
    case VoxelType::kUint8:
      return as(uint8_t{});
    case VoxelType::kInt8:
      return as(int8_t{});
    case VoxelType::kUint16:
      return as(uint16_t{});
    case VoxelType::kInt16:
      return as(int16_t{});
    case VoxelType::kUint32:
      return as(uint32_t{});
    case VoxelType::kInt32:
      return as(int32_t{});
    case VoxelType::kFloat32:
    case VoxelType::kFloat64:
      break;
  }
  return 0;  // pixels are integers
}

/// All slices, one time after the other. The grid is that of the first.
std::vector<DicomSlice> arrangeMoments(std::vector<DicomMoment>& moments, VolumeRecord& record,
                                       const std::string& where) {
  std::vector<DicomSlice> all;
  for (DicomMoment& moment : moments) {
    VolumeRecord other;
    VolumeRecord& arranged = all.empty() ? record : other;
    arrangeSlices(moment.slices, arranged, where);
    if (arranged.grid.size != record.grid.size || arranged.grid.worldFromIndex != record.grid.worldFromIndex) {
      throw InputError(
          fmt::format("the slices lie elsewhere at {:g} s than at {:g} s", moment.seconds, moments.front().seconds),
          where, "give a folder with one of these times");
    }
    all.insert(all.end(), moment.slices.begin(), moment.slices.end());
    if (moments.size() > 1) {
      record.times.push_back(moment.seconds);
    }
  }
  return all;
}

}  // namespace

VolumeRecord readDicom(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const fs::path& path = task.path;
  const std::string& series = task.series;
  const std::string where = path.string();
  std::vector<DicomSlice> slices;
  for (const fs::path& file : filesOf(path)) {
    std::error_code ignored;
    if (budget != nullptr) {
      budget->addFile(fs::file_size(file, ignored));
    }
    const std::vector<DicomSlice> some = slicesOf(file);
    slices.insert(slices.end(), some.begin(), some.end());
  }
  if (slices.empty()) {
    throw InputError("there is no DICOM image", where, "give a folder with the slices of a volume");
  }
  std::error_code ignored;
  if (slices.size() == 1 && !fs::is_directory(path, ignored)) {
    throw InputError("this DICOM file is one slice", where, "give the folder with all slices of the volume");
  }
  VolumeRecord record;
  const size_t all = slices.size();
  slices = chooseSeries(slices, series, where);
  if (series.empty() && slices.size() < all) {
    record.warnings.push_back(
        fmt::format("{} of the folder's images are of other series, lie nowhere in the patient, and are passed over",
                    all - slices.size()));
  }
  std::vector<DicomMoment> moments = momentsOf(slices);
  if (const std::optional<std::string> missing = missingSlices(moments)) {
    record.warnings.push_back(*missing);
  }
  slices = arrangeMoments(moments, record, where);
  if (moments.front().isNumbered) {
    record.warnings.emplace_back(
        "the files number their times and do not say how many seconds they are apart: 1 is taken");
  }

  // Where slices differ in what their pixels mean, as those of PET do, what they mean is kept as float32.
  const DicomSlice& first = slices.front();
  const bool differ = std::any_of(slices.begin(), slices.end(), [&](const DicomSlice& slice) {
    return slice.slope != first.slope || slice.intercept != first.intercept;
  });
  if (!differ) {
    record.scale = first.slope;
    record.offset = first.intercept;
  }
  fs::path read;
  DicomPixels pixels;
  std::optional<VoxelWriter> writer;
  StoredType type = StoredType::kUint8;
  const size_t area = static_cast<size_t>(first.columns) * static_cast<size_t>(first.rows);
  std::vector<float> meant(differ ? area : 0);
  for (const DicomSlice& slice : slices) {
    if (read != slice.file) {
      pixels = pixelsOf(slice.file, record);
      read = slice.file;
    }
    if (!writer) {
      type = pixels.type;
      const StoredType written = differ ? StoredType::kFloat32 : type;
      scratch.expect(moments.size() * record.grid.voxelCount() * bytesOf(written));
      writer.emplace(record, moments.size(), written, false, scratch);
    } else if (pixels.type != type && !differ) {
      failDicom("the pixels of this slice are of another type than those of the others", slice.file);
    }
    const size_t bytes = area * bytesOf(pixels.type);
    if (pixels.bytes.size() < bytes * (slice.frame + 1)) {
      failDicom("the file has fewer pixels than its header says", slice.file);
    }
    if (!differ) {
      writer->append(std::as_bytes(std::span(pixels.bytes)).subspan(slice.frame * bytes, bytes), where);
      continue;
    }
    for (size_t at = 0; at < area; ++at) {
      meant[at] = static_cast<float>(pixelAt(pixels, slice.frame * area + at) * slice.slope + slice.intercept);
    }
    writer->append(std::as_bytes(std::span(meant)), where);
  }
  writer->finish(where);
  return record;
}

}  // namespace ocelli
