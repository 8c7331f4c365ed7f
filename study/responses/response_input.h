// All that subjects press, debounced: the keys of the window and those of devices.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/responses/debouncer.h"
#include "study/responses/response_device.h"

namespace ocelli {

inline constexpr double kUsualDebounceMilliseconds = 10;

struct ResponseState {
  std::string device;
  bool connected = true;
  ResponseCounts counts{};
  int64_t bounces = 0;
};

class ResponseInput {
 public:
  /// `debounceMilliseconds` is for the keyboard and for each device by itself; 0 lets everything pass.
  ResponseInput(std::vector<std::unique_ptr<ResponseDevice>> devices, double debounceMilliseconds);

  /// What passes of a key of the window.
  std::vector<KeyChange> takeKey(const KeyChange& change) { return keyboard_.take(change); }
  /// What came from devices since the last call, and keys that were held back until now. `nanoseconds` is now, of the
  /// steady clock. On the thread that calls takeKey().
  std::vector<KeyChange> take(int64_t nanoseconds);

  bool mustBePolled() const;
  /// On the main thread.
  void poll();

  /// The keyboard first.
  std::vector<ResponseState> states() const;
  double debounceMilliseconds() const { return debounceMilliseconds_; }
  /// Devices that have gone since the last call.
  std::vector<std::string> lost();

 private:
  struct Source {
    std::unique_ptr<ResponseDevice> device;
    Debouncer debouncer;
    bool toldLost = false;
  };
  double debounceMilliseconds_;
  Debouncer keyboard_;
  std::vector<Source> sources_{};
};

}  // namespace ocelli
