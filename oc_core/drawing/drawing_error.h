// What is thrown where a drawing cannot be painted: it is too large, or memory is exhausted.
#pragma once

#include <stdexcept>
#include <string>

namespace ocelli {

class DrawingError : public std::runtime_error {
 public:
  explicit DrawingError(const std::string& what);
};

}  // namespace ocelli
