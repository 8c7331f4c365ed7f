// The ways of reflections and refractions: what stands for the scene, and how it is met, as `--by` says it. A way is a
// name, such as that of a camera, and any of the words of a table behind colons: "di:stepped", "cell:searched-exit".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/shade/glass_back_faces.h"

namespace ocelli {

struct SpecularWayName {
  std::string full;       ///< as it was given
  std::string target;     ///< what stands for the scene: the name without the words
  double finePixels = 0;  ///< of the text's steps along projections; 0 for the pyramid
  /// How an image of the back faces of glass says where rays leave it; nothing where they are traced through it.
  std::optional<BackFaceExit> exit = {};

  bool byFrusta = false;  ///< of a graph camera: rays walk frustum by frustum through its image

  bool isStepped() const { return finePixels > 0; }
};

/// A word that changes a way.
struct WayWord {
  const char* word;
  const char* kind;  ///< what it says, of which a way says each once
  const char* meaning;
  void (*apply)(SpecularWayName& way);
};

/// In the order of lists.
const std::vector<WayWord>& wayWords();

/// A colon before anything else belongs to the name, as in a path. Throws InputError where words contradict each other
/// or the name: only images have steps.
SpecularWayName specularWay(const std::string& text);

/// The words with their meanings, for help.
std::string wayWordsHelp();

}  // namespace ocelli
