#include <filesystem>

#include "analysis/dataset/csv_export.h"
#include "analysis/dataset/database.h"
#include "analysis/dataset/dataset.h"
#include "oc_core/base/error.h"

namespace ocelli {

Dataset readSource(const std::string& path, const std::string& protocolFile) {
  std::error_code ignored;
  const std::string ending = std::filesystem::path(path).extension().string();
  if ((ending == ".csv" || ending == ".tsv") && std::filesystem::is_regular_file(path, ignored)) {
    throw InputError("this is a table, and no database", path,
                     "--columns MAP, which says which column is what; or the folder of an export of Ocelli");
  }
  return std::filesystem::is_directory(path, ignored) ? readCsvExport(path, protocolFile) : readDatabase(path);
}

}  // namespace ocelli
