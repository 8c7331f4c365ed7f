// How much work goes into making slices small: no more than the link needs. Run lengths are cheap; zstd is for links
// that the stream fills.
#pragma once

#include "display_driver/wire/slice_coding.h"

namespace ocelli {

class EffortChoice {
 public:
  wire::Effort effort() const { return small_ ? wire::Effort::kSmall : wire::Effort::kFast; }

  /// A frame has left. `full`: the link needed longer for it than its coding.
  void frameSent(bool full);

 private:
  bool small_ = false;
  int frames_ = 0;    ///< since the last change; while small, those since the link was full
  int patience_ = 0;  ///< so many of them before run lengths are tried again
};

}  // namespace ocelli
