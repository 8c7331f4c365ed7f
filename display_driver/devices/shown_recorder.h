// Records what an emulated display shows, refresh by refresh, with what went wrong in its timing.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "display_driver/firmware/refresh_sink.h"
#include "display_sim/frames/svol_writer.h"

namespace ocelli {

/// One refresh of the record.
struct RecordedRefresh {
  ShownRefresh shown;
  /// The frame of the .svol file with what the screen showed; nullopt: it was too much to write, and is left out.
  std::optional<size_t> volume;
};

/// Volumes go to a growing .svol file, one whenever what is shown changes; times are the display's. It is written on a
/// thread of its own, so that the display goes on in real time; a refresh that it cannot keep up with is left out.
class ShownRecorder : public RefreshSink {
 public:
  /// Throws WorkError where the file cannot be made.
  ShownRecorder(const std::filesystem::path& path, const DisplayProfile& profile);
  ~ShownRecorder() override;

  void refreshEnded(const ShownRefresh& refresh, const Volume& volume) override;

  /// Ends the file. Throws WorkError where something could not be written. Call it after the display has ended.
  void finish();
  const std::vector<RecordedRefresh>& refreshes() const { return refreshes_; }

 private:
  void write();

  SvolWriter writer_;
  std::vector<RecordedRefresh> refreshes_;
  std::shared_ptr<const Volume> last_;         ///< the last volume
  std::vector<ShownRefresh::Part> lastParts_;  ///< of what it shows
  size_t volumes_ = 0;                         ///< handed to the thread

  struct Job {
    std::shared_ptr<const Volume> volume;
    uint64_t microseconds = 0;
  };
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Job> jobs_;
  bool ending_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

/// The record as a table for people and programs: a line a refresh.
void writeRefreshTable(const std::filesystem::path& path, const std::vector<RecordedRefresh>& refreshes);

}  // namespace ocelli
