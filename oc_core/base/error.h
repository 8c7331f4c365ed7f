// What is thrown for bad input and failed work. Every error says what went wrong, where, and what to do next.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace ocelli {

class Error : public std::runtime_error {
 public:
  /// `where` is a file, a file with a line, or a field; `next` tells the user what to try. `details` are lines that
  /// stand below `what`. What comes out of damaged files and databases may stand in all of them: control characters
  /// become "?", `what` and `where` stay one line, and are cut where they are longer than any message of ours.
  Error(const std::string& what, const std::string& where, const std::string& next, const std::string& details = "");

  /// Of what() one by one, for programs: what went wrong, where ("" where that is said by the first), what to try next.
  struct Parts {
    std::string problem;
    std::string where;
    std::string next;
    std::string details;
  };
  const Parts& parts() const { return *parts_; }

 private:
  explicit Error(Parts parts);

  std::shared_ptr<const Parts> parts_;  ///< shared: copies of exceptions must not throw
};

/// The command line or an input file is wrong: exit code 2. Of an analysis: its data contradict themselves. What merely
/// cannot be estimated from them is no error (analysis/base/estimable.h).
class InputError : public Error {
 public:
  using Error::Error;
};

/// The work itself failed (disk full, unwritable output, device gone): exit code 1.
class WorkError : public Error {
 public:
  using Error::Error;
};

}  // namespace ocelli
