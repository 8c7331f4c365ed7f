// Interactive construction (section 4.3.2.1): a graph or curved ray camera that edits change one at a time. A
// window or a script shows the camera's image; it sends edits and draws again after each.
//
// The camera is a JSON document as `--camera` takes it (graph_operations.h, curved_bends.h). An edit is a JSON object:
//   {"edit": "add", "operation": {...}}            of a graph camera; {"turn": {...}} of a curved ray camera
//   {"edit": "remove", "name": "left"}             a frustum with all that comes from it, or a turn
//   {"edit": "change", "name": "left", "to": {"viewpoint": [0, 1, 5]}}   fields of a frustum or of a turn
//   {"edit": "rename", "name": "left", "to": "west"}
//   {"edit": "view", "view": {...}}
//   {"edit": "limits", "name": "left", "planes": [{...}]}   all limits of a frustum, instead of those that it has
//   {"edit": "overlap", "overlap": "allowed"}      of a graph camera; or "refused"
//   {"edit": "several", "edits": [{...}, {...}]}   as one step of undo and redo: what each leads to need be no camera
//   {"edit": "undo"}, {"edit": "redo"}
#pragma once

#include <string>
#include <vector>

#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class CameraEditor {
 public:
  /// Starts from the text of a camera file; `where` names it in messages. `reference` is its view where it has none,
  /// and its size; frusta must not overlap within `world` (graph_operations.h). Throws InputError where it is wrong.
  CameraEditor(const std::string& text, const std::string& where, const PinholeCamera& reference, const Box& world);

  /// Throws InputError where the edit is wrong, or what it leads to is no camera; the camera is as before then.
  void apply(const std::string& edit, const std::string& where);
  /// The camera file that the edit leads to, which may be none of a camera; nothing changes. Neither undo nor redo.
  /// Throws InputError where the edit is wrong.
  std::string edited(const std::string& edit, const std::string& where) const;
  /// The camera of such a file. Where `world` is empty, overlaps are not looked for. Throws InputError as above.
  static MultiperspectiveCamera cameraOf(const std::string& text, const std::string& where,
                                         const PinholeCamera& reference, const Box& world);

  const MultiperspectiveCamera& camera() const { return camera_; }
  const PinholeCamera& reference() const { return reference_; }
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < texts_.size(); }
  /// The camera file.
  const std::string& text() const { return texts_[at_]; }

 private:
  void applyEdit(const std::string& text, const std::string& where);

  PinholeCamera reference_;
  Box world_;
  std::vector<std::string> texts_;  // what undo and redo go through
  size_t at_ = 0;
  MultiperspectiveCamera camera_;
};

/// What edits of a camera start from: the text of the file, where that is such a document, and else the text of the
/// camera that the constructor made. Throws InputError where the file cannot be read.
std::string editableText(const std::string& nameOrFile, const MultiperspectiveCamera& constructed);

}  // namespace ocelli
