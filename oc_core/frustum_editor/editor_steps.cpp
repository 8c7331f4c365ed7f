// The steps of scripts that draw cameras.
#include <array>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/frustum_editor/editor_script.h"
#include "oc_core/multiperspective/figure_file.h"
#include "oc_core/multiperspective/multiperspective_image.h"

namespace ocelli {
namespace {

constexpr double kScriptReachShare = 0.005;  // of the scene's diagonal: how near to a handle a step presses it
constexpr double kMaxPlanCoordinate = 1e6;
constexpr int kFigurePixels = 900;  // of the longer side of a plan

/// The plan that a step is in.
PlanSide sideIn(JsonFields& fields) {
  const std::string name = fields.text("plan", "top");
  for (const PlanSide side : {PlanSide::kTop, PlanSide::kFront, PlanSide::kRight}) {
    if (name == nameOf(side)) {
      return side;
    }
  }
  fields.fail("plan", "must be top, front or right");
}

/// What scripts give, such as [x, y], on the paper, where y points down.
glm::dvec2 paperOf(PlanSide side, const std::vector<double>& point) {
  return side == PlanSide::kTop     ? glm::dvec2(point[0], point[1])
         : side == PlanSide::kFront ? glm::dvec2(point[0], -point[1])
                                    : glm::dvec2(-point[0], -point[1]);
}

std::vector<double> pointIn(JsonFields& fields, const std::string& name) {
  return fields.numbers(name, 2, -kMaxPlanCoordinate, kMaxPlanCoordinate);
}

struct PointerFields {
  PlanSide side = PlanSide::kTop;
  double reach = 0;  ///< 0 for a share of the scene
  bool snaps = false;

  PlanPointer at(EditorSession& session, const glm::dvec2& paper) const {
    const Box& room = session.editor().drawn().room;
    return {side, paper, reach > 0 ? reach : kScriptReachShare * static_cast<double>(glm::length(room.size())), snaps};
  }
};

PointerFields pointerIn(JsonFields& fields) {
  PointerFields pointer;
  pointer.side = sideIn(fields);
  pointer.reach = fields.number("reach", 0, kMaxPlanCoordinate, 0);
  pointer.snaps = fields.boolean("snap", false);
  return pointer;
}

void requireDrag(const FrustumEditor& editor) {
  if (!editor.isDragging()) {
    throw InputError("nothing is being dragged", "drawing a camera",
                     "\"press\" a handle first, or choose the \"tool\" of a stroke");
  }
}

EditorStep readTool(JsonFields& fields) {
  const std::string name = fields.text("tool");
  editorTool(name);
  return [name](EditorSession& session) { session.editor().chooseTool(name); };
}

EditorStep readPress(JsonFields& fields) {
  const PointerFields pointer = pointerIn(fields);
  const glm::dvec2 paper = paperOf(pointer.side, pointIn(fields, "press"));
  return [=](EditorSession& session) { session.editor().press(pointer.at(session, paper)); };
}

EditorStep readDrag(JsonFields& fields) {
  const PointerFields pointer = pointerIn(fields);
  const glm::dvec2 paper = paperOf(pointer.side, pointIn(fields, "drag"));
  return [=](EditorSession& session) {
    requireDrag(session.editor());
    session.editor().dragTo(pointer.at(session, paper));
  };
}

EditorStep readRelease(JsonFields& fields) {
  fields.boolean("release", true);
  return [](EditorSession& session) {
    requireDrag(session.editor());
    session.editor().release();
  };
}

EditorStep readCancel(JsonFields& fields) {
  fields.boolean("cancel", true);
  return [](EditorSession& session) { session.editor().cancel(); };
}

EditorStep readStroke(JsonFields& fields) {
  const PointerFields pointer = pointerIn(fields);
  const nlohmann::json& list = fields.value("stroke");
  if (!list.is_array() || list.empty() || list.size() > 1000) {
    fields.fail("stroke", "must be an array of 1 to 1000 points");
  }
  std::vector<glm::dvec2> points;
  for (const nlohmann::json& each : list) {
    const nlohmann::json wrapped{{"point", each}};
    JsonFields point(wrapped, fields.where() + ", \"stroke\"");
    points.push_back(paperOf(pointer.side, pointIn(point, "point")));
  }
  return [=](EditorSession& session) {
    session.editor().press(pointer.at(session, points.front()));
    for (size_t i = 1; i < points.size(); ++i) {
      session.editor().dragTo(pointer.at(session, points[i]));
    }
    session.editor().release();
  };
}

EditorStep readHandle(JsonFields& fields) {
  const std::string kind = fields.text("handle");
  handleKind(kind);
  const std::string of = fields.text("of");
  const int index = fields.integer("index", 0, 1000, 0);
  const PlanSide side = sideIn(fields);
  return [=](EditorSession& session) { session.editor().selectHandle(side, of, kind, index); };
}

/// As a drag of the mouse would: from the selected handle.
EditorStep readMove(JsonFields& fields) {
  const PointerFields pointer = pointerIn(fields);
  const glm::dvec2 paper = paperOf(pointer.side, pointIn(fields, "move"));
  return [=](EditorSession& session) {
    FrustumEditor& editor = session.editor();
    const std::optional<FrustumHandle> handle = editor.selectedHandle(pointer.side);
    if (!handle) {
      throw InputError("no handle of this plan is selected", "drawing a camera", "select one with \"handle\"");
    }
    editor.chooseTool("move");
    editor.press(pointer.at(session, paperFromWorld(pointer.side, handle->at)));
    editor.dragTo(pointer.at(session, paper));
    editor.release();
  };
}

EditorStep readNudge(JsonFields& fields) {
  const PlanSide side = sideIn(fields);
  const glm::dvec2 paper = paperOf(side, pointIn(fields, "nudge"));
  return [=](EditorSession& session) { session.editor().nudge(side, paper); };
}

EditorStep readNumber(JsonFields& fields) {
  const PlanSide side = sideIn(fields);
  const std::string name = fields.text("number");
  const double value = fields.number("is", -1e6, 1e6);
  return [=](EditorSession& session) { session.editor().typeNumber(side, name, value); };
}

EditorStep readSelect(JsonFields& fields) {
  const std::string name = fields.text("select");
  return [name](EditorSession& session) { session.editor().select(name); };
}

EditorStep readNext(JsonFields& fields) {
  const PlanSide side = sideIn(fields);
  const int step = fields.integer("next", -1000, 1000);
  return [=](EditorSession& session) { session.editor().selectNextHandle(side, step); };
}

EditorStep readRename(JsonFields& fields) {
  const std::string name = fields.text("rename");
  return [name](EditorSession& session) { session.editor().renameSelected(name); };
}

EditorStep readRemove(JsonFields& fields) {
  fields.boolean("remove", true);
  return [](EditorSession& session) { session.editor().removeSelected(); };
}

EditorStep readOverlap(JsonFields& fields) {
  const bool allowed = fields.choice("overlap", {"allowed", "refused"}) == "allowed";
  return [allowed](EditorSession& session) { session.editor().allowOverlap(allowed); };
}

EditorStep readUndo(JsonFields& fields) {
  const int count = fields.integer("undo", 1, 1000);
  return [count](EditorSession& session) {
    for (int i = 0; i < count && session.editor().undo(); ++i) {
    }
  };
}

EditorStep readRedo(JsonFields& fields) {
  const int count = fields.integer("redo", 1, 1000);
  return [count](EditorSession& session) {
    for (int i = 0; i < count && session.editor().redo(); ++i) {
    }
  };
}

EditorStep readEdit(JsonFields& fields) {
  const std::string edit = fields.value("edit").dump();
  return [edit](EditorSession& session) { session.editor().apply(edit); };
}

EditorStep readSave(JsonFields& fields) {
  const std::string file = fields.text("save");
  return [file](EditorSession& session) { writeFile(session.pathOf(file), session.editor().text()); };
}

EditorStep readImage(JsonFields& fields) {
  const std::string file = fields.text("image");
  return [file](EditorSession& session) {
    const Mesh& mesh = session.mesh();
    const FragmentImage fragments = rasterize(session.editor().camera(), mesh);
    writePng(session.pathOf(file), srgbFromLinear(colorImage(fragments, mesh, skyColor())));
  };
}

EditorStep readPlanImage(JsonFields& fields) {
  const std::string file = fields.text("plan_image");
  requireFigureFile(file);
  const PlanSide side = sideIn(fields);
  // What of the plan it shows: all of the scene where they are missing.
  std::optional<std::array<glm::dvec2, 2>> corners;
  if (fields.has("from") || fields.has("to")) {
    corners = {paperOf(side, pointIn(fields, "from")), paperOf(side, pointIn(fields, "to"))};
  }
  return [=](EditorSession& session) {
    const PlanBackdrop& backdrop = session.backdrop(side);
    const glm::dvec2 lower = corners ? glm::min((*corners)[0], (*corners)[1]) : glm::dvec2(backdrop.lower);
    const glm::dvec2 upper = corners ? glm::max((*corners)[0], (*corners)[1]) : glm::dvec2(backdrop.upper);
    const glm::dvec2 size = glm::max(upper - lower, glm::dvec2(1e-9));
    PlanWindow window;
    window.side = side;
    window.middle = (lower + upper) * 0.5;
    window.unitsPerPixel = std::max(size.x, size.y) / kFigurePixels;
    window.size = glm::max(glm::ivec2(size / window.unitsPerPixel), glm::ivec2(1));
    writeFigure(session.pathOf(file), editorFigure(session.editor(), window, &backdrop));
  };
}

}  // namespace

const std::vector<EditorStepKind>& editorStepKinds() {
  static const std::vector<EditorStepKind> kinds{
      {"tool", "chooses a tool by its name", readTool},
      {"press", "presses the button at a point of the plan", readPress},
      {"drag", "moves the pointer there", readDrag},
      {"release", "releases the button", readRelease},
      {"cancel", "leaves the drag", readCancel},
      {"stroke", "presses at the first point, drags through the others and releases", readStroke},
      {"handle", "selects the handle of this kind, with this \"index\", \"of\" a frustum", readHandle},
      {"move", "drags the selected handle to a point", readMove},
      {"nudge", "moves the selected handle by a distance to the right and up", readNudge},
      {"number", "types a number of the selected handle: what it \"is\"", readNumber},
      {"select", "selects a frustum", readSelect},
      {"next", "selects the next handle of the plan, or with -1 the one before", readNext},
      {"rename", "gives the selected frustum another name", readRename},
      {"remove", "deletes the selected frustum", readRemove},
      {"overlap", "whether frusta may overlap: allowed or refused", readOverlap},
      {"undo", "undoes a number of steps", readUndo},
      {"redo", "does a number of undone steps again", readRedo},
      {"edit", "an edit as `ocelli camera edit` takes it", readEdit},
      {"save", "writes the camera", readSave},
      {"image", "writes the camera's image, a PNG", readImage},
      {"plan_image", "writes the plan with what is drawn, \"from\" a corner \"to\" another: SVG or PNG",
       readPlanImage}};
  return kinds;
}

}  // namespace ocelli
