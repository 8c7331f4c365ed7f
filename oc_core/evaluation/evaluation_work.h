// The work file of an evaluation: what is finished of it, so that an interrupted one can go on.
//
// A JSON object: "format" (1), "key", and "representations": [{"camera", "figures"}]. The key names everything that the
// figures depend on but the camera; figures of another key are of no use.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

/// The key of a scene and options: a hash of every vertex and triangle, and of every option. `more` is text that counts
/// too (the version of the program, the display that is sliced for).
std::string evaluationKey(const Mesh& scene, const EvaluationOptions& options, const std::string& more);
/// The same of any scene, by a text that no other scene has.
std::string evaluationKey(const std::string& scene, const EvaluationOptions& options, const std::string& more);
/// A hash of the text, as hexadecimal digits.
std::string textHash(const std::string& text);

class EvaluationWork {
 public:
  EvaluationWork(std::filesystem::path path, std::string key);

  /// Takes over what the file holds. Throws InputError where it is missing, broken, or of another key; this then holds
  /// nothing.
  void load();

  size_t count() const { return finished_.size(); }
  /// The figures of what `camera` stands for, where they are finished.
  std::optional<RepresentationFigures> find(const std::string& camera) const;
  /// Adds figures, in place of those of the same camera, and writes the file, which is whole at any time. Throws
  /// WorkError.
  void add(const std::string& camera, const RepresentationFigures& figures);
  /// The work is done: removes the file.
  void remove();

 private:
  std::filesystem::path path_;
  std::string key_;
  std::vector<std::pair<std::string, RepresentationFigures>> finished_;
};

}  // namespace ocelli
