#include "study/responses/debouncer.h"

namespace ocelli {

void Debouncer::settle(State& state, int64_t nanoseconds, std::vector<KeyChange>& passes) const {
  if (state.held && nanoseconds >= state.settles) {
    passes.push_back(*state.held);
    state.passed = state.held->pressed;
    state.settles = state.held->nanoseconds + window_;
    state.held.reset();
  }
}

std::vector<KeyChange> Debouncer::take(const KeyChange& change) {
  if (window_ <= 0) {
    return {change};
  }
  std::vector<KeyChange> passes;
  const auto [found, isNew] = keys_.try_emplace(change.key);
  State& state = found->second;
  if (isNew) {
    state.settles = change.nanoseconds;
  }
  settle(state, change.nanoseconds, passes);
  if (change.nanoseconds >= state.settles) {
    if (change.pressed != state.passed) {
      state.settles = change.nanoseconds + window_;
    }
    state.passed = change.pressed;
    state.now = change.pressed;
    passes.push_back(change);
  } else if (change.pressed != state.now) {
    state.now = change.pressed;
    if (state.now == state.passed) {
      state.held.reset();
      ++bounces_;
    } else {
      state.held = change;
    }
  }
  return passes;
}

std::vector<KeyChange> Debouncer::update(int64_t nanoseconds) {
  std::vector<KeyChange> passes;
  for (auto& [key, state] : keys_) {
    settle(state, nanoseconds, passes);
  }
  return passes;
}

}  // namespace ocelli
