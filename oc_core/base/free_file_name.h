// File names that nothing has yet.
#pragma once

#include <filesystem>
#include <string>

namespace ocelli {

/// The first of "STEM-001ENDING", "STEM-002ENDING", ... in `folder` that does not exist, which is then made, empty, so
/// that nobody else gets it. Throws WorkError where the folder cannot be written to.
std::filesystem::path makeFreeFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending);

}  // namespace ocelli
