// A result, or why the data cannot give one: no number is made up.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace ocelli {

template <class Result>
class Estimable {
 public:
  Estimable(Result result) : value_(std::move(result)) {}  // NOLINT: a result is one that can be estimated
  static Estimable impossible(std::string reason) { return Estimable(Reason{std::move(reason)}); }

  bool isPossible() const { return std::holds_alternative<Result>(value_); }
  explicit operator bool() const { return isPossible(); }
  /// Where it is possible.
  const Result& operator*() const { return std::get<Result>(value_); }
  const Result* operator->() const { return &std::get<Result>(value_); }
  /// Where it is not: a whole clause, such as "only one subject has trials of both views".
  const std::string& reason() const { return std::get<Reason>(value_).text; }

 private:
  struct Reason {
    std::string text;
  };
  explicit Estimable(Reason reason) : value_(std::move(reason)) {}

  std::variant<Result, Reason> value_;
};

}  // namespace ocelli
