// A device at the other end of a link, and its worker's thread. For the files of this room: streaming_device.cpp runs
// the worker and its link, streaming_device_frames.cpp sends frames, streaming_device_news.cpp hears what became of
// them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "display_driver/wire/device_session.h"
#include "display_driver/wire/effort_choice.h"
#include "display_driver/wire/link_inbox.h"
#include "display_driver/wire/outgoing_frame.h"
#include "display_driver/wire/stream_device.h"
#include "oc_core/base/check.h"

namespace ocelli {

class StreamingDevice final : public Device {
 public:
  using Clock = std::chrono::steady_clock;

  StreamingDevice(std::unique_ptr<wire::LinkPort> port, const StreamOptions& options)
      : port_(std::move(port)), options_(options) {
    buffers_.resize(static_cast<size_t>(options.transfersInFlight));
    connect();
    worker_ = std::thread([this] { work(); });
  }
  ~StreamingDevice() override { StreamingDevice::close(); }

  const DeviceInfo& info() const override { return info_; }
  const DisplayProfile& profile() const override { return *profile_; }

  void present(FrameNumber number, const Presentation& presentation) override {
    const std::lock_guard lock(mutex_);
    const std::shared_ptr<OutgoingFrame> frame = find(number);
    if (frame != nullptr) {
      frame->presentation = presentation;
      frame->presentationSent = false;
      wakeWorker();
    }
  }

  Telemetry telemetry() override {
    const std::lock_guard lock(mutex_);
    return telemetry_;
  }

  void close() override {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
      wakeWorker();
    }
    port_->wake();
    if (worker_.joinable()) {
      worker_.join();
    }
    link_.reset();
    const std::lock_guard lock(mutex_);
    telemetry_.connected = false;
    loseAll("the device was closed");
    endWaiting(FrameStage::kLost, "the device was closed");
  }

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>> changedSlices) override {
    OC_CHECK(volume->profile() == *profile_, "a volume of another display");
    const std::lock_guard lock(mutex_);
    const auto frame = std::make_shared<OutgoingFrame>(++lastNumber_);
    frame->volume = std::move(volume);
    if (changedSlices) {
      frame->changed = {changedSlices->begin(), changedSlices->end()};
    }
    ++telemetry_.framesSubmitted;
    if (waiting_ != nullptr) {
      frame->changed = unite(frame->changed, waiting_->changed);
      ++telemetry_.framesDropped;
      endWaiting(FrameStage::kDropped, "a newer frame came before it could be sent");
    }
    waiting_ = frame;
    wakeWorker();
    return frame->fence;
  }

 private:
  // Below, functions without a note run on the worker's thread without the mutex.

  void connect();
  void work();
  bool reconnect();
  bool step(bool& idle);
  void readNews();
  void handle(const wire::Event& event);
  void updateTelemetry();
  bool sendSome();
  void beginFrame();
  void sendPresentations();
  void flush();
  std::vector<uint8_t>* staging();
  void recover(wire::LinkStatus status);
  void startSession();
  void forgetTransfers();
  bool isStuck() const;
  void loseUnanswered();
  void beginAnew();

  /// With the mutex.
  void wakeWorker() {
    woken_ = true;
    changed_.notify_one();
  }
  /// With the mutex. A frame that has not ended.
  std::shared_ptr<OutgoingFrame> find(FrameNumber number) const {
    if (waiting_ != nullptr && waiting_->number() == number) {
      return waiting_;
    }
    const auto found = underWay_.find(number);
    return found == underWay_.end() ? nullptr : found->second;
  }
  /// With the mutex.
  void endWaiting(FrameStage stage, const std::string& problem) {
    if (waiting_ != nullptr) {
      waiting_->end(stage, problem);
      waiting_.reset();
    }
  }
  void lose(std::shared_ptr<OutgoingFrame> frame, const std::string& problem);
  void loseAll(const std::string& problem);
  void noteSent(const OutgoingFrame& frame) {
    lastSent_ = frame.volume;
    lastSentNumber_ = frame.number();
  }
  void noteProblem(const std::string& problem) { telemetry_.lastProblem = problem; }  ///< with the mutex

  std::unique_ptr<wire::LinkPort> port_;
  StreamOptions options_;
  DeviceInfo info_;
  std::optional<DisplayProfile> profile_;
  std::thread worker_;

  // The worker's own.
  std::unique_ptr<wire::Link> link_;  ///< nullptr: not connected
  LinkInbox inbox_;
  uint32_t capabilities_ = 0;
  std::optional<wire::FrameEncoder> encoder_;
  std::vector<wire::FrameEncoder::Coded> coded_;  ///< slices of the frame that is being sent
  size_t nextCoded_ = 0;
  std::optional<wire::MessageWriter> writer_;
  EffortChoice effort_;
  uint32_t session_ = 0;
  struct Buffer {
    std::vector<uint8_t> bytes;
    uint64_t transfer = 0;  ///< 0: not on its way
  };
  std::vector<Buffer> buffers_;
  Buffer* staging_ = nullptr;
  uint64_t transfers_ = 0;  ///< begun in all
  uint64_t transfersDone_ = 0;
  Clock::time_point lastProgress_;
  Clock::time_point nextTelemetry_;
  std::shared_ptr<OutgoingFrame> sending_;
  std::shared_ptr<const Volume> base_;  ///< of the next frame: the one that was sent before; nullptr: a whole frame
  FrameNumber baseNumber_ = 0;
  std::shared_ptr<const Volume> lastSent_;  ///< of any session, once it had a presentation
  FrameNumber lastSentNumber_ = 0;
  std::optional<wire::LinkStatus> problem_;  ///< of the link
  std::optional<std::string> lost_;          ///< a frame was, and why
  std::chrono::milliseconds backOff_{0};
  std::chrono::milliseconds rest_{0};  ///< after a lost frame; 0 once one has arrived
  Clock::time_point restUntil_;
  std::optional<uint32_t> deviceUnderruns_;
  Clock::time_point lastAnswer_;                  ///< to a request for telemetry
  std::optional<Clock::time_point> deviceStart_;  ///< the zero of the display's clock

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
  bool closing_ = false;
  FrameNumber lastNumber_ = 0;
  std::shared_ptr<OutgoingFrame> waiting_;
  std::map<FrameNumber, std::shared_ptr<OutgoingFrame>> underWay_;  ///< begun, not ended
  Telemetry telemetry_;
};

}  // namespace ocelli
