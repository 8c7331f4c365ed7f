// A whole maze in one image (section 4.3.2.2), as an overview of where the walker is. Its rays come from before the
// entrance, so no bending leads to it from the walker's pinhole: the picture dissolves.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

class LiveComprehensive final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    const glm::ivec2 size(moment.view.width(), moment.view.height());
    if (!made_ || size_ != size) {
      made_ = std::make_shared<const GraphCamera>(built(moment.scene, size));
      size_ = size;
    }
    LiveCamera live{*made_};
    live.still = made_;
    const std::optional<ImagePoint> here = made_->project(glm::vec3(moment.walker.eye));
    live.notes.push_back({ExploreNote::Kind::kState, here ? note_ : note_ + "; you stand where it does not show"});
    return live;
  }

  double option(size_t index) const override { return options_.*kOptions[index]; }
  void setOption(size_t index, double value) override {
    options_.*kOptions[index] = value;
    made_.reset();
  }

 private:
  static constexpr double ComprehensiveOptions::*kOptions[] = {&ComprehensiveOptions::nearness,
                                                               &ComprehensiveOptions::evenness};

  GraphCamera built(const ExploreScene& scene, const glm::ivec2& size) {
    if (scene.guides().maze) {
      return makeComprehensiveCamera(*scene.guides().maze, options_, size.x, size.y);
    }
    if (scene.walkMap() == nullptr) {
      throw InputError("it is not known where one can walk here", "comprehensive camera", "choose another constructor");
    }
    WalkComprehensiveOptions options;
    options.nearness = options_.nearness;
    options.evenness = options_.evenness;
    ComprehensiveWalk walk = makeComprehensiveWalk(*scene.walkMap(), options, size.x, size.y, &scene.rays());
    const auto seen = std::count_if(walk.cells.begin(), walk.cells.end(),
                                    [](const WalkCellView& cell) { return cell.unseen == WalkUnseen::kNothing; });
    note_ = fmt::format("{} of {} rooms, streets and crossings in one image", seen, walk.cells.size());
    return std::move(walk.camera);
  }

  ComprehensiveOptions options_;
  std::shared_ptr<const GraphCamera> made_;
  glm::ivec2 size_{0};
  std::string note_ = "all of it in one image";
};

}  // namespace

LiveConstructorRow liveComprehensive() {
  const ComprehensiveOptions usual;
  return {"comprehensive",
          "all rooms and streets, or a whole maze, in one image, each place once",
          "",
          {{"nearness", "Near is larger", "", 0.1, 10, usual.nearness, "more shows what is near larger", 0, {}, false},
           {"evenness",
            "By what comes after",
            "",
            0,
            1,
            usual.evenness,
            "0 gives ways equal shares of the image, 1 shares by the cells that they lead to",
            0,
            {},
            false}},
          false,
          [](const ExploreScene&) { return std::make_unique<LiveComprehensive>(); },
          [](const ExploreScene& scene) { return !scene.guides().maze; }};
}

}  // namespace ocelli
