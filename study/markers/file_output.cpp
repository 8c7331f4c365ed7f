// A line a marker in a CSV file. A thread of its own writes, so that no frame waits for a disk.
#include <fmt/format.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>

#include "oc_core/base/error.h"
#include "study/markers/marker_output.h"

namespace ocelli {
namespace {

/// Far more than wait in any session: where a disk hangs, memory does not fill up.
constexpr size_t kMaxWaiting = 100'000;

class FileMarkers : public MarkerOutput {
 public:
  explicit FileMarkers(std::ofstream file) : file_(std::move(file)), thread_([this] { run(); }) {}
  ~FileMarkers() override { FileMarkers::finish(); }
  FileMarkers(const FileMarkers&) = delete;
  FileMarkers& operator=(const FileMarkers&) = delete;

  void send(const Marker& marker) override {
    {
      const std::scoped_lock lock(mutex_);
      if (waiting_.size() >= kMaxWaiting) {
        ++counts_.lost;
        return;
      }
      waiting_.push_back(lineOf(marker));
    }
    wakes_.notify_one();
  }
  void finish() override {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    wakes_.notify_one();
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  MarkerCounts counts() const override {
    const std::scoped_lock lock(mutex_);
    return counts_;
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      wakes_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
      if (waiting_.empty()) {
        return;
      }
      const std::string line = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      file_ << line << "\r\n" << std::flush;
      const bool done = file_.good();
      file_.clear();
      lock.lock();
      ++(done ? counts_.sent : counts_.lost);
    }
  }

  std::ofstream file_;
  mutable std::mutex mutex_;
  std::condition_variable wakes_;
  std::deque<std::string> waiting_{};  ///< guarded, as all below
  MarkerCounts counts_{};
  bool ends_ = false;
  std::thread thread_;  ///< the last, as it uses the others
};

std::unique_ptr<MarkerOutput> openFile(const std::string& text) {
  const std::string where = "--markers file:" + text;
  std::error_code error;
  if (text.empty()) {
    throw InputError("must name a file", where, "such as file:markers.csv");
  }
  if (std::filesystem::exists(text, error)) {
    throw InputError("this file exists already", where,
                     "another name: a run does not overwrite the markers of another");
  }
  std::ofstream file(text, std::ios::binary);
  file << kMarkerColumns << "\r\n" << std::flush;
  if (!file) {
    throw WorkError("the file cannot be written", where, "check that its folder exists and may be written to");
  }
  return std::make_unique<FileMarkers>(std::move(file));
}

}  // namespace

MarkerOutputKind fileOutput() {
  return {"file", "file:PATH", "a CSV file, which must not exist yet", openFile};
}

}  // namespace ocelli
