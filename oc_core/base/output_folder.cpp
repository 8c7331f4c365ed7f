#include "oc_core/base/output_folder.h"

#include "oc_core/base/error.h"

namespace ocelli {

void makeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) {
    return;
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw WorkError("the folder cannot be made: " + error.message(), folder.string(), "choose another folder");
  }
}

std::filesystem::path pathInFolder(const std::filesystem::path& folder, const std::string& file,
                                   const std::string& where) {
  const std::filesystem::path path = std::filesystem::path(file).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == ".." || !path.has_filename() || path == ".") {
    throw InputError("\"" + file + "\" is no file in the folder of the script's output", where,
                     "give a name such as \"town.json\", without a folder or in one below");
  }
  std::filesystem::path whole = folder / path;
  makeFolder(whole.parent_path());
  return whole;
}

}  // namespace ocelli
