// What is thrown where OpenGL cannot do the work: no context, a driver that is too old, a full or a lost GPU.
#pragma once

#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

class GlError : public WorkError {
 public:
  /// That nobody needs a GPU is added to `next`.
  GlError(const std::string& what, const std::string& where, const std::string& next, const std::string& details = "")
      : WorkError(what, where, next + "; everything but windows also works without OpenGL, on the CPU", details),
        reason_(where + ": " + what) {}

  /// Where and what, for an error that tells of several.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

}  // namespace ocelli
