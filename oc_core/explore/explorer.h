// The explorer (section 4.3.1) without a window: someone walks in a scene, and a constructor makes a camera of each
// moment. A window, or a script, gives it what the person does and draws its frames.
//
//   Explorer explorer(scene, {1280, 720});
//   explorer.choose("portal");
//   while (...) { explorer.advance(input, 1.0 / 30); renderer.draw(explorer.frame()); }
//
// Time is what it is told, so the same calls give the same frames.
//
// No change makes the image jump. A constructor, a pick or an option that does not change it steadily waits until the
// camera before has collapsed to the pinhole; then the new one deploys. Cameras that cannot collapse dissolve.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/explore/explore_frame.h"
#include "oc_core/explore/explore_scene.h"
#include "oc_core/explore/explore_walker.h"
#include "oc_core/explore/live_constructor.h"

namespace ocelli {

struct ExplorerOptions {
  int width = 1280;
  int height = 720;
  WalkerOptions walker{};
  double deploySeconds = 1.5;    ///< from collapsed to deployed; see LiveConstructorRow::deployShare
  double dissolveSeconds = 1.0;  ///< of what cannot collapse
  double glideSeconds = 1.5;     ///< to a place that a constructor wants
  /// choose() waits for the search for ways, where a constructor needs them; otherwise it goes on meanwhile.
  bool waitForWays = false;
};

class Explorer {
 public:
  /// The scene must outlive it. Throws InputError where the size is not positive.
  explicit Explorer(ExploreScene& scene, const ExplorerOptions& options = {});
  ~Explorer();

  /// Lets time pass and makes the next frame.
  void advance(const WalkInput& input, double seconds);
  const ExploreFrame& frame() const { return frame_; }

  ExploreScene& scene() { return scene_; }
  const ExploreScene& scene() const { return scene_; }
  const ExploreWalker& walker() const { return walker_; }
  /// Through walls, or on floors.
  void setFlying(bool flies) { walker_.options().fly = flies; }
  /// How fast the head turns at most now, degrees a second: somewhat slower than WalkerOptions::turnDegrees where the
  /// image would otherwise change more than the pinhole's. What turns by pointer turns as that says.
  double turnDegrees() const;
  /// Glides to a view: the walker is led there, through walls if need be. A constructor that leads the walker, such as
  /// `path`, leads on from there.
  void glideTo(const WalkerView& view);
  /// The same at once.
  void jumpTo(const WalkerView& view);
  void resize(int width, int height);

  /// By name; throws InputError for an unknown one. The one that is chosen, though the one before may still collapse.
  void choose(std::string_view constructor);
  /// One that is in no table. The row must outlive this.
  void choose(const LiveConstructorRow& row);
  const LiveConstructorRow& chosen() const;
  /// Of chosen(). Throws InputError, naming the option and its range.
  double option(std::string_view name) const;
  void setOption(std::string_view name, double value);
  /// A camera that is shown as it is, from a file or drawn by hand, chosen as liveConstructorForOthers(). `name` is for
  /// people.
  void showDrawn(const MultiperspectiveCamera& camera, const std::string& name);

  /// What the ray of a pixel of the picture meets; nothing outside of it.
  std::optional<ExplorePick> probe(const glm::dvec2& pixel) const;
  /// Gives that to the chosen constructor; returns false where it met nothing.
  bool pick(const glm::dvec2& pixel);
  bool pick(const ExplorePick& pick);
  /// What is picked, as a box.
  std::optional<Box> picked() const;

  /// Whether nothing changes any more but by input: nothing glides, deploys, collapses or dissolves.
  bool atRest() const;

 private:
  struct State;

  PinholeCamera viewFor(double shown) const;
  LiveMoment momentFor(const PinholeCamera& view, double seconds, double shown) const;
  LiveCamera makeCamera(double seconds);
  void applyWaiting();
  void move(const WalkInput& input, double seconds);
  void deploy(double seconds);
  void followOptions(double seconds);
  void makeFrame(double seconds);
  void startDissolve();
  void addStateNotes(std::vector<ExploreNote> notes);
  bool waysMissing() const;

  ExploreScene& scene_;
  ExplorerOptions options_;
  ExploreWalker walker_;
  std::unique_ptr<State> state_;
  ExploreFrame frame_;
};

}  // namespace ocelli
