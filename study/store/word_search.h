// Finding the id of a subject in texts and files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ocelli {

/// Whether `word` stands in `text` with no letter or digit (ASCII) right before or after it: "S01" is in "S01_old.db",
/// not in "S011". `word` is not empty.
bool holdsWord(std::string_view text, std::string_view word);

/// The same of a file of any size. Throws InputError where it cannot be read.
bool fileHoldsWord(const std::filesystem::path& path, std::string_view word);

}  // namespace ocelli
