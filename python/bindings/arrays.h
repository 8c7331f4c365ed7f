// NumPy arrays and the memory of C++ objects. What goes out is a read-only view of that memory, which keeps the object
// alive: nothing is copied. What comes in is converted to the type that is wanted, and copied once into a vector.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <cstring>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// What a pixel or a vertex consists of: `kCount` numbers of type `Number`, 1 for a number itself.
template <class T>
struct Components {
  using Number = T;
  static constexpr pybind11::ssize_t kCount = 1;
};
template <glm::length_t L, class T, glm::qualifier Q>
struct Components<glm::vec<L, T, Q>> {
  using Number = T;
  static constexpr pybind11::ssize_t kCount = L;
};

/// A read-only view of `data`, which `owner` keeps alive, of this shape; a last axis of components where there are
/// several.
template <class T>
pybind11::array viewOf(const T* data, std::vector<pybind11::ssize_t> shape, const pybind11::handle& owner) {
  using Number = typename Components<T>::Number;
  static_assert(sizeof(T) == sizeof(Number) * Components<T>::kCount, "components lie side by side");
  if constexpr (Components<T>::kCount > 1) {
    shape.push_back(Components<T>::kCount);
  }
  pybind11::array_t<Number> view(shape, reinterpret_cast<const Number*>(data), owner);
  view.attr("setflags")(pybind11::arg("write") = false);
  return view;
}

/// (height, width) or (height, width, components); row 0 at the top.
template <class Pixel>
pybind11::array viewOf(const Image<Pixel>& image, const pybind11::handle& owner) {
  return viewOf(image.data(), {image.height(), image.width()}, owner);
}

/// (count) or (count, components).
template <class T>
pybind11::array viewOf(const std::vector<T>& values, const pybind11::handle& owner) {
  return viewOf(values.data(), {static_cast<pybind11::ssize_t>(values.size())}, owner);
}

template <class Number>
using DenseArray = pybind11::array_t<Number, pybind11::array::c_style | pybind11::array::forcecast>;

/// Rows of an array of shape (count, components). Throws InputError naming `where` for any other shape.
template <class T>
std::vector<T> rowsOf(const DenseArray<typename Components<T>::Number>& array, const std::string& where) {
  constexpr pybind11::ssize_t kCount = Components<T>::kCount;
  if (array.ndim() != 2 || array.shape(1) != kCount) {
    throw InputError("an array of shape (count, " + std::to_string(kCount) + ") is needed", where,
                     "reshape it: one row for each");
  }
  std::vector<T> rows(static_cast<size_t>(array.shape(0)));
  if (!rows.empty()) {
    std::memcpy(static_cast<void*>(rows.data()), array.data(), rows.size() * sizeof(T));
  }
  return rows;
}

}  // namespace ocelli
