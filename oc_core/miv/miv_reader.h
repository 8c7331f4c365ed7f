// Reads what miv_writer.h writes, strictly: for tests, and for whoever wants to see what such a folder says.
#pragma once

#include <filesystem>

#include "oc_core/miv/miv_sequence.h"

namespace ocelli {

/// `file` is the JSON file; raw video stands beside it. Throws InputError naming file and field for whatever the writer
/// would not write: a missing or unknown field, another format of pixels, a video of another length than one frame.
MivSequence readMivSequence(const std::filesystem::path& file, double unitsPerMetre = 1);

}  // namespace ocelli
