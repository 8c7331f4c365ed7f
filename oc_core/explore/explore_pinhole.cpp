// The camera that everyone knows: what the others start from and collapse to.
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

class LivePinhole final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override { return {GraphCamera(moment.view)}; }
};

}  // namespace

LiveConstructorRow livePinhole() {
  return {"pinhole", "the planar pinhole camera: rays are straight",
          "",        {},
          true,      [](const ExploreScene&) { return std::make_unique<LivePinhole>(); }};
}

}  // namespace ocelli
