#include "study/gaze/gaze_input.h"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "oc_core/base/steady_time.h"

namespace ocelli {
namespace {

constexpr int kLookMilliseconds = 50;  ///< after which the thread sees that it shall end

}  // namespace

struct GazeInput::State {
  State(std::unique_ptr<GazeBytes> theBytes, GazeLines theLines, size_t most)
      : bytes(std::move(theBytes)), lines(theLines), maxWaiting(most), thread([this] { run(); }) {}
  ~State() {
    ends = true;
    thread.join();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void run() {
    while (!ends) {
      const std::string text = bytes->read(kLookMilliseconds);
      if (!text.empty()) {
        keep(lines.read(text, steadyNanoseconds()));
      }
    }
  }

  void keep(const std::vector<GazeRecord>& samples) {
    const std::scoped_lock lock(mutex);
    counts.malformed = lines.malformed();
    for (const GazeRecord& sample : samples) {
      ++counts.samples;
      counts.valid += sample.valid ? 1 : 0;
      if (waiting.size() < maxWaiting) {
        waiting.push_back(sample);
      } else {
        ++counts.lost;
      }
    }
  }

  std::unique_ptr<GazeBytes> bytes;
  GazeLines lines;
  const size_t maxWaiting;
  std::atomic<bool> ends{false};
  mutable std::mutex mutex;
  std::vector<GazeRecord> waiting;  ///< guarded, as below
  GazeCounts counts{};
  std::thread thread;  ///< the last, as it uses the others
};

GazeInput::GazeInput(std::unique_ptr<GazeBytes> bytes, GazeLines lines, size_t maxWaiting)
    : state_(std::make_unique<State>(std::move(bytes), lines, maxWaiting)) {}

GazeInput::~GazeInput() = default;

std::vector<GazeRecord> GazeInput::take() {
  const std::scoped_lock lock(state_->mutex);
  return std::exchange(state_->waiting, {});
}

GazeCounts GazeInput::counts() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->counts;
}

}  // namespace ocelli
