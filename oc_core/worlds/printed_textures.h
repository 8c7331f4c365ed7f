// What people paint, print and write on the things of a place: paintings, spines of books, posters, papers, screens.
// Each of a seed is another one; coordinates as in surface_textures.h.
#pragma once

#include "oc_core/worlds/surface_textures.h"

namespace ocelli {

/// How much ink there is, in [0, 1], of lines of marks as wide as letters of a height, in words of other lengths.
float inkOfText(const glm::vec2& metres, float letterHeight, uint32_t seed);

/// An oil painting: a landscape, a portrait, a still life, or shapes.
SurfaceTexture paintingTexture(const glm::vec2& size, uint32_t seed);
/// The spine of a book: cloth or leather, bands, and a title along it.
SurfaceTexture spineTexture(const glm::vec2& size, uint32_t seed);
/// The spine of a folder for papers: a label with writing, and a hole.
SurfaceTexture folderTexture(const glm::vec2& size, uint32_t seed);
/// A heading, a picture, and text.
SurfaceTexture posterTexture(const glm::vec2& size, uint32_t seed);
/// White paper with lines of text, and perhaps a diagram.
SurfaceTexture paperTexture(const glm::vec2& size, uint32_t seed);
/// Windows with text, code and a picture on a screen.
SurfaceTexture screenTexture(const glm::vec2& size, uint32_t seed);
/// A whiteboard with drawings and writing in a few colours.
SurfaceTexture whiteboardTexture(const glm::vec2& size, uint32_t seed);
/// Rows of keys.
SurfaceTexture keyboardTexture(const glm::vec2& size, uint32_t seed);
/// What a window shows: sky, roofs, trees.
SurfaceTexture outdoorsTexture(const glm::vec2& size, uint32_t seed);

/// A colour of a bound book, or of a thing of its kind.
glm::vec3 bindingColor(uint32_t seed);

}  // namespace ocelli
