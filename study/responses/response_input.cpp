#include "study/responses/response_input.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

int64_t nanosecondsOfMilliseconds(double milliseconds) {
  return std::llround(milliseconds * 1e6);
}

void append(std::vector<KeyChange>& all, const std::vector<KeyChange>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

ResponseInput::ResponseInput(std::vector<std::unique_ptr<ResponseDevice>> devices, double debounceMilliseconds)
    : debounceMilliseconds_(debounceMilliseconds), keyboard_(nanosecondsOfMilliseconds(debounceMilliseconds)) {
  for (std::unique_ptr<ResponseDevice>& device : devices) {
    sources_.push_back({std::move(device), Debouncer(nanosecondsOfMilliseconds(debounceMilliseconds))});
  }
}

std::vector<KeyChange> ResponseInput::take(int64_t nanoseconds) {
  std::vector<KeyChange> all = keyboard_.update(nanoseconds);
  for (Source& source : sources_) {
    for (const KeyChange& change : source.device->take()) {
      append(all, source.debouncer.take(change));
    }
    append(all, source.debouncer.update(nanoseconds));
  }
  std::ranges::stable_sort(all, {}, &KeyChange::nanoseconds);
  return all;
}

bool ResponseInput::mustBePolled() const {
  return std::ranges::any_of(sources_, [](const Source& source) { return source.device->mustBePolled(); });
}

void ResponseInput::poll() {
  for (const Source& source : sources_) {
    source.device->poll();
  }
}

std::vector<ResponseState> ResponseInput::states() const {
  std::vector<ResponseState> states{{"keyboard", true, {}, keyboard_.bounces()}};
  for (const Source& source : sources_) {
    states.push_back({source.device->description(), source.device->isConnected(), source.device->counts(),
                      source.debouncer.bounces()});
  }
  return states;
}

std::vector<std::string> ResponseInput::lost() {
  std::vector<std::string> lost;
  for (Source& source : sources_) {
    if (!source.device->isConnected() && !source.toldLost) {
      source.toldLost = true;
      lost.push_back(source.device->description());
    }
  }
  return lost;
}

}  // namespace ocelli
