#include "oc_core/volume/import/volume_file_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_formats.h"

namespace ocelli {
namespace {

const VolumeFileReaderRow* rowOf(std::string_view format) {
  const auto* row = std::find_if(kVolumeFileReaders.begin(), kVolumeFileReaders.end(),
                                 [&](const VolumeFileReaderRow& r) { return r.format == format; });
  return row == kVolumeFileReaders.end() ? nullptr : row;
}

/// What a header says that no grid can be.
void checkMeaning(const VolumeRecord& record, const std::string& where) {
  const double* numbers = glm::value_ptr(record.grid.worldFromIndex);
  const double voxel = std::abs(glm::determinant(glm::dmat3(record.grid.worldFromIndex)));
  if (!std::all_of(numbers, numbers + 16, [](double x) { return std::isfinite(x); }) || !(voxel > 0) ||
      !std::isfinite(voxel)) {
    throw InputError("its spacing and orientation give voxels without volume", where,
                     "set the spacing of its voxels in the program that wrote it, and export it again");
  }
  if (!std::isfinite(record.scale) || !std::isfinite(record.offset) || record.scale == 0) {
    throw InputError("what it says of the meaning of its voxels (slope and intercept) are no numbers, or 0", where,
                     "export it again");
  }
  for (size_t at = 0; at < record.times.size(); ++at) {
    if (!std::isfinite(record.times[at]) || (at > 0 && !(record.times[at] > record.times[at - 1]))) {
      throw InputError("the times of its volumes do not rise", where, "export it again");
    }
  }
}

/// Times below 0, such as those before a trigger, could not be chosen.
void startAtZero(VolumeRecord& record) {
  if (record.times.empty() || record.times.front() >= 0) {
    return;
  }
  const double first = record.times.front();
  for (double& time : record.times) {
    time -= first;
  }
  record.warnings.push_back(fmt::format("the times of the file begin at {:g} s: this is taken for 0 s", first));
}

}  // namespace

bool hasVolumeFileReader(std::string_view format) {
  return rowOf(format) != nullptr;
}

VolumeRecord readVolumeRecord(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget) {
  const VolumeFormat* format = volumeFormatOf(task.path);
  const VolumeFileReaderRow* row = format == nullptr ? nullptr : rowOf(format->name);
  if (row == nullptr) {
    throw InputError("this is no volume that can be read", task.path.string(),
                     "give one of these formats: " + volumeFormatList());
  }
  if (!task.series.empty() && format->name != kDicomFormat) {
    throw InputError(fmt::format("--series chooses one of a folder of DICOM files, and this is {}", format->name),
                     task.path.string(), "leave --series out");
  }
  VolumeRecord record = row->read(task, scratch, budget);
  checkMeaning(record, task.path.string());
  startAtZero(record);
  return record;
}

}  // namespace ocelli
