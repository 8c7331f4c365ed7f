// Keeps this process within the limits of reader_process.h: for the programs that do nothing but read one file.
#pragma once

#include <cstdint>

#include "oc_core/base/reader_process.h"

namespace ocelli {

class ReadingBudget {
 public:
  /// Sets the system's limits on memory and processor time, and ends the process with kReaderOutOfMemory where it asks
  /// for more memory. Core files are off: a crash of a reader is nothing to keep.
  explicit ReadingBudget(const ReadingLimits& limits);

  /// Files of so many bytes are opened: both limits grow as ReadingLimits says.
  void addFile(uint64_t bytes);
  /// So many more bytes will be asked for, for a good reason.
  void addMemory(uint64_t bytes);
  /// So many more bytes will be written, to a disk.
  void addWriting(uint64_t bytes);

 private:
  void apply() const;

  ReadingLimits limits_;
  uint64_t fileBytes_ = 0;
  uint64_t memoryBytes_ = 0;
  uint64_t writtenBytes_ = 0;
};

}  // namespace ocelli
