// Writes sequences for the test model of MPEG immersive video.
#pragma once

#include <filesystem>

#include "oc_core/base/progress.h"
#include "oc_core/miv/miv_sequence.h"

namespace ocelli {

/// Makes the folder where it is not there; files of the same names are replaced. The JSON file is written last, so that
/// a folder with it is complete. Throws as validate() does; WorkError where something cannot be written, such as on a
/// full disk: each file is whole or not there.
void writeMivSequence(const std::filesystem::path& folder, const MivSequence& sequence, const Progress& progress = {});

}  // namespace ocelli
