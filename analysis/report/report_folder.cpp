#include "analysis/report/report_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "analysis/report/json_report.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const fs::path& where, int reason) {
  throw WorkError(fmt::format("cannot be written: {}", std::strerror(reason)), where.string(),
                  "free some space there, or name a folder that can be written");
}

bool isReport(const fs::path& folder) {
  std::ifstream file(folder / "report.json");
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  return json.is_object() && json.contains("format") && json["format"] == kReportFormat;
}

/// Throws where the folder holds what is no report.
void checkReplaceable(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder, error);
  if (status.type() == fs::file_type::not_found) {
    return;
  }
  const bool replaceable =
      status.type() == fs::file_type::directory && (fs::is_empty(folder, error) || (!error && isReport(folder)));
  if (!replaceable) {
    throw InputError("exists, and is no report of an analysis", folder.string(),
                     "name a folder that does not exist yet");
  }
}

/// Removed with all it holds unless it was renamed.
class PartialFolder {
 public:
  explicit PartialFolder(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    if (!fs::create_directory(path_, error)) {
      failWriting(path_, error ? error.value() : EEXIST);
    }
  }
  ~PartialFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void writeFile(const fs::path& path, const std::string& bytes) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) {
    failWriting(path.parent_path(), error.value());
  }
  const auto close = [](std::FILE* file) { std::fclose(file); };
  std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "wbx"), close);
  if (!file) {
    failWriting(path, errno);
  }
  // A full disk may only show when the bytes are forced out.
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  if (!written || std::fflush(file.get()) != 0 || ::fsync(::fileno(file.get())) != 0) {
    failWriting(path, errno);
  }
}

/// The new folder takes the place of the old one, which then lies where the new one was.
void exchange(const fs::path& made, const fs::path& folder) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
    return;
  }
  // Some file systems cannot exchange: in two steps.
  const fs::path aside = fs::path(made).concat(".old");
  std::error_code error;
  fs::rename(folder, aside, error);
  if (!error) {
    fs::rename(made, folder, error);
    std::error_code ignored;
    if (error) {
      fs::rename(aside, folder, ignored);
    } else {
      fs::remove_all(aside, ignored);
    }
  }
  if (error) {
    failWriting(folder, error.value());
  }
}

/// "report/" and "report" are the same folder.
fs::path targetOf(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

constexpr std::string_view kPartial = ".partial-";

/// What processes left that were killed.
void removeLeftovers(const fs::path& target) {
  const std::string start = target.filename().string().append(kPartial);
  std::error_code error;
  const fs::path beside = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::vector<fs::path> leftovers;
  for (fs::directory_iterator at(beside, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    pid_t process = 0;
    const char* const last = name.data() + name.size();
    if (name.starts_with(start) && name.size() > start.size()) {
      const auto read = std::from_chars(name.data() + start.size(), last, process);
      if (read.ec == std::errc() && read.ptr == last && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) {
        leftovers.push_back(at->path());
      }
    }
  }
  for (const fs::path& leftover : leftovers) {
    fs::remove_all(leftover, error);
  }
}

}  // namespace

fs::path unfinishedReportFolder(const fs::path& folder) {
  return targetOf(folder).concat(kPartial).concat(std::to_string(::getpid()));
}

void checkReportFolder(const fs::path& folder) {
  const fs::path target = targetOf(folder);
  checkReplaceable(target);
  removeLeftovers(target);
  const PartialFolder made(unfinishedReportFolder(target));
}

void writeReportFolder(const fs::path& folder, const std::vector<ReportFile>& files) {
  const fs::path target = targetOf(folder);
  checkReplaceable(target);
  for (const ReportFile& file : files) {
    const fs::path name = fs::path(file.name).lexically_normal();
    if (name.empty() || name.is_absolute() || *name.begin() == ".." || !name.has_filename()) {
      throw InputError("is no name of a file in a report", file.name, "name it without '..' and '/' at its ends");
    }
  }
  removeLeftovers(target);
  const PartialFolder made(unfinishedReportFolder(target));
  for (const ReportFile& file : files) {
    writeFile(made.path() / file.name, file.bytes);
  }
  checkReplaceable(target);
  std::error_code error;
  if (fs::exists(target, error)) {
    exchange(made.path(), target);
  } else {
    fs::rename(made.path(), target, error);
    if (error) {
      failWriting(target, error.value());
    }
  }
}

}  // namespace ocelli
