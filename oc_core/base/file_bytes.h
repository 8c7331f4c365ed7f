// Whole files as bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace ocelli {

/// Writes `bytes` as a file that appears complete or not at all (output_file.h). Throws WorkError.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError where the file is missing, is a folder, cannot be read, or is larger than `maxBytes`. What is no
/// regular file (a pipe, a device) is read to its end too, and may have kMaxTextBytes at most.
std::string readFile(const std::filesystem::path& path, size_t maxBytes = size_t{1} << 40U);

/// Of files that people write, such as JSON: more is a mistake.
inline constexpr size_t kMaxTextBytes = size_t{1} << 26U;

}  // namespace ocelli
