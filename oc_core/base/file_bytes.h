// Whole files as bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ocelli {

/// Writes `bytes` as a file that appears complete or not at all (output_file.h). Throws WorkError.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError where the file is missing, is a folder or cannot be read.
std::string readFile(const std::filesystem::path& path);

}  // namespace ocelli
