// A table of rows that grows: the built-in rows first, then those that a program registers at run time, from outside of
// the tree. Rows are never removed and never move: a reference to one is good until the program ends.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {

/// The rows that stood in a registry when it was asked, in their order: `for (const Row& row : rows)`.
template <class Row>
using Rows = std::vector<std::reference_wrapper<const Row>>;

/// Each row has a `name` that no other row has. Any thread may call any function at any time.
template <class Row>
class Registry {
 public:
  /// Whether a row answers to a name.
  using AnswersTo = std::function<bool(const Row& row, std::string_view name)>;

  /// `what` is a row in messages: "device". Rows that answer to more than their own name say so by `answersTo`, which
  /// must not ask the registry.
  Registry(std::string what, std::vector<Row> builtIn, AnswersTo answersTo = answersToOwnName)
      : what_(std::move(what)), answersTo_(std::move(answersTo)) {
    for (Row& row : builtIn) {
      add(std::move(row));
    }
  }

  Rows<Row> rows() const {
    const std::lock_guard lock(mutex_);
    return {rows_.begin(), rows_.end()};
  }

  /// Throws InputError where a row answers to the name of the new one, or the new one to that of a row.
  void add(Row row) {
    const std::lock_guard lock(mutex_);
    for (const Row& other : rows_) {
      if (answersTo_(other, row.name) || answersTo_(row, other.name)) {
        throw InputError("there is a " + what_ + " of this name already", std::string(row.name),
                         "register it once, under a name of its own");
      }
    }
    rows_.push_back(std::move(row));
  }

 private:
  static bool answersToOwnName(const Row& row, std::string_view name) { return row.name == name; }

  const std::string what_;
  const AnswersTo answersTo_;
  mutable std::mutex mutex_;
  std::deque<Row> rows_;  // adding at the end moves none
};

}  // namespace ocelli
