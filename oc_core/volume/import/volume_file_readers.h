// Volume files of all formats into records.
#pragma once

#include <string_view>

#include "oc_core/volume/import/volume_reader_rows.h"

namespace ocelli {

/// Whether there is a reader of the format of this name.
bool hasVolumeFileReader(std::string_view format);

/// Reads what volumeFormatOf() knows. Throws InputError and WorkError.
VolumeRecord readVolumeRecord(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget);

}  // namespace ocelli
