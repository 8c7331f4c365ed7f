#include "study/store/export_record.h"

#include <SQLiteCpp/Exception.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExported = "exported";

}  // namespace

void addExportRecord(SQLite::Database& database, const ExportRecord& record) {
  nlohmann::ordered_json detail = {{"folder", record.folder.string()}, {"files", record.files}};
  if (record.isReport) {
    detail["report"] = true;
  }
  addAudit(database, kExported, detail.dump());
}

std::vector<ExportRecord> exportRecordsOf(SQLite::Database& database) {
  std::vector<ExportRecord> records;
  SQLite::Statement row(database, "SELECT detail_json FROM audit WHERE action = ?");
  row.bind(1, kExported);
  while (row.executeStep()) {
    const auto detail = nlohmann::json::parse(textOf(row, 0), nullptr, false);
    if (!detail.is_object()) {
      continue;
    }
    ExportRecord record{detail.value("folder", ""), {}, detail.value("report", false)};
    for (const auto& file : detail.value("files", nlohmann::json::array())) {
      if (file.is_string() && !file.get<std::string>().empty()) {
        record.files.push_back(file.get<std::string>());
      }
    }
    records.push_back(std::move(record));
  }
  return records;
}

bool recordReport(const fs::path& path, const fs::path& folder, const std::vector<std::string>& files) {
  try {
    const DatabaseLock lock(path, DatabaseUse::kExport);
    SQLite::Database database = connectStudy(path, DatabaseAccess::kWrite);
    const ExportRecord record{fs::absolute(folder).lexically_normal(), files, true};
    for (const ExportRecord& known : exportRecordsOf(database)) {
      if (known.isReport && known.folder == record.folder && known.files == record.files) {
        return true;
      }
    }
    addExportRecord(database, record);
    return true;
  } catch (const InputError&) {
  } catch (const WorkError&) {
  } catch (const SQLite::Exception&) {
  } catch (const nlohmann::json::exception&) {
  }
  return false;
}

}  // namespace ocelli
