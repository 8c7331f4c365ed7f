// Drawings onto Cairo's surfaces. For .cpp files of this room.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "oc_core/drawing/drawing.h"

struct _cairo;
struct _cairo_surface;

namespace ocelli {

struct DestroyCairo {
  void operator()(_cairo* context) const;
  void operator()(_cairo_surface* surface) const;
};
using CairoContext = std::unique_ptr<_cairo, DestroyCairo>;
using CairoSurface = std::unique_ptr<_cairo_surface, DestroyCairo>;

/// In points.
void paintDrawing(_cairo* context, const Drawing& drawing);

/// On white, `scale` pixels a point. DrawingError where Cairo fails.
CairoSurface paintedSurface(const Drawing& drawing, double width, double height, double scale);
/// Of an image surface.
Pixels pixelsOf(_cairo_surface* surface);

/// What a surface writes, as bytes: `makeSurface` gets the arguments of a stream, `work` paints. DrawingError where
/// Cairo fails.
std::string bytesOfSurface(const std::function<_cairo_surface*(void* closure)>& makeSurface,
                           const std::function<void(_cairo_surface*, _cairo*)>& work);
/// Appends to the std::string that `closure` is.
void appendBytes(void* closure, const unsigned char* data, unsigned int length);

/// DrawingError for a status that is no success.
void checkCairo(int status);

}  // namespace ocelli
