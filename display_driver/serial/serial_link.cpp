#include "display_driver/serial/serial_link.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <random>
#include <thread>

#include "display_driver/serial/serial_frame.h"
#include "display_driver/serial/serial_stream.h"
#include "display_driver/wire/stream_device.h"
#include "display_driver/wire/wire_format.h"
#include "oc_core/base/error.h"
#include "oc_core/base/record_bytes.h"
#include "oc_core/base/serial_port.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using serial::PacketType;
using serial::Time;
using wire::LinkError;
using wire::LinkStatus;

constexpr auto kOpenAgainAfter = 100ms;
constexpr auto kOpenTime = 3000ms;  // boards that restart when they are opened need a while
constexpr auto kRequestTime = 1500ms;
constexpr auto kSilence = 1500ms;  // a display says something every 100 ms
constexpr auto kHeardEvery = 100ms;
constexpr int kPollMilliseconds = 10;
constexpr size_t kEventCapacity = size_t{1} << 16;
constexpr size_t kMaxLine = 2048;  // bytes that wait for the line; more would be late when something is lost

struct Answer {
  bool refused = false;
  std::vector<std::vector<uint8_t>> parts;
  std::vector<bool> have;
};

/// Ends a poll() of another thread.
class Bell {
 public:
  Bell() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}
  ~Bell() { close(descriptor_); }
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  int descriptor() const { return descriptor_; }
  void ring() const {
    const uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = write(descriptor_, &one, sizeof one);
  }
  void silence() const {
    uint64_t count = 0;
    [[maybe_unused]] const ssize_t bytes = read(descriptor_, &count, sizeof count);
  }

 private:
  int descriptor_;
};

class SerialLink final : public wire::Link {
 public:
  SerialLink(const SerialPlace& place, const std::string& where) : port_(place, where), events_(kEventCapacity) {
    description_ = {"", fmt::format("serial line {}, {} bit/s", place.device, place.bitsPerSecond),
                    place.bitsPerSecond / 10.0};
    connection_ = std::random_device()() | 1u;
    tcflush(port_.descriptor(), TCIOFLUSH);
    thread_ = std::thread([this] { run(); });
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, kOpenTime, [this] { return opened_ || broken_; }) || broken_) {
      lock.unlock();
      SerialLink::close();
      throw LinkError(LinkStatus::kTimedOut,
                      fmt::format("nothing at {} answers at {} bit/s", place.device, place.bitsPerSecond));
    }
  }
  ~SerialLink() override { SerialLink::close(); }
  SerialLink(const SerialLink&) = delete;
  SerialLink& operator=(const SerialLink&) = delete;

  const wire::LinkDescription& description() const override { return description_; }

  std::vector<uint8_t> controlIn(uint8_t request, uint16_t value, size_t maxBytes) override {
    return ask(serial::kRequestIn, request, value, static_cast<uint16_t>(std::min<size_t>(maxBytes, 0xffff)), {});
  }
  void controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) override {
    ask(serial::kRequestOut, request, value, static_cast<uint16_t>(bytes.size()), bytes);
  }

  void start(wire::LinkListener listener) override {
    const std::lock_guard lock(mutex_);
    listener_ = std::move(listener);
    bell_.ring();
  }

  bool send(size_t tag, std::span<const uint8_t> bytes) override {
    const std::lock_guard lock(mutex_);
    if (broken_ || closing_) {
      return false;
    }
    stream_.append(bytes);
    transfers_.push_back({tag, bytes.size(), stream_.end()});
    bell_.ring();
    return true;
  }

  void cancelAll() override {
    std::unique_lock lock(mutex_);
    cancelling_ = true;
    bell_.ring();
    changed_.wait(lock, [this] { return ended_ || (!cancelling_ && transfers_.empty() && !calling_); });
  }

  void clearStall() override {}  // a serial line has none

  void resetDevice() override {
    try {
      controlOut(static_cast<uint8_t>(wire::Request::kReset), 0, {});
    } catch (const LinkError&) {
      // It does not answer this either; the next connection begins anew.
    }
    const std::lock_guard lock(mutex_);
    broken_ = true;
    bell_.ring();
  }

  void close() override {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
      bell_.ring();
    }
    if (thread_.joinable()) {
      thread_.join();
    }
  }

 private:
  struct Transfer {
    size_t tag = 0;
    size_t bytes = 0;
    uint64_t end = 0;  ///< its position in the stream
  };

  std::vector<uint8_t> ask(uint8_t direction, uint8_t request, uint16_t value, uint16_t length,
                           std::span<const uint8_t> bytes) {
    std::unique_lock lock(mutex_);
    ++requestNumber_;
    request_.assign({requestNumber_, direction, request});
    serial::addNumber(request_, value, 2);
    serial::addNumber(request_, length, 2);
    request_.insert(request_.end(), bytes.begin(), bytes.end());
    requestSent_ = {};
    answer_ = {};
    const auto isWhole = [this] {
      return !answer_.have.empty() && std::find(answer_.have.begin(), answer_.have.end(), false) == answer_.have.end();
    };
    bell_.ring();
    const bool came = changed_.wait_for(lock, kRequestTime, [&] { return isWhole() || broken_ || closing_; });
    request_.clear();
    if (broken_ || closing_) {
      throw LinkError(LinkStatus::kGone, "the serial line is broken");
    }
    if (!came) {
      throw LinkError(LinkStatus::kTimedOut, "the display does not answer a request");
    }
    if (answer_.refused) {
      throw LinkError(LinkStatus::kStalled, "the display refused a request");
    }
    std::vector<uint8_t> all;
    for (const std::vector<uint8_t>& part : answer_.parts) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  void run() {
    std::unique_lock lock(mutex_);
    heard_ = Clock::now();
    while (!closing_ && !broken_) {
      addOutput(Clock::now());
      const bool more = !line_.empty();
      lock.unlock();
      std::array<pollfd, 2> watched{pollfd{port_.descriptor(), static_cast<short>(more ? POLLIN | POLLOUT : POLLIN), 0},
                                    pollfd{bell_.descriptor(), POLLIN, 0}};
      poll(watched.data(), watched.size(), kPollMilliseconds);
      bell_.silence();
      lock.lock();
      if (!moveBytes((watched[0].revents & POLLHUP) != 0) || (opened_ && Clock::now() - heard_ >= kSilence)) {
        broken_ = true;
      }
      finishTransfers(lock);
      handEvents(lock);
    }
    const LinkStatus status = closing_ ? LinkStatus::kCancelled : LinkStatus::kGone;
    finishAll(lock, status);
    if (!closing_ && listener_.lost) {
      const auto lost = listener_.lost;
      call(lock, [&] { lost(LinkStatus::kGone); });
    }
    ended_ = true;
    changed_.notify_all();
  }

  /// What is due goes to the line, as long as it has room.
  void addOutput(Time now) {
    if (!opened_) {
      if (now - openSent_ >= kOpenAgainAfter) {
        std::vector<uint8_t> content;
        serial::addNumber(content, connection_, 4);
        line_.push_back(0);  // ends whatever stood on the line before
        serial::addPacket(line_, PacketType::kOpen, content);
        openSent_ = now;
      }
      return;
    }
    if (!request_.empty() && now - requestSent_ >= serial::kResendAfter) {
      serial::addPacket(line_, PacketType::kRequest, request_);
      requestSent_ = now;
    }
    if (events_.hasNews() || now - heardSent_ >= kHeardEvery) {
      serial::addPacket(line_, PacketType::kHeard, serial::creditContent(events_.tell()));
      heardSent_ = now;
    }
    while (line_.size() < kMaxLine) {
      const auto packet = stream_.next(now);
      if (!packet) {
        break;
      }
      serial::addPacket(line_, PacketType::kData, *packet);
    }
  }

  /// False where the device is gone.
  bool moveBytes(bool hungUp) {
    std::array<uint8_t, 4096> bytes;
    const ssize_t came = ::read(port_.descriptor(), bytes.data(), bytes.size());
    if (came > 0) {
      reader_.read(std::span(bytes).first(static_cast<size_t>(came)),
                   [this](const serial::Packet& packet) { take(packet); });
    } else if (hungUp || (came < 0 && errno != EAGAIN && errno != EINTR)) {
      return false;
    }
    if (!line_.empty()) {
      const ssize_t went = write(port_.descriptor(), line_.data(), line_.size());
      if (went < 0 && errno != EAGAIN && errno != EINTR) {
        return false;
      }
      if (went > 0) {
        line_.erase(line_.begin(), line_.begin() + went);
      }
    }
    return true;
  }

  void take(const serial::Packet& packet) {
    const Time now = Clock::now();
    const std::span<const uint8_t> content = packet.content;
    if (packet.type == PacketType::kOpened) {
      if (content.size() == 4 && serial::numberAt(content, 0, 4) == connection_) {
        opened_ = true;
        heard_ = now;
        changed_.notify_all();
      }
      return;
    }
    if (!opened_) {
      return;  // of a connection before
    }
    heard_ = now;
    if (packet.type == PacketType::kCredit) {
      stream_.hear(content, now);
    } else if (packet.type == PacketType::kEvents) {
      events_.take(content);
    } else if (packet.type == PacketType::kAnswer) {
      takeAnswer(content);
    }
  }

  void takeAnswer(std::span<const uint8_t> content) {
    constexpr size_t kHead = 4;
    if (request_.empty() || content.size() < kHead || content[0] != requestNumber_ || content[3] == 0 ||
        content[2] >= content[3]) {
      return;
    }
    answer_.refused = content[1] != 0;
    answer_.parts.resize(content[3]);
    answer_.have.resize(content[3], false);
    answer_.parts[content[2]].assign(content.begin() + kHead, content.end());
    answer_.have[content[2]] = true;
    changed_.notify_all();
  }

  template <class Function>
  void call(std::unique_lock<std::mutex>& lock, Function&& function) {
    calling_ = true;
    lock.unlock();
    function();
    lock.lock();
    calling_ = false;
    changed_.notify_all();
  }

  void finish(std::unique_lock<std::mutex>& lock, LinkStatus status, size_t bytes) {
    const Transfer transfer = transfers_.front();
    transfers_.pop_front();
    if (const auto sent = listener_.sent) {
      call(lock, [&] { sent(transfer.tag, status, bytes); });
    }
  }

  void finishAll(std::unique_lock<std::mutex>& lock, LinkStatus status) {
    while (!transfers_.empty()) {
      const Transfer& first = transfers_.front();
      const uint64_t left = first.end - std::min(first.end, stream_.taken());
      finish(lock, status, first.bytes - std::min<size_t>(first.bytes, static_cast<size_t>(left)));
    }
  }

  void finishTransfers(std::unique_lock<std::mutex>& lock) {
    while (!transfers_.empty() && transfers_.front().end <= stream_.taken()) {
      finish(lock, LinkStatus::kDone, transfers_.front().bytes);
    }
    if (cancelling_) {
      stream_.dropUnsent();
      finishAll(lock, LinkStatus::kCancelled);
      cancelling_ = false;
      changed_.notify_all();
    }
  }

  void handEvents(std::unique_lock<std::mutex>& lock) {
    const auto received = listener_.received;
    if (events_.bytes().empty() || !received) {
      return;
    }
    const std::vector<uint8_t> bytes = events_.bytes();
    events_.use(bytes.size());
    call(lock, [&] { received(bytes); });
  }

  using Clock = std::chrono::steady_clock;

  SerialPort port_;
  Bell bell_;
  wire::LinkDescription description_;
  uint32_t connection_ = 0;

  std::mutex mutex_;  ///< over what follows
  std::condition_variable changed_;
  wire::LinkListener listener_;
  bool opened_ = false;
  bool broken_ = false;
  bool closing_ = false;
  bool cancelling_ = false;
  bool calling_ = false;
  bool ended_ = false;
  serial::PacketReader reader_;
  serial::SerialSender stream_;
  serial::SerialReceiver events_;
  std::deque<Transfer> transfers_;
  std::vector<uint8_t> line_;  ///< bytes that the device has not taken yet
  std::vector<uint8_t> request_;
  uint8_t requestNumber_ = 0;
  Answer answer_;
  Time openSent_{};
  Time requestSent_{};
  Time heardSent_{};
  Time heard_{};

  std::thread thread_;
};

class SerialLinkPort final : public wire::LinkPort {
 public:
  explicit SerialLinkPort(const std::string& place) : where_("serial:" + place) {
    constexpr std::string_view kBaud = ",baud=";
    std::string text = place;
    if (const size_t at = text.find(kBaud); at != std::string::npos) {
      text.replace(at, kBaud.size(), ",");
    }
    place_ = serialPlaceFromText(text, where_);
  }

  std::string description() const override { return "a display at " + place_.device; }

  std::unique_ptr<wire::Link> open() override {
    try {
      return std::make_unique<SerialLink>(place_, where_);
    } catch (const Error& error) {
      throw LinkError(LinkStatus::kGone, ErrorText(error.what()).what);
    }
  }

  void waitForArrival(std::chrono::milliseconds timeout) override {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, timeout, [this] { return woken_; });
    woken_ = false;
  }

  void wake() override {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    wake_.notify_all();
  }

 private:
  std::string where_;
  SerialPlace place_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool woken_ = false;
};

}  // namespace

std::unique_ptr<wire::LinkPort> serialPort(const std::string& place) {
  return std::make_unique<SerialLinkPort>(place);
}

std::unique_ptr<Device> openSerialDevice(const std::string& place) {
  StreamOptions options;
  options.kind = "serial";
  options.transferBytes = 4096;  // so that something is done every second at 57600 bit/s
  options.transfersInFlight = 4;
  options.stuckAfter = 3s;
  options.telemetryInterval = 200ms;
  return openStreamDevice(serialPort(place), options);
}

}  // namespace ocelli
