#include "oc_core/volume/volume_record.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "oc_core/base/printable_text.h"
#include "oc_core/base/record_bytes.h"

namespace ocelli {
namespace {

constexpr std::string_view kVolumeStart = "OCVOLUM1";
constexpr std::string_view kVolumeEnd = "END.";
enum class VolumeRecordKind : uint32_t { kVolumes, kInputFailure, kWorkFailure };
constexpr RecordWords kVolumeWords{"volume", "convert the volume to NRRD"};

class VolumeRecordReader : public RecordParser {
 public:
  using RecordParser::RecordParser;

  VolumeRecord read() {
    expect(kVolumeStart);
    const uint32_t kind = number();
    switch (static_cast<VolumeRecordKind>(kind)) {
      case VolumeRecordKind::kVolumes:
        return volumes();
      case VolumeRecordKind::kInputFailure:
        throw errorAsItWas<InputError>(message());
      case VolumeRecordKind::kWorkFailure:
        throw errorAsItWas<WorkError>(message());
    }
    fail("unknown kind");
  }

 private:
  void expectEnd() {
    expect(kVolumeEnd);
    if (!atEnd()) {
      fail("bytes are left over");
    }
  }

  std::string message() {
    std::string message = text();
    expectEnd();
    return message;
  }

  double finite() {
    const auto number = value<double>();
    if (!std::isfinite(number)) {
      fail("a number is not finite");
    }
    return number;
  }

  /// A short text of the file, which is shown in many places: control characters stand as escapes, and what is longer
  /// than any unit or name is cut off.
  std::string shownText() {
    constexpr size_t kMaxShown = 64;
    std::string shown = printableText(text());
    if (shown.size() > kMaxShown) {
      size_t end = kMaxShown;
      // Not within a character of UTF-8.
      while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xc0U) == 0x80U) {
        --end;
      }
      shown = shown.substr(0, end) + "...";
    }
    return shown;
  }

  VolumeGrid grid() {
    VolumeGrid grid;
    for (int axis = 0; axis < 3; ++axis) {
      grid.size[axis] = value<int32_t>();
      if (grid.size[axis] < 1 || grid.size[axis] > VolumeRecord::kMaxEdge) {
        fail("a size is out of range");
      }
    }
    for (int at = 0; at < 16; ++at) {
      glm::value_ptr(grid.worldFromIndex)[at] = finite();
    }
    const double volume = std::abs(glm::determinant(glm::dmat3(grid.worldFromIndex)));
    const glm::dmat4& m = grid.worldFromIndex;
    const glm::dvec4 last(m[0].w, m[1].w, m[2].w, m[3].w);
    if (!(volume > 0) || !std::isfinite(volume) || last != glm::dvec4(0, 0, 0, 1)) {
      fail("voxels without volume");
    }
    grid.unit = shownText();
    const auto anatomical = value<uint8_t>();
    if (anatomical > 1) {
      fail("a flag is out of range");
    }
    grid.isAnatomical = anatomical == 1;
    return grid;
  }

  VolumeRecord volumes() {
    VolumeRecord record;
    record.grid = grid();
    const uint32_t type = number();
    if (type > static_cast<uint32_t>(VoxelType::kFloat64)) {
      fail("an unknown type");
    }
    record.type = static_cast<VoxelType>(type);
    record.scale = finite();
    record.offset = finite();
    if (record.scale == 0) {
      fail("a scale of 0");
    }
    record.file = text();
    const uint32_t count = this->count(sizeof(uint64_t));
    if (count == 0 || count > VolumeRecord::kMaxVolumes) {
      fail("a count is out of range");
    }
    record.begins = list<uint64_t>(count);
    const auto isMisplaced = [&](uint64_t begin) {
      return begin % bytesOf(record.type) != 0 || begin > uint64_t{1} << 62U;
    };
    if (std::any_of(record.begins.begin(), record.begins.end(), isMisplaced)) {
      fail("voxels out of range");
    }
    const uint32_t times = this->count(sizeof(double));
    if (times != 0 && times != count) {
      fail("a count is out of range");
    }
    for (uint32_t at = 0; at < times; ++at) {
      record.times.push_back(finite());
      if (at > 0 && !(record.times[at] > record.times[at - 1])) {
        fail("times do not rise");
      }
    }
    record.facts.modality = shownText();
    record.facts.valueUnit = shownText();
    record.facts.format = shownText();
    const uint32_t warnings = this->count(sizeof(uint32_t));
    for (uint32_t at = 0; at < warnings; ++at) {
      record.warnings.push_back(text());
    }
    expectEnd();
    return record;
  }
};

}  // namespace

void writeVolumeRecord(const VolumeRecord& record, const ByteSink& sink) {
  RecordWriter writer(sink);
  writer.raw(kVolumeStart.data(), kVolumeStart.size());
  writer.value(VolumeRecordKind::kVolumes);
  for (int axis = 0; axis < 3; ++axis) {
    writer.value(static_cast<int32_t>(record.grid.size[axis]));
  }
  writer.raw(glm::value_ptr(record.grid.worldFromIndex), 16 * sizeof(double));
  writer.text(record.grid.unit);
  writer.value(static_cast<uint8_t>(record.grid.isAnatomical ? 1 : 0));
  writer.value(static_cast<uint32_t>(record.type));
  writer.value(record.scale);
  writer.value(record.offset);
  writer.text(record.file);
  writer.count(record.begins.size());
  writer.list(record.begins);
  writer.count(record.times.size());
  writer.list(record.times);
  writer.text(record.facts.modality);
  writer.text(record.facts.valueUnit);
  writer.text(record.facts.format);
  writer.count(record.warnings.size());
  for (const std::string& warning : record.warnings) {
    writer.text(warning);
  }
  writer.raw(kVolumeEnd.data(), kVolumeEnd.size());
}

void writeVolumeFailure(const std::string& message, bool isInput, const ByteSink& sink) {
  RecordWriter writer(sink);
  writer.raw(kVolumeStart.data(), kVolumeStart.size());
  writer.value(isInput ? VolumeRecordKind::kInputFailure : VolumeRecordKind::kWorkFailure);
  writer.text(message);
  writer.raw(kVolumeEnd.data(), kVolumeEnd.size());
}

VolumeRecord volumeFromRecord(std::span<const std::byte> bytes, const std::string& writer) {
  return VolumeRecordReader(bytes, writer, kVolumeWords).read();
}

}  // namespace ocelli
