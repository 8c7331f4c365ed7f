#include "oc_core/gl/gl_fragments.h"

#include <array>

#include "oc_core/gl/gl_api.h"

namespace ocelli {

static_assert(sizeof(Fragment) == 16 && offsetof(Fragment, t) == 0 && offsetof(Fragment, triangle) == 4 &&
                  offsetof(Fragment, b1) == 8 && offsetof(Fragment, b2) == 12,
              "a fragment is a texel");

GlFragments::GlFragments(GlContext& context, int width, int height)
    : context_(&context), width_(width), height_(height), texture_(makeTexture(context, GL_RGBA32UI, width, height)) {}

GlFragments::GlFragments(GlContext& context, const FragmentImage& fragments)
    : GlFragments(context, fragments.width(), fragments.height()) {
  context.gl().TextureSubImage2D(texture_.id(), 0, 0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                                 fragments.data());
}

void GlFragments::clear() {
  const Fragment empty;
  context_->gl().ClearTexImage(texture_.id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &empty);
}

FragmentImage GlFragments::read() const {
  return readTexture<Fragment>(*context_, texture_, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
}

}  // namespace ocelli
