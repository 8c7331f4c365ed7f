#include "display_driver/stream/stream_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "display_driver/device/volume_pool.h"
#include "display_driver/stream/device_session.h"
#include "display_driver/stream/effort_choice.h"
#include "display_driver/stream/link_inbox.h"
#include "display_driver/stream/outgoing_frame.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;
using wire::LinkError;
using wire::LinkStatus;

/// Slices that are coded before the link is looked after again: a few milliseconds of work.
constexpr size_t kSlicesAtOnce = 24;
/// After the second lost frame in a row; the first one goes again at once.
constexpr std::chrono::milliseconds kFirstRest(2);
/// What is left of a frame may take so long to leave, once it is coded, on any link.
constexpr std::chrono::milliseconds kShortBacklog(5);

/// Something was wrong with a message, not with the display.
bool isOfMessage(wire::ErrorCode code) {
  return code == wire::ErrorCode::kChecksum || code == wire::ErrorCode::kSequence || code == wire::ErrorCode::kLength ||
         code == wire::ErrorCode::kUnknownType;
}

class StreamDevice : public Device {
 public:
  StreamDevice(std::unique_ptr<wire::LinkPort> port, const StreamOptions& options)
      : port_(std::move(port)), options_(options) {
    buffers_.resize(static_cast<size_t>(options.transfersInFlight));
    connect();
    worker_ = std::thread([this] { work(); });
  }
  ~StreamDevice() override { StreamDevice::close(); }

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
  std::shared_ptr<const FrameFence> submitFrame(const Volume& volume,
                                                std::optional<std::span<const int>> changedSlices) override {
    OC_CHECK(volume.profile() == *profile_, "a volume of another display");
    const std::lock_guard submitLock(submitMutex_);
    const std::shared_ptr<const Volume> copy = pool_.copyOf(volume);
    const std::lock_guard lock(mutex_);
    const auto frame = std::make_shared<OutgoingFrame>(++lastNumber_);
    frame->volume = copy;
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
  void recover(LinkStatus status);
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
  std::optional<LinkStatus> problem_;  ///< of the link
  std::optional<std::string> lost_;    ///< a frame was, and why
  std::chrono::milliseconds backOff_{0};
  std::chrono::milliseconds rest_{0};  ///< after a lost frame; 0 once one has arrived
  Clock::time_point restUntil_;
  std::optional<uint32_t> deviceUnderruns_;
  Clock::time_point lastAnswer_;                  ///< to a request for telemetry
  std::optional<Clock::time_point> deviceStart_;  ///< the zero of the display's clock

  std::mutex submitMutex_;
  VolumePool pool_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
  bool closing_ = false;
  FrameNumber lastNumber_ = 0;
  std::shared_ptr<OutgoingFrame> waiting_;
  std::map<FrameNumber, std::shared_ptr<OutgoingFrame>> underWay_;  ///< begun, not ended
  Telemetry telemetry_;
};

void StreamDevice::connect() {
  auto link = port_->open();
  DisplayIdentity display = identify(*link);
  if (profile_ && *profile_ != display.profile) {
    throw LinkError(LinkStatus::kFailed, "another display, with the profile \"" + display.profile.name +
                                             "\", has come in the place of the first");
  }
  if (!profile_) {
    profile_ = display.profile;
    info_ = {options_.kind, display.identity.name, link->description().serial, link->description().text};
  }
  capabilities_ = display.identity.capabilities;
  encoder_.emplace(*profile_, capabilities_);
  link_ = std::move(link);
  inbox_.clear();
  link_->start(inbox_.listener([this] {
    const std::lock_guard lock(mutex_);
    wakeWorker();
  }));
  startSession();
  updateTelemetry();
  const std::lock_guard lock(mutex_);
  telemetry_.connected = true;
}

void StreamDevice::startSession() {
  session_ = newSession();
  arm(*link_, session_);
  writer_.emplace(session_);
  base_.reset();
  problem_.reset();
  lost_.reset();
  lastProgress_ = Clock::now();
}

void StreamDevice::work() {
  while (true) {
    if (link_ == nullptr && !reconnect()) {
      return;
    }
    bool idle = false;
    if (!step(idle)) {
      return;
    }
    if (problem_) {
      recover(*problem_);
      continue;
    }
    std::unique_lock lock(mutex_);
    if (idle && !woken_) {
      changed_.wait_until(lock, Clock::now() < restUntil_ ? std::min(nextTelemetry_, restUntil_) : nextTelemetry_);
    }
    woken_ = false;
  }
}

/// Until there is a link again; false where the device is being closed.
bool StreamDevice::reconnect() {
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (closing_) {
        return false;
      }
    }
    try {
      connect();
      backOff_ = {};
      const std::lock_guard lock(mutex_);
      ++telemetry_.reconnections;
      return true;
    } catch (const LinkError& error) {
      link_.reset();
      const std::lock_guard lock(mutex_);
      noteProblem(error.what());
    } catch (const Error& error) {
      link_.reset();
      const std::lock_guard lock(mutex_);
      noteProblem(error.what());
    }
    backOff_ = std::clamp(2 * backOff_, options_.firstBackOff, options_.lastBackOff);
    port_->waitForArrival(backOff_);
  }
}

/// One round of work; `idle` where there is nothing to do before something new comes. False: the device is being
/// closed.
bool StreamDevice::step(bool& idle) {
  {
    const std::lock_guard lock(mutex_);
    if (closing_) {
      return false;
    }
  }
  readNews();
  if (problem_) {
    return true;
  }
  loseUnanswered();
  if (lost_) {
    beginAnew();
  }
  if (!problem_ && Clock::now() >= nextTelemetry_) {
    updateTelemetry();
  }
  if (!problem_ && isStuck()) {
    problem_ = LinkStatus::kTimedOut;
  }
  if (!problem_) {
    idle = Clock::now() < restUntil_ || !sendSome();
  }
  return true;
}

bool StreamDevice::isStuck() const {
  const Clock::time_point now = Clock::now();
  if (transfersDone_ == transfers_ || now - lastProgress_ <= options_.stuckAfter) {
    return false;
  }
  // A display whose buffers hold frames for later takes no bytes until then, but it answers.
  const std::lock_guard lock(mutex_);
  const bool holdsFrames = std::ranges::any_of(underWay_, [](const auto& entry) {
    return entry.second->state.stage == FrameStage::kArrived && entry.second->presentation;
  });
  return !holdsFrames || now - lastAnswer_ > options_.stuckAfter;
}

/// Frames that went out whole and of which the display says nothing: its answer was lost.
void StreamDevice::loseUnanswered() {
  const std::lock_guard lock(mutex_);
  const auto unanswered = std::ranges::find_if(underWay_, [&](const auto& entry) {
    const FrameState& state = entry.second->state;
    return state.sent != Clock::time_point{} && state.arrived == Clock::time_point{} &&
           Clock::now() - state.sent > options_.stuckAfter;
  });
  if (unanswered != underWay_.end()) {
    lost_ = "the display did not acknowledge a frame";
  }
}

/// A frame is lost, and with it those that are made from it. In a new session nothing that is still on its way, in
/// either direction, can be mistaken for a part of what comes now.
void StreamDevice::beginAnew() {
  const std::string problem = *std::exchange(lost_, std::nullopt);
  sending_.reset();
  if (staging_ != nullptr) {
    staging_->bytes.clear();
  }
  {
    const std::lock_guard lock(mutex_);
    loseAll(problem);
  }
  // A display that refuses every frame is not asked again and again at the speed of the link.
  rest_ = std::min(std::max(2 * rest_, kFirstRest), options_.lastBackOff);
  restUntil_ = Clock::now() + (rest_ > kFirstRest ? rest_ : std::chrono::milliseconds(0));
  try {
    startSession();
  } catch (const LinkError& error) {
    problem_ = error.status();
  }
}

void StreamDevice::readNews() {
  const LinkInbox::News news = inbox_.take();
  for (const LinkInbox::Sent& sent : news.sent) {
    Buffer& buffer = buffers_[sent.tag];
    const uint64_t transfer = std::exchange(buffer.transfer, 0);
    buffer.bytes.clear();
    transfersDone_ = std::max(transfersDone_, transfer);
    lastProgress_ = Clock::now();
    const std::lock_guard lock(mutex_);
    telemetry_.bytesSent += sent.bytes;
    if (sent.status != LinkStatus::kDone) {
      problem_ = problem_.value_or(sent.status);
      continue;
    }
    for (const auto& [number, frame] : underWay_) {
      if (frame->lastTransfer != 0 && frame->lastTransfer <= transfer && frame->state.sent == Clock::time_point{}) {
        frame->state.sent = Clock::now();
        frame->fence->moveTo(frame->state);
        const Clock::duration coding = frame->coded - frame->begun;
        const Clock::duration backlog = frame->state.sent - frame->coded;
        effort_.frameSent(frame->waited || backlog > std::max<Clock::duration>(coding, kShortBacklog));
      }
    }
  }
  for (const wire::Event& event : news.events) {
    if (event.session == session_) {
      handle(event);
    }
  }
  if (news.lost) {
    problem_ = *news.lost;
  }
}

/// With the mutex. A newer frame comes anyway, or this one is sent again as soon as possible.
void StreamDevice::lose(std::shared_ptr<OutgoingFrame> frame, const std::string& problem) {
  ++telemetry_.framesLost;
  noteProblem(problem);
  underWay_.erase(frame->number());
  const bool newest = waiting_ == nullptr && (underWay_.empty() || underWay_.rbegin()->first < frame->number());
  if (closing_ || !newest) {
    frame->end(FrameStage::kLost, problem);
    return;
  }
  frame->presentationSent = false;
  frame->wholeSent = false;
  frame->lastTransfer = 0;
  frame->changed.reset();
  frame->state = {.coarse = frame->state.coarse, .problem = problem};
  frame->moveTo(FrameStage::kWaiting);
  waiting_ = frame;
}

/// With the mutex.
void StreamDevice::loseAll(const std::string& problem) {
  // The newest first: it is the one that may go again.
  while (!underWay_.empty()) {
    lose(underWay_.rbegin()->second, problem);
  }
}

void StreamDevice::handle(const wire::Event& event) {
  const std::lock_guard lock(mutex_);
  const auto found = underWay_.find(event.frame);
  const std::shared_ptr<OutgoingFrame> frame = found == underWay_.end() ? nullptr : found->second;
  const Clock::time_point time =
      deviceStart_ ? *deviceStart_ + std::chrono::microseconds(event.timeMicroseconds) : Clock::now();
  if (event.type == wire::EventType::kError) {
    const std::string problem = wire::nameOf(static_cast<wire::ErrorCode>(event.code));
    noteProblem(problem);
    // A stray part of a frame that is there whole does not harm it.
    const bool stray = static_cast<wire::ErrorCode>(event.code) == wire::ErrorCode::kOutOfPlace && frame != nullptr &&
                       frame->state.stage == FrameStage::kArrived;
    if (frame != nullptr && !stray) {
      lost_ = problem;
    } else if (event.frame == 0 && isOfMessage(static_cast<wire::ErrorCode>(event.code))) {
      // Nobody knows which message it was. A frame would be reported once more, by its number; a presentation not.
      for (const auto& [number, other] : underWay_) {
        other->presentationSent = false;
      }
    }
    return;
  }
  if (frame == nullptr) {
    return;
  }
  FrameState& state = frame->state;
  if (event.type == wire::EventType::kArrived) {
    ++telemetry_.framesArrived;
    rest_ = {};
    state.arrived = time;
    frame->moveTo(FrameStage::kArrived);
  } else if (event.type == wire::EventType::kDropped) {
    ++telemetry_.framesDropped;
    frame->end(FrameStage::kDropped, "a newer frame took its place in the display");
    underWay_.erase(found);
  } else if (event.type == wire::EventType::kShown) {
    state.shown = time;
    // The event has the low bits of the count.
    const uint64_t near = telemetry_.rotation ? telemetry_.rotation->refresh : event.refresh;
    state.shownRefresh =
        near +
        static_cast<uint64_t>(static_cast<int64_t>(static_cast<int32_t>(event.refresh - static_cast<uint32_t>(near))));
    state.shownSlice = event.code;
    state.late = (event.flags & wire::kEventLate) != 0;
    if ((event.flags & wire::kEventCoarse) != 0) {
      ++telemetry_.framesShownCoarse;
      state.coarse = true;
      frame->fence->moveTo(state);
    } else {
      ++telemetry_.framesShown;
      frame->moveTo(FrameStage::kShown);
      underWay_.erase(found);
    }
  }
}

void StreamDevice::updateTelemetry() {
  const Clock::time_point before = Clock::now();
  nextTelemetry_ = before + options_.telemetryInterval;
  const TelemetryAnswer answer = askTelemetry(*link_);
  if (!answer.telemetry) {
    if (answer.gone) {
      problem_ = LinkStatus::kGone;
    }
    const std::lock_guard lock(mutex_);
    noteProblem(answer.problem);
    return;
  }
  const wire::DeviceTelemetry& told = *answer.telemetry;
  const Clock::time_point after = Clock::now();
  lastAnswer_ = after;
  const Clock::time_point middle = before + (after - before) / 2;
  deviceStart_ = middle - std::chrono::microseconds(told.timeMicroseconds);
  const std::lock_guard lock(mutex_);
  telemetry_.rotation = RotationReading{.time = middle,
                                        .refresh = told.refresh,
                                        .share = told.refreshShare * 0x1p-32,
                                        .refreshSeconds = told.refreshNanoseconds * 1e-9};
  const double turnsPerRefresh = profile_->secondHalfTurn == SecondHalfTurn::kOwn ? 1 : 0.5;
  telemetry_.rotationsPerMinute = told.refreshNanoseconds == 0 ? 0 : 60e9 * turnsPerRefresh / told.refreshNanoseconds;
  telemetry_.phaseErrorDegrees = told.phaseErrorMicrodegrees * 1e-6;
  telemetry_.temperatureCelsius.reset();
  if (told.temperatureMillicelsius) {
    telemetry_.temperatureCelsius = *told.temperatureMillicelsius * 1e-3;
  }
  // It counts from 0 after it was reset; what it had counted when it was opened is not ours.
  const uint32_t counted = deviceUnderruns_.value_or(told.underruns);
  telemetry_.underruns += told.underruns - (told.underruns >= counted ? counted : 0);
  deviceUnderruns_ = told.underruns;
  telemetry_.fault = told.state == wire::DeviceState::kFault ? wire::nameOf(told.lastError) : "";
}

/// The buffer that messages are put in: nullptr where all are on their way.
std::vector<uint8_t>* StreamDevice::staging() {
  if (staging_ == nullptr) {
    const auto free = std::ranges::find(buffers_, uint64_t{0}, &Buffer::transfer);
    staging_ = free == buffers_.end() ? nullptr : &*free;
  }
  return staging_ == nullptr ? nullptr : &staging_->bytes;
}

void StreamDevice::flush() {
  if (staging_ == nullptr || staging_->bytes.empty()) {
    return;
  }
  if (transfersDone_ == transfers_) {
    lastProgress_ = Clock::now();  // the link was at rest
  }
  staging_->transfer = ++transfers_;
  if (!link_->send(static_cast<size_t>(staging_ - buffers_.data()), staging_->bytes)) {
    transfersDone_ = transfers_;
    staging_->transfer = 0;
    staging_->bytes.clear();
    problem_ = problem_.value_or(LinkStatus::kFailed);
  }
  staging_ = nullptr;
}

/// Some more of the stream. False where nothing can be done now.
bool StreamDevice::sendSome() {
  if (staging() == nullptr) {
    if (sending_ != nullptr) {
      sending_->waited = true;
    }
    return false;
  }
  sendPresentations();
  if (sending_ == nullptr) {
    beginFrame();
  }
  if (sending_ == nullptr) {
    flush();
    return false;
  }
  if (nextCoded_ == coded_.size()) {
    coded_ = encoder_->next(kSlicesAtOnce);
    nextCoded_ = 0;
  }
  std::vector<uint8_t>& out = *staging();
  const size_t before = out.size();
  while (nextCoded_ < coded_.size() && out.size() < options_.transferBytes) {
    const wire::FrameEncoder::Coded& coded = coded_[nextCoded_++];
    writer_->slice(out, sending_->number(), coded.slice, coded.coded);
  }
  const bool whole = nextCoded_ == coded_.size() && encoder_->slicesLeft() == 0;
  if (whole) {
    writer_->frameEnd(out, sending_->number());
  }
  {
    const std::lock_guard lock(mutex_);
    sending_->state.bytes += out.size() - before;
    if (whole) {
      sending_->wholeSent = true;
      sending_->coded = Clock::now();
      sending_->lastTransfer = transfers_ + 1;
      base_ = sending_->volume;
      baseNumber_ = sending_->number();
      if (sending_->presentation) {
        noteSent(*sending_);
      }
    }
  }
  if (whole) {
    sending_.reset();
  }
  if (whole || out.size() >= options_.transferBytes) {
    flush();
  }
  return true;
}

void StreamDevice::beginFrame() {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_ == nullptr) {
      return;
    }
    sending_ = std::move(waiting_);
    waiting_.reset();
    sending_->moveTo(FrameStage::kSending);
    underWay_.emplace(sending_->number(), sending_);
  }
  std::optional<std::span<const int>> candidates;
  if (base_ != nullptr && sending_->changed) {
    candidates = *sending_->changed;
  }
  sending_->begun = Clock::now();
  sending_->waited = false;
  encoder_->setEffort(effort_.effort());
  encoder_->begin(*sending_->volume, base_.get(), candidates);
  coded_.clear();
  nextCoded_ = 0;
  std::vector<uint8_t>& out = *staging();
  const size_t before = out.size();
  writer_->frameBegin(out, sending_->number(), {base_ == nullptr ? 0 : baseNumber_, encoder_->records()});
  {
    const std::lock_guard lock(mutex_);
    sending_->state.bytes = out.size() - before;
  }
  sendPresentations();
}

void StreamDevice::sendPresentations() {
  const std::lock_guard lock(mutex_);
  for (const auto& [number, frame] : underWay_) {
    if (frame->presentation && !frame->presentationSent) {
      frame->presentationSent = true;
      writer_->present(*staging(), number, toWire(*frame->presentation));
      if (frame->wholeSent) {
        noteSent(*frame);
      }
    }
  }
}

/// Nothing is on its way any more.
void StreamDevice::forgetTransfers() {
  for (Buffer& buffer : buffers_) {
    buffer.bytes.clear();
    buffer.transfer = 0;
  }
  staging_ = nullptr;
  transfersDone_ = transfers_;
  sending_.reset();
  base_.reset();
}

void StreamDevice::recover(LinkStatus status) {
  const std::string problem = fmt::format("the link to the display broke: {}", wire::nameOf(status));
  link_->cancelAll();
  readNews();  // what was acknowledged before
  forgetTransfers();
  {
    const std::lock_guard lock(mutex_);
    loseAll(problem);
    if (waiting_ == nullptr && lastSent_ != nullptr) {
      // A display that comes back is dark: once more, for nobody waits for it.
      waiting_ = std::make_shared<OutgoingFrame>(lastSentNumber_);
      waiting_->volume = lastSent_;
      waiting_->presentation = Presentation{};
    }
    noteProblem(problem);
  }
  try {
    if (status == LinkStatus::kGone) {
      throw LinkError(status, problem);
    }
    link_->clearStall();
    startSession();
  } catch (const LinkError& error) {
    if (error.status() != LinkStatus::kGone && status == LinkStatus::kTimedOut) {
      link_->resetDevice();
    }
    link_.reset();
    const std::lock_guard lock(mutex_);
    telemetry_.connected = false;
  }
}

}  // namespace

std::unique_ptr<Device> openStreamDevice(std::unique_ptr<wire::LinkPort> port, const StreamOptions& options) {
  const std::string where = port->description();
  try {
    return std::make_unique<StreamDevice>(std::move(port), options);
  } catch (const LinkError& error) {
    const bool none = error.status() == LinkStatus::kGone;
    throw WorkError(
        error.what(), where,
        none ? "connect the display and switch it on; `ocelli device list` shows what is found"
             : "see `ocelli device list`; close other programs that use it, or unplug it and plug it in again");
  }
}

}  // namespace ocelli
