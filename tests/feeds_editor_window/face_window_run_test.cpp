// The window of `ocelli feeds edit` on a (virtual) screen.
#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/feeds_editor_window/face_window.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

TEST(FaceWindowRun, showsUntilItIsClosed) {
  if (std::getenv("DISPLAY") == nullptr) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  FaceEditor editor(test::tSetup());
  FaceWindowOptions options;
  options.frames.resize(3);  // none of them gives a frame
  int turns = 0;
  runFaceWindow(editor, options, [&] { return ++turns < 10; });
  EXPECT_EQ(turns, 10);
  EXPECT_EQ(editor.setup(), test::tSetup());
}

}  // namespace
}  // namespace ocelli
