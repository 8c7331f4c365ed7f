// What is thrown where an analysis cannot be done at all: an invalid file, a plan that contradicts itself. What
// merely cannot be estimated from the data at hand (one subject, nothing but time-outs) is no error but part of the
// result: estimable.h.
#pragma once

#include <stdexcept>
#include <string>

namespace ocelli {

class AnalysisError : public std::runtime_error {
 public:
  /// The input is wrong, or the work itself failed (a full disk).
  enum class Kind { kInput, kWork };

  /// `where` is a file, a file with a row or a field; `next` tells the user what to try. Control characters of `what`
  /// and `where` become "?", and what is long is cut.
  AnalysisError(Kind kind, const std::string& what, const std::string& where, const std::string& next);

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace ocelli
