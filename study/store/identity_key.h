// The identity key: which person is which id. A file of its own that the experimenter keeps apart from the data; no
// database and no export holds a name.
//
// It is a table (CSV) with the columns subject_id and name, readable by its owner alone.
#pragma once

#include <filesystem>
#include <string>

namespace ocelli {

/// Adds a line; makes the file where there is none. Throws InputError where it has that id already, or is no such file.
void addIdentity(const std::filesystem::path& keyFile, const std::string& subject, const std::string& name);

/// Takes the line of that subject out. Returns whether there was one.
bool removeIdentity(const std::filesystem::path& keyFile, const std::string& subject);

}  // namespace ocelli
