#include "tests/window/x_server.h"

#include "oc_core/gl/gl_error.h"

namespace ocelli::test {
namespace {

// Of Xlib and XTest; a Display and an XImage are only passed on.
using OpenDisplay = void*(const char*);
using OfDisplay = int(void*);
using RootWindow = unsigned long(void*);
using KeysymToKeycode = unsigned char(void*, unsigned long);
using GetImage = void*(void*, unsigned long, int, int, unsigned, unsigned, unsigned long, int);
using GetPixel = unsigned long(void*, int, int);
using DestroyImage = int(void*);
using FakeMotion = int(void*, int, int, int, unsigned long);
using FakePress = int(void*, unsigned, int, unsigned long);

constexpr int kZPixmap = 2;
constexpr unsigned long kAllPlanes = ~0UL;

}  // namespace

XServer::XServer() : display_(x11_.get<OpenDisplay>("XOpenDisplay")(nullptr)) {
  if (display_ == nullptr) {
    throw GlError("it cannot be reached", "the X server", "set DISPLAY");
  }
}

XServer::~XServer() {
  x11_.get<OfDisplay>("XCloseDisplay")(display_);
}

void XServer::movePointer(int x, int y) {
  xtst_.get<FakeMotion>("XTestFakeMotionEvent")(display_, -1, x, y, 0);
  x11_.get<OfDisplay>("XFlush")(display_);
}

void XServer::pressButton(unsigned button, bool pressed) {
  xtst_.get<FakePress>("XTestFakeButtonEvent")(display_, button, pressed ? 1 : 0, 0);
  x11_.get<OfDisplay>("XFlush")(display_);
}

void XServer::pressKey(unsigned long keysym, bool pressed) {
  const unsigned code = x11_.get<KeysymToKeycode>("XKeysymToKeycode")(display_, keysym);
  xtst_.get<FakePress>("XTestFakeKeyEvent")(display_, code, pressed ? 1 : 0, 0);
  x11_.get<OfDisplay>("XFlush")(display_);
}

std::array<uint8_t, 3> XServer::screenPixel(int x, int y) {
  const unsigned long root = x11_.get<RootWindow>("XDefaultRootWindow")(display_);
  void* image = x11_.get<GetImage>("XGetImage")(display_, root, x, y, 1, 1, kAllPlanes, kZPixmap);
  const unsigned long pixel = x11_.get<GetPixel>("XGetPixel")(image, 0, 0);
  x11_.get<DestroyImage>("XDestroyImage")(image);
  return {static_cast<uint8_t>(pixel >> 16U), static_cast<uint8_t>(pixel >> 8U), static_cast<uint8_t>(pixel)};
}

}  // namespace ocelli::test
