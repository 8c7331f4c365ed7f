// The files of a report in a folder that is there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ocelli {

struct ReportFile {
  std::string name;  ///< relative, '/' between folders
  std::string bytes;
};

/// Where this process writes a report until it is whole, beside `folder`. What is left there by a process that was
/// killed is removed by the next report of that name.
std::filesystem::path unfinishedReportFolder(const std::filesystem::path& folder);

/// Before long work: throws as writeReportFolder() does where the folder holds anything else than a report, or cannot
/// be made. Leaves nothing behind.
void checkReportFolder(const std::filesystem::path& folder);

/// Written beside `folder` and then renamed to it. A report that was there before (its report.json says so) gives way
/// only to the whole new one; an empty folder too. InputError where there is anything else, for a name that leads
/// out of the folder, and where the disk is full or cannot be written: then nothing has changed.
void writeReportFolder(const std::filesystem::path& folder, const std::vector<ReportFile>& files);

}  // namespace ocelli
