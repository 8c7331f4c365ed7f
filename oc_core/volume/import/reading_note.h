// Which file is being read, for the error message where the library that reads it crashes.
#pragma once

#include <filesystem>

namespace ocelli {

/// From now on a crash of this process prints the file that noteFileRead() named last, as its last line, which
/// runReaderProgram() shows (base/reader_process.h).
void noteCrashes();

void noteFileRead(const std::filesystem::path& file);

}  // namespace ocelli
