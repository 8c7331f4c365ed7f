// What is thrown where OpenGL cannot do the work: no context, a driver that is too old, a full or a lost GPU.
#pragma once

#include "oc_core/base/error.h"

namespace ocelli {

/// `next` always holds a way that works without a GPU.
class GlError : public WorkError {
 public:
  using WorkError::WorkError;
};

}  // namespace ocelli
