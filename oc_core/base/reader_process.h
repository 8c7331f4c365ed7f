// Files of other programs are read by programs of ours, each a process of its own (child_process.h): where the library
// that reads them crashes, hangs or asks for too much memory, that is an error message here. What all such readers
// share: their limits, and what becomes of their ends. A reader is a row: a ReaderProgram.
//
// For the .cpp files that run one, and for the programs themselves, which keep to the same limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/byte_sink.h"
#include "oc_core/base/child_process.h"
#include "oc_core/base/own_program.h"

namespace ocelli {

/// What differs between readers: names, and words of their error messages.
struct ReaderProgram {
  OwnProgram program;
  const char* library;          ///< what crashes in it: "Assimp"
  const char* memoryVariable;   ///< of the environment: another limit of memory, in GiB
  const char* secondsVariable;  ///< another limit of processor time
  const char* convert;          ///< what to do where a file takes too long: "convert it to binary PLY"
  const char* afterCrash;       ///< what to do after a crash
  const char* reduce;           ///< what to do for less memory: "reduce the mesh"
};

/// What reading may take. It grows with the bytes of the files that are opened for it.
struct ReadingLimits {
  double memoryBase = 0;     ///< bytes
  double memoryPerByte = 0;  ///< bytes a byte of files
  double memoryMax = 0;      ///< bytes
  double secondsBase = 0;    ///< of one processor
  double secondsPerByte = 0;

  uint64_t memoryBytes(uint64_t fileBytes) const;
  double processorSeconds(uint64_t fileBytes) const;
  /// More than the seconds of a CPU, which may be busy with other things, or wait for a disk.
  double wallSeconds(uint64_t fileBytes) const;
};

/// 1 GiB and 64 bytes a byte, up to three quarters of the memory of this machine; 30 s and 1 s a MiB. The environment
/// variables of the reader set other limits, which do not grow. Throws InputError where one of them is no positive
/// number.
ReadingLimits readingLimits(const ReaderProgram& reader);

/// Exit codes of readers. What is wrong with a file stands in the record of a good end.
inline constexpr int kReaderDone = 0;
inline constexpr int kReaderFailed = 1;
inline constexpr int kReaderOutOfMemory = 3;

/// The record that a reader handed back.
struct ReaderResult {
  ChildBytes record;
  std::string program;  ///< the path of the reader, for error messages
};

/// Runs it with this process's ID and these arguments. `fileBytes` is what its limits grow by, `path` what it reads.
/// Throws InputError where the file cannot be read for whatever reason, WorkError where the program is missing or
/// fails, and what `tick` throws, which is called at least ten times a second.
ReaderResult runReaderProgram(const ReaderProgram& reader, const std::vector<std::string>& arguments,
                              const std::filesystem::path& path, uint64_t fileBytes, const std::function<void()>& tick);

/// In the reader: hands a record back, in pieces of any size. Throws WorkError where that fails.
class ReaderOutput {
 public:
  void write(std::span<const std::byte> bytes);
  void flush();

 private:
  std::vector<std::byte> buffer_;
};

}  // namespace ocelli
