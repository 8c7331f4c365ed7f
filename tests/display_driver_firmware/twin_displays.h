// The firmware and the slow display of the page side by side: both take the same bytes and turn at the same times, and
// must say and show the same. What a host does comes from choices: random numbers of a test, or the bytes of a fuzzer.
#pragma once

#include <deque>
#include <functional>
#include <stdexcept>
#include <string>

#include "display_driver/firmware/firmware.h"
#include "tests/display_driver_firmware/slow_display.h"

namespace ocelli::test {

/// The two differ.
class Difference : public std::logic_error {
  using std::logic_error::logic_error;
};

/// A profile of little volumes, whose width is no multiple of eight.
DisplayProfile tinyProfile(int slices = 5, int bits = 1);
SlowOptions slowOptions(const FirmwareOptions& options, size_t maxPayload);
Slices slicesOf(const Volume& volume);

class TwinDisplays : RefreshSink, ArrivalSink {
 public:
  explicit TwinDisplays(const FirmwareOptions& options);
  ~TwinDisplays() override = default;

  void arm(uint32_t session);
  void disarm();
  void reset();
  /// Behind what still waits; both take what they take.
  void send(ByteSpan bytes);
  /// The screen comes to the next slice.
  void step();
  /// Throws Difference. All of the above do so as well.
  void compare();

  bool idle() const { return waiting_.empty() && !slow_.full(); }
  const SlowDisplay& slow() const { return slow_; }
  Firmware& firmware() { return firmware_; }
  DeviceMicroseconds now() const { return now_; }
  /// Frames that arrived in this session, and how many refreshes and events were compared.
  const std::vector<uint32_t>& arrivedFrames() const { return arrivedFrames_; }
  size_t refreshes = 0;
  size_t events = 0;

 private:
  void refreshEnded(const ShownRefresh& refresh, const Volume& volume) override;
  void frameArrived(uint32_t session, uint32_t frame, const Volume& volume) override;
  void offer();

  Firmware firmware_;
  SlowDisplay slow_;
  DeviceMicroseconds now_ = 0;
  uint32_t session_ = 0;
  Bytes waiting_;
  std::map<uint32_t, Slices> arrived_;
  std::vector<uint32_t> arrivedFrames_;
  struct Ended {
    Slices slices;
    std::vector<std::pair<size_t, int64_t>> parts;
  };
  std::vector<Ended> ended_;
};

/// A host that does all that a host can do, wrong things too.
class WildHost {
 public:
  /// A number below the given one.
  using Choice = std::function<size_t(size_t)>;

  /// `wildness`: how often in a thousand it does something wrong.
  WildHost(TwinDisplays& displays, const SlowOptions& options, Choice choice, size_t wildness);

  void doSomething();

 private:
  void beginFrame();
  void sendSlices(size_t count);
  void endFrame();
  void present();
  void message(uint8_t type, ByteSpan payload, uint8_t coding = 0, size_t slice = 0);
  bool wrong() { return choice_(1000) < wildness_; }
  Bytes planes();

  TwinDisplays& displays_;
  SlowOptions options_;
  Choice choice_;
  size_t wildness_;
  uint32_t session_ = 0;
  bool armed_ = false;  ///< as far as the host knows
  uint32_t sequence_ = 0;
  uint32_t frame_ = 0;
  uint32_t base_ = 0;
  bool open_ = false;
  std::vector<size_t> toSend_;
  std::vector<uint32_t> sums_;
};

}  // namespace ocelli::test
