// The X server that a test runs on: real input for its windows, and what its screen shows. Xlib and XTest are opened at
// run time, so that building the tests needs neither.
#pragma once

#include <array>
#include <cstdint>

#include "oc_core/gl/shared_library.h"

namespace ocelli::test {

class XServer {
 public:
  /// Throws GlError where one of the libraries, or the server, is missing.
  XServer();
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// In pixels of the screen.
  void movePointer(int x, int y);
  /// 1 is left, 2 the middle, 3 right; 4 to 7 are steps of the wheel: up, down, left, right.
  void pressButton(unsigned button, bool pressed);
  /// A keysym: the code of a Latin character, or one of X11/keysymdef.h.
  void pressKey(unsigned long keysym, bool pressed);
  /// Red, green and blue of a pixel of the screen.
  std::array<uint8_t, 3> screenPixel(int x, int y);

 private:
  SharedLibrary x11_{"libX11.so.6", "libx11-6"};
  SharedLibrary xtst_{"libXtst.so.6", "libxtst6"};
  void* display_;
};

}  // namespace ocelli::test
