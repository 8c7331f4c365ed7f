// The image of a camera that is being drawn, for immediate feedback (section 4.3.2.1): a small one first, a quarter of
// the size each way, then the whole one. Who draws asks for the next image whenever there is time.
#pragma once

#include <optional>

#include "oc_core/frustum_editor/frustum_editor.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct PreviewImage {
  Image<Rgb8> image;
  bool isWhole = false;  ///< else a small one, to be shown as large as the whole one
  int revision = 0;      ///< of the editor's camera
};

class EditorPreview {
 public:
  static constexpr int kSmaller = 4;

  /// Both must live as long as it does.
  EditorPreview(const FrustumEditor& editor, const Mesh& mesh) : editor_(&editor), mesh_(&mesh) {}

  /// Nothing where the whole image of the camera has been given already.
  std::optional<PreviewImage> next();

 private:
  const FrustumEditor* editor_;
  const Mesh* mesh_;
  int smallRevision_ = -1;
  int wholeRevision_ = -1;
};

}  // namespace ocelli
