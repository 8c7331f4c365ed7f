#include "tests/cli/run_program.h"

#include <sys/wait.h>

#include <cstdlib>

#include "tests/base/temporary_folder.h"

namespace ocelli::test {

ProgramResult runProgram(const std::string& arguments) {
  return runShell("\"$OCELLI\" " + arguments);
}

ProgramResult runShell(const std::string& script) {
  const TemporaryFolder folder;
  const std::string output = folder.write("output", "").string();
  const std::string error = folder.write("error", "").string();
  const std::string command =
      "OCELLI='" OCELLI_PROGRAM "'\n{ " + script + "\n} >'" + output + "' 2>'" + error + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileBytes(output), fileBytes(error)};
}

std::string inQuotes(const std::filesystem::path& path) {
  std::string text = "'";  // GCC 12 warns without a reason where texts are added up
  return text.append(path.string()).append("'");
}

}  // namespace ocelli::test
