// Programs of ours that others of ours run, from libexec/ocelli/: where they are found, and how this one becomes one of
// them. A program is a row: an OwnProgram.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ocelli {

struct OwnProgram {
  const char* name;       ///< "ocelli-read-scene", in libexec/ocelli/
  const char* installed;  ///< the path where this library was configured to be installed with it
  const char* variable;   ///< of the environment: names another program
  const char* does;       ///< "reads scene files"
  const char* ifMissing;  ///< what to do where it is missing
};

/// The program: what its environment variable names; else libexec/ocelli/NAME in the folder of the running program, or
/// of the library that this code was loaded from, or one above it; else where it was configured to be installed. Throws
/// WorkError where there is none.
///
/// Programs that someone else may have put there are passed over: its owner must be root, this user, or the owner of
/// the running program.
std::filesystem::path findOwnProgram(const OwnProgram& program);

/// The command line of this process, its name first.
std::vector<std::string> ownCommandLine();

/// This process becomes `program`, with these words as its command line, its name first. Its ID, terminal and open
/// standard streams stay. Returns where the system cannot start it.
void becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& words);

}  // namespace ocelli
