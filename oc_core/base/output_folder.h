// Files that a script names, in the folder that the user gave for what is written.
#pragma once

#include <filesystem>
#include <string>

namespace ocelli {

/// The folder and those it lies in, where they do not exist; "" is the current folder. Throws WorkError.
void makeFolder(const std::filesystem::path& folder);

/// The path of that file in the folder; the folders between are made. Throws InputError, naming `where`, for what would
/// lie outside of it ("/tmp/a.png", "../a.png") or is no file's name, and WorkError where a folder cannot be made.
std::filesystem::path pathInFolder(const std::filesystem::path& folder, const std::string& file,
                                   const std::string& where);

}  // namespace ocelli
