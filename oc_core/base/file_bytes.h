// Whole files as bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ocelli {

/// Writes `bytes` as a file. Throws WorkError where it cannot be written in full; a file cut short does not stay.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError where the file is missing, is a folder or cannot be read.
std::string readFile(const std::filesystem::path& path);

}  // namespace ocelli
