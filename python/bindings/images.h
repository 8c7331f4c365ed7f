// Reference images as one Python class, not as a list: they belong together, and a list would copy them.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

#include "oc_core/ocri/reference_image.h"
#include "python/bindings/arrays.h"

PYBIND11_MAKE_OPAQUE(ocelli::ReferenceImages)

namespace ocelli {

/// An image that nothing in C++ keeps: the array owns it. (height, width, ...), nothing is copied.
template <class Pixel>
pybind11::array arrayOf(Image<Pixel>&& image) {
  auto kept = std::make_unique<Image<Pixel>>(std::move(image));
  const pybind11::capsule owner(kept.get(), [](void* each) { delete static_cast<Image<Pixel>*>(each); });
  const Image<Pixel>& pixels = *kept.release();
  return viewOf(pixels, owner);
}

/// Throws InputError for sizes that images may not have.
void requireImageSize(int width, int height);

}  // namespace ocelli
