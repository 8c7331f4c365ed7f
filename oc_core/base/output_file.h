// A file that appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "oc_core/base/unfinished_output.h"

namespace ocelli {

/// Writes to `PATH.partial` and renames it on commit(); until then a file at `path` stays as it was, and without
/// commit() nothing is left, also where a signal ends the program (unfinished_output.h). A link stays one, and what it
/// names is replaced. A path that is no regular file (a pipe, a device) is written directly, and so is one of this
/// program's own streams (/dev/stdout, /dev/fd/N), whatever it leads to. Every failure is a WorkError.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const uint8_t> bytes);
  void write(std::string_view text);
  /// Hands all that was written to the system: it is in the file even if this program is killed.
  void flush();
  /// For files that are read while they grow: what was written so far appears under the name now, and stays whatever
  /// happens; further writes and commit() follow.
  void publish();
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void fail(int reason) const;
  void rename();

  std::filesystem::path path_;     ///< as the user wrote it
  std::filesystem::path target_;   ///< where that leads
  std::filesystem::path written_;  ///< a temporary name, or target_ itself
  std::unique_ptr<std::FILE, Close> file_;
  UnfinishedOutput unfinished_;  ///< holds nothing where it is written directly
};

/// Throws now what OutputFile(path) would throw: for before long work. Leaves no trace.
void checkWritable(const std::filesystem::path& path);

/// Whether OutputFile(path) writes to it directly: pipes, devices, and this program's own streams.
bool isStream(const std::filesystem::path& path);
/// Whether the path is one of the names of this program's standard output.
bool isStandardOutput(const std::filesystem::path& path);

}  // namespace ocelli
