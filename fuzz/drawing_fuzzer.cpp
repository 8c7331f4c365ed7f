// libFuzzer target: the first line as a camera file that is drawn on, and what the editor knows of it as a drawing;
// each of the others as a drawing script, which is read alone, or else its bytes as what a hand does in the plans.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/editor_script.h"

namespace {

const ocelli::Mesh& someMesh() {
  static const ocelli::Mesh mesh = [] {
    ocelli::Mesh made;
    made.positions = {{-2, -1, 2}, {2, -1, 2}, {2, -1, -2}, {-2, -1, -2}, {-2, 1, -2}, {2, 1, -2}};
    made.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 5}, {3, 5, 4}};
    return made;
  }();
  return mesh;
}

/// The editor holds a camera whose file reads.
void check(const ocelli::FrustumEditor& editor) {
  ocelli::CameraEditor::cameraOf(editor.text(), "drawn", ocelli::PinholeCamera({}, 16, 10), {});
  for (const ocelli::PlanSide side : {ocelli::PlanSide::kTop, ocelli::PlanSide::kFront, ocelli::PlanSide::kRight}) {
    const ocelli::PlanWindow window = ocelli::PlanWindow::around(side, boundsOf(someMesh()), {160, 100});
    planDrawing(editor, window, nullptr);
    editor.numbers(side);
  }
}

/// Two bytes a point of a plan, one what is done there.
void draw(ocelli::FrustumEditor& editor, const std::string& bytes) {
  const std::vector<ocelli::EditorTool>& tools = ocelli::editorTools();
  for (size_t i = 0; i + 2 < bytes.size(); i += 3) {
    const auto byte = [&](size_t k) { return static_cast<unsigned char>(bytes[i + k]); };
    ocelli::PlanPointer pointer;
    pointer.side = static_cast<ocelli::PlanSide>(byte(0) % 3);
    pointer.paper = glm::dvec2(byte(1) - 128.0, byte(2) - 128.0) / 40.0;
    pointer.reach = 0.1;
    pointer.snaps = byte(0) % 2 == 0;
    switch (byte(0) / 3 % 6) {
      case 0:
        editor.chooseTool(tools[byte(1) % tools.size()].name);
        break;
      case 1:
        editor.press(pointer);
        break;
      case 2:
        editor.dragTo(pointer);
        break;
      case 3:
        editor.release();
        break;
      case 4:
        editor.selectNextHandle(pointer.side, byte(1) % 7 - 3);
        editor.nudge(pointer.side, pointer.paper);
        break;
      default:
        byte(1) % 2 == 0 ? editor.undo() : editor.redo();
    }
    check(editor);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream lines(std::string(data, data + size));
  std::string line;
  std::getline(lines, line);
  try {
    ocelli::FrustumEditor editor(line, "fuzz", ocelli::PinholeCamera({}, 16, 10), someMesh(), {});
    check(editor);
    while (std::getline(lines, line)) {
      try {
        ocelli::editorScriptFromJsonText(line, "fuzz");
      } catch (const ocelli::InputError&) {
        draw(editor, line);
      }
    }
  } catch (const ocelli::InputError&) {
    // The camera itself is wrong. Any other exception is a finding.
  }
  return 0;
}
