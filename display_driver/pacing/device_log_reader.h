// Reads device logs (docs/device_log.md), record after record. Trusts nothing: volumes are those whose
// checksums are right, and what is wrong ends the log there. Takes no more memory than three volumes of the
// display, beside the volumes that its caller holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "display_driver/device/device.h"
#include "oc_core/base/error.h"

namespace ocelli {

enum class RecordingEnding {
  kFinished,    ///< it was closed
  kUnfinished,  ///< it was cut short, at the last whole record or within one
  kDamaged,     ///< damage() tells where
};

/// Times of states and readings are those of a clock that was 0 at the opening.
struct DeviceLogRecord {
  struct Submitted {
    FrameNumber frame = 0;
    std::shared_ptr<const Volume> volume;
    std::vector<int> changed;  ///< slices that may differ from the volume before; of the first one from darkness
  };
  struct Presented {
    FrameNumber frame = 0;
    Presentation presentation;
  };
  struct Ended {
    FrameNumber frame = 0;
    FrameState state;
  };
  uint64_t microseconds = 0;  ///< since the opening
  std::variant<Submitted, Presented, Ended, Telemetry> what;
};

class DeviceLogReader {
 public:
  /// Throws InputError where it does not begin as a log does.
  explicit DeviceLogReader(const std::filesystem::path& path);
  /// From a stream that outlives the reader; `where` names it in errors. Displays with larger volumes are refused.
  DeviceLogReader(std::istream& in, std::string where, size_t maxVolumeBytes = kMaxVolumeBytes);
  ~DeviceLogReader();
  DeviceLogReader(const DeviceLogReader&) = delete;
  DeviceLogReader& operator=(const DeviceLogReader&) = delete;

  const DeviceInfo& device() const { return device_; }
  const DisplayProfile& profile() const { return *profile_; }

  /// nullopt at the end, for whatever reason: see ending().
  std::optional<DeviceLogRecord> next();
  /// After next() has given nullopt.
  RecordingEnding ending() const { return ending_; }
  /// Has a value where ending() is kDamaged.
  const std::optional<InputError>& damage() const { return damage_; }
  const std::string& where() const { return where_; }

 private:
  struct Stream;
  void open(size_t maxVolumeBytes);
  bool readRecord();
  void readStream();
  [[noreturn]] void fail(const std::string& what) const;

  std::ifstream file_;
  std::istream& in_;
  std::string where_;
  DeviceInfo device_;
  std::optional<DisplayProfile> profile_;
  std::unique_ptr<Stream> stream_;
  uint64_t offset_ = 0;        ///< of the record under way
  uint64_t microseconds_ = 0;  ///< of the same
  uint32_t type_ = 0;          ///< likewise
  std::vector<uint8_t> payload_;
  size_t payloadRead_ = 0;  ///< of a stream
  RecordingEnding ending_ = RecordingEnding::kUnfinished;
  bool over_ = false;
  std::optional<InputError> damage_;
};

}  // namespace ocelli
