// A transfer function while it is edited: what it is, what it was before, and whether it has been saved. Whatever is
// asked for, it stays valid (oc_core/volume/transfer_function.h): there is a point at the least, and their values do
// not fall.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

class TransferEditor {
 public:
  /// How many steps undo() goes back.
  static constexpr size_t kMaxSteps = 256;

  /// What it begins with counts as saved.
  explicit TransferEditor(VolumeAppearance appearance);

  /// Another pointer where it is another appearance, and the same one where undo() or redo() has come back to it.
  const std::shared_ptr<const VolumeAppearance>& appearance() const { return current_; }
  const std::vector<TransferPoint>& points() const { return current_->transfer.points(); }
  /// The point that keys and the panel edit.
  std::optional<size_t> chosen() const { return chosen_; }
  void choose(std::optional<size_t> point);

  // Each edit can be undone. Those of the same kind and point that follow each other are one step, until endStep(): so
  // a drag is undone as a whole.

  /// The value stays between those of the neighbours, the opacity between 0 and 1.
  void movePoint(size_t point, double value, double opacity);
  /// Linear RGB, 0 to 1.
  void colorPoint(size_t point, const glm::dvec3& color);
  /// In the colour that the function has there. It is the chosen one then. False where there are as many as a file may
  /// have (oc_core/volume/transfer_file.h).
  bool addPoint(double value, double opacity);
  /// On the curve, halfway to the next point, or to the one before where it is the last.
  bool addBeside(size_t point);
  /// False where it is the only one. The chosen one is then its neighbour.
  bool removePoint(size_t point);
  /// In units of the volume's world.
  void setOpacityLength(double length);
  void setShading(const VolumeShading& shading);
  /// Another one altogether, such as a preset, or that of a file, where it counts as saved.
  void replace(VolumeAppearance appearance, bool isSaved);
  void endStep() { last_.reset(); }

  /// False where there is nothing to go back, or on, to.
  bool undo();
  bool redo();
  bool canUndo() const { return !past_.empty(); }
  bool canRedo() const { return !future_.empty(); }

  bool isSaved() const { return saved_ == current_; }
  void markSaved() { saved_ = current_; }
  /// Whether to say, before it is lost, that it is not saved: once for each appearance that is asked for.
  bool warnsOfLoss();

 private:
  using Appearance = std::shared_ptr<const VolumeAppearance>;
  enum class Kind { kMove, kColor, kLength, kShading };
  struct Step {
    Kind kind;
    size_t point = 0;
    bool operator==(const Step&) const = default;
  };

  /// Nothing: a step by itself.
  void put(VolumeAppearance appearance, std::optional<Step> step);
  bool insertPoint(size_t index, const TransferPoint& point);
  void putPoints(std::vector<TransferPoint> points, std::optional<Step> step);
  bool go(std::vector<Appearance>& from, std::vector<Appearance>& to);
  void keepChosen();

  Appearance current_;
  Appearance saved_;
  Appearance warnedOf_;             ///< the last that warnsOfLoss() has told of
  std::vector<Appearance> past_;    ///< the last is the latest
  std::vector<Appearance> future_;  ///< the last is the next
  std::optional<Step> last_;
  std::optional<size_t> chosen_;
};

}  // namespace ocelli
