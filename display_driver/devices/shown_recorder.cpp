#include "display_driver/devices/shown_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

/// Volumes that wait to be written.
constexpr size_t kMaxJobs = 3;

bool sameParts(const std::vector<ShownRefresh::Part>& a, const std::vector<ShownRefresh::Part>& b) {
  return std::ranges::equal(a, b, [](const ShownRefresh::Part& x, const ShownRefresh::Part& y) {
    return x.fromSlice == y.fromSlice && x.frame == y.frame && x.coarse == y.coarse;
  });
}

}  // namespace

ShownRecorder::ShownRecorder(const std::filesystem::path& path, const DisplayProfile& profile)
    : writer_(path, profile, {.growing = true}), thread_([this] { write(); }) {}

ShownRecorder::~ShownRecorder() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ShownRecorder::refreshEnded(const ShownRefresh& refresh, const Volume& volume) {
  // Frame 0 is darkness, or what was shown before a session ended: only a look tells whether it is the same.
  const bool known = std::ranges::all_of(refresh.parts, [](const auto& part) { return part.frame != 0; });
  if (last_ != nullptr && sameParts(refresh.parts, lastParts_) && (known || *last_ == volume)) {
    refreshes_.push_back({refresh, volumes_ - 1});
    return;
  }
  std::unique_lock lock(mutex_);
  if (jobs_.size() >= kMaxJobs || failure_ != nullptr) {
    refreshes_.push_back({refresh, std::nullopt});
    return;
  }
  lock.unlock();
  auto copy = std::make_shared<const Volume>(volume);
  lock.lock();
  last_ = std::move(copy);
  jobs_.push_back({last_, static_cast<uint64_t>(refresh.begin)});
  changed_.notify_all();
  lastParts_ = refresh.parts;
  refreshes_.push_back({refresh, volumes_++});
}

void ShownRecorder::write() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || !jobs_.empty(); });
    if (jobs_.empty()) {
      return;
    }
    const Job job = jobs_.front();
    if (failure_ == nullptr) {
      lock.unlock();
      std::exception_ptr failure;
      try {
        writer_.append(*job.volume, job.microseconds);
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      failure_ = failure;
    }
    jobs_.erase(jobs_.begin());
  }
}

void ShownRecorder::finish() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    changed_.notify_all();
  }
  thread_.join();
  if (failure_ != nullptr) {
    std::rethrow_exception(failure_);
  }
  writer_.finish();
}

void writeRefreshTable(const std::filesystem::path& path, const std::vector<RecordedRefresh>& refreshes) {
  OutputFile file(path);
  file.write("refresh,begin_us,length_us,phase_error_degrees,frames,torn,coarse,volume\n");
  for (const RecordedRefresh& refresh : refreshes) {
    std::string frames;
    bool coarse = false;
    for (const ShownRefresh::Part& part : refresh.shown.parts) {
      frames += fmt::format("{}{}@{}", frames.empty() ? "" : " ", part.frame, part.fromSlice);
      coarse = coarse || part.coarse;
    }
    file.write(fmt::format("{},{},{},{:.4f},{},{},{},{}\n", refresh.shown.refresh, refresh.shown.begin,
                           refresh.shown.length, refresh.shown.phaseErrorDegrees, frames,
                           refresh.shown.parts.size() > 1 ? 1 : 0, coarse ? 1 : 0,
                           refresh.volume ? std::to_string(*refresh.volume) : ""));
  }
  file.commit();
}

}  // namespace ocelli
