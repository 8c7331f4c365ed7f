#include "study/live/live_board.h"

#include <utility>

#include "oc_core/base/steady_time.h"

namespace ocelli {

void LiveBoard::post(LiveStatus status) {
  auto posted = std::make_shared<const Posted>(Posted{std::move(status), steadyNanoseconds()});
  const std::scoped_lock lock(mutex_);
  newest_.swap(posted);  // the old one is let go of after the lock, as `posted` was made before it
}

std::string LiveBoard::json() const {
  std::shared_ptr<const Posted> newest;
  {
    const std::scoped_lock lock(mutex_);
    newest = newest_;
  }
  if (newest == nullptr) {
    return R"({"state":"not begun"})";
  }
  return jsonText(newest->status, static_cast<double>(steadyNanoseconds() - newest->nanoseconds) * 1e-9);
}

}  // namespace ocelli
