// Volumes that are made in two stages, each on a thread of its own: while one is in its second stage, the next one is
// in its first.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "display_driver/pacing/volume_source.h"

namespace ocelli {

class TwoStageLine final : public VolumeLine {
 public:
  using SecondStage = std::function<SourcedVolume()>;
  using FirstStage = std::function<SecondStage(HostTime seen)>;

  /// What `first` returns is called on another thread, one at a time and in order. What either throws comes out of
  /// finished().
  explicit TwoStageLine(FirstStage first);
  /// Waits for what is being made.
  ~TwoStageLine() override;
  TwoStageLine(const TwoStageLine&) = delete;
  TwoStageLine& operator=(const TwoStageLine&) = delete;

  bool ready() const override;
  void begin(HostTime seen) override;
  std::optional<SourcedVolume> finished() override;

 private:
  struct Made {
    SourcedVolume volume;
    std::exception_ptr failure;
  };
  void runFirst();
  void runSecond();

  FirstStage first_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<HostTime> asked_;    ///< not begun yet, or in the first stage
  std::deque<SecondStage> between_;  ///< at most one, beside that in the second stage
  std::deque<Made> made_;
  size_t underWay_ = 0;  ///< begun, and not taken yet
  bool stopping_ = false;
  std::thread firstThread_;
  std::thread secondThread_;
};

}  // namespace ocelli
