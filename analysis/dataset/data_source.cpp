#include <filesystem>

#include "analysis/dataset/csv_export.h"
#include "analysis/dataset/database.h"
#include "analysis/dataset/dataset.h"

namespace ocelli {

Dataset readSource(const std::string& path, const std::string& protocolFile) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? readCsvExport(path, protocolFile) : readDatabase(path);
}

}  // namespace ocelli
