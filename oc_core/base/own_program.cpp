#include "oc_core/base/own_program.h"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// The library that this code is a part of, where a program such as Python has loaded one. Empty for what is part of
/// the program itself, whose name may be relative: what lies in the working directory is not to be run.
fs::path ownLibrary() {
  Dl_info info{};
  const bool isKnown = dladdr(reinterpret_cast<const void*>(&ownLibrary), &info) != 0 && info.dli_fname != nullptr;
  const fs::path file = isKnown ? fs::path(info.dli_fname) : fs::path();
  return file.is_absolute() ? file : fs::path();
}

/// Whether only those who could change the running program anyway can have put this one there.
bool isTrusted(const fs::path& program) {
  struct stat own {};
  struct stat other {};
  if (stat(program.c_str(), &other) != 0 || !S_ISREG(other.st_mode) || access(program.c_str(), X_OK) != 0) {
    return false;
  }
  const bool isOwnersOfThis = stat("/proc/self/exe", &own) == 0 && own.st_uid == other.st_uid;
  return other.st_uid == 0 || other.st_uid == geteuid() || isOwnersOfThis;
}

}  // namespace

fs::path findOwnProgram(const OwnProgram& program) {
  if (const char* given = std::getenv(program.variable); given != nullptr && *given != '\0') {
    if (access(given, X_OK) != 0) {
      throw WorkError(std::string("there is no program that ") + program.does, given,
                      std::string("let ") + program.variable + " name the program " + program.name + ", or unset it");
    }
    return given;
  }
  std::error_code ignored;
  for (fs::path folder : {fs::read_symlink("/proc/self/exe", ignored), ownLibrary()}) {
    while (folder.has_relative_path()) {
      folder = folder.parent_path();
      const fs::path found = folder / "libexec" / "ocelli" / program.name;
      if (isTrusted(found)) {
        return found;
      }
    }
  }
  if (const fs::path installed = program.installed; isTrusted(installed)) {
    return installed;
  }
  throw WorkError(std::string("the program ") + program.name + " is missing, which " + program.does, program.installed,
                  program.ifMissing);
}

std::vector<std::string> ownCommandLine() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

void becomeProgram(const fs::path& program, const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
}

}  // namespace ocelli
