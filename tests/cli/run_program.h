// Runs the built `ocelli` program as a user's shell would.
#pragma once

#include <filesystem>
#include <string>

namespace ocelli::test {

struct ProgramResult {
  int exitCode = -1;  ///< -1 where it did not exit by itself
  std::string output;
  std::string error;
};

/// `arguments` is what follows `ocelli` on a command line of /bin/sh, redirections included. Output that is redirected
/// elsewhere is not caught.
ProgramResult runProgram(const std::string& arguments);

/// Runs lines of /bin/sh, where "$OCELLI" is the program.
ProgramResult runShell(const std::string& script);

/// Between quotes, as one word of /bin/sh. Paths that have such quotes themselves are not for tests.
std::string inQuotes(const std::filesystem::path& path);

}  // namespace ocelli::test
