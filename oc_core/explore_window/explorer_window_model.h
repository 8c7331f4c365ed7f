// The explorer (oc_core/explore/) as what the window needs of it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "oc_core/explore/explorer.h"
#include "oc_core/explore_window/explore_window_work.h"

namespace ocelli {

struct ExplorerWindowOptions {
  /// Reads the scene. Throws InputError.
  std::function<std::shared_ptr<ExploreScene>(const Progress& progress)> read;
  ExplorerOptions explorer{};         ///< but for the size, which the window says
  std::optional<WalkerView> start{};  ///< nothing: an open place
  std::string camera{};               ///< a live constructor or a camera's file to begin with; empty: the pinhole
};

class ExplorerWindowModel : public ExploreWindowModel {
 public:
  /// Throws InputError where the scene is empty, or there is no such constructor.
  ExplorerWindowModel(const ExplorerWindowOptions& options, const Progress& progress);
  ~ExplorerWindowModel() override;

  Explorer& explorer();

  void advance(double seconds, const WindowMotion& motion) override;
  WindowPicture draw(const WindowShape& shape) override;
  void choose(size_t choice) override;
  void setField(const std::string& name, double value) override;
  void changeField(const std::string& name, double steps) override;
  std::string pick(const glm::dvec2& viewPixel) override;
  std::string pickNext(int step) override;
  void showDrawn(const MultiperspectiveCamera& camera, const std::string& name) override;
  void openCamera(const std::string& nameOrFile) override;
  void toggleFlying() override;
  void goToStart() override;
  void goTo(const glm::vec2& planPoint) override;
  std::string cameraFile() const override;
  std::string cameraFileLacks() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// For ExploreWindowOptions.
ExploreWindowWork::Make makeExplorerModel(ExplorerWindowOptions options);

/// A motion as the explorer takes it.
WalkInput walkInputOf(const WindowMotion& motion);
WindowMotion windowMotionOf(const WalkInput& input);

}  // namespace ocelli
