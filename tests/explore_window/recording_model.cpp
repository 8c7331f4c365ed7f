#include "tests/explore_window/recording_model.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli::test {
namespace {

/// Sky over floor, so that images of views look like images of views.
Image<Rgb8> horizon(const glm::ivec2& size, uint8_t red) {
  Image<Rgb8> image(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      image(x, y) = y < size.y / 2 ? Rgb8{red, 120, 150} : Rgb8{red, 90, 70};
    }
  }
  return image;
}

class RecordingModel : public ExploreWindowModel {
 public:
  explicit RecordingModel(ModelRecord& record) : record_(record) {}

  void advance(double seconds, const WindowMotion& motion) override {
    record_.seconds += seconds;
    record_.motion = motion;
    record_.turned += motion.turnedDegrees;
    ++record_.frames;
    at_ += motion.ahead * static_cast<float>(seconds);
  }

  WindowPicture draw(const WindowShape& shape) override {
    record_.shape = shape;
    WindowPicture picture;
    picture.view = horizon(shape.view, 60);
    if (shape.pinhole) {
      picture.pinhole = horizon(*shape.pinhole, 20);
    }
    const auto width = static_cast<float>(shape.view.x);
    const auto height = static_cast<float>(shape.view.y);
    if (chosen_ > 0) {
      picture.tints = {{{{0.6f * width, 0.2f * height},
                         {0.85f * width, 0.2f * height},
                         {0.85f * width, 0.8f * height},
                         {0.6f * width, 0.8f * height}},
                        1}};
      picture.plan.frusta = {{{{0, -at_}, {4, -6 - at_}, {-4, -6 - at_}}, {0, -at_}, 0},
                             {{{3, -6}, {9, -4}, {9, -8}}, {2, -6}, 1}};
    }
    picture.plan.walker = {0, -at_};
    picture.plan.openings = std::make_shared<const std::vector<WindowPlan::Opening>>(
        std::vector<WindowPlan::Opening>{{glm::vec2(3, -7), glm::vec2(3, -5)}});
    if (picked_) {
      picture.plan.picked = {{3, -7}, {3, -5}};
    }
    picture.plan.cells = std::make_shared<const std::vector<WindowPlan::Cell>>(std::vector<WindowPlan::Cell>{
        {{{-3, -9}, {3, -9}, {3, 3}, {-3, 3}}, false}, {{{3, -9}, {10, -9}, {10, -3}, {3, -3}}, true}});
    picture.choices = {
        {"pinhole", "Rays do not bend."}, {"portal", "Rays bend into rooms."}, {"path", "Follows a path."}};
    picture.chosen = chosen_;
    if (chosen_ == 1) {
      picture.fields = {{"amount", "Amount", "How far rays bend.", "%", 0, 100, 5, amount_, {}},
                        {"reach", "Reach", "How far away openings count.", "m", 1, 40, 0.5, 12, {}}};
    }
    picture.notes = {{"Two openings are in sight.", WindowNoteKind::kPlain}};
    picture.place = "0, 0 m";
    picture.lengthUnit = "m";
    return picture;
  }

  void choose(size_t choice) override {
    chosen_ = choice;
    call("choose " + std::to_string(choice));
  }
  void setField(const std::string& name, double value) override {
    if (value > 100) {
      throw InputError("is out of range", name, "choose at most 100");
    }
    amount_ = value;
    call("set " + name);
  }
  void changeField(const std::string& name, double steps) override {
    amount_ = std::clamp(amount_ + 5 * steps, 0.0, 100.0);
    call("change " + name + " " + std::to_string(std::lround(steps)));
  }
  std::string pick(const glm::dvec2& viewPixel) override {
    picked_ = true;
    call("pick " + std::to_string(std::lround(viewPixel.x)) + " " + std::to_string(std::lround(viewPixel.y)));
    return "";
  }
  std::string pickNext(int step) override {
    picked_ = true;
    call("pick next " + std::to_string(step));
    return "";
  }
  void showDrawn(const MultiperspectiveCamera&, const std::string& name) override { call("show " + name); }
  void openCamera(const std::string& nameOrFile) override { call("open " + nameOrFile); }
  void toggleFlying() override { call("fly"); }
  void goToStart() override { call("start"); }
  void goTo(const glm::vec2& planPoint) override {
    call("go to " + std::to_string(std::lround(planPoint.x)) + " " + std::to_string(std::lround(planPoint.y)));
  }
  std::string cameraFile() const override { return "{}\n"; }

 private:
  void call(const std::string& text) { record_.calls.push_back(text); }

  ModelRecord& record_;
  size_t chosen_ = 0;
  double amount_ = 50;
  bool picked_ = false;
  float at_ = 0;
};

}  // namespace

std::unique_ptr<ExploreWindowModel> makeRecordingModel(ModelRecord& record) {
  return std::make_unique<RecordingModel>(record);
}

}  // namespace ocelli::test
