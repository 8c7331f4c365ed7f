#include "oc_core/frustum_editor/frustum_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/frustum_editor/drawn_edits.h"

namespace ocelli {
namespace {

constexpr const char* kDrawnHere = "drawing";  // what errors call the edits of the editor

Box worldOf(const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    throw InputError("the scene has no triangle", "drawing a camera", "choose another scene");
  }
  return boundsOf(mesh);
}

/// Edits find turns by their names: those that have none, or one that is taken, get one.
std::string withNames(const std::string& text, const std::string& where) {
  const nlohmann::json checked = parseJson(text, where);
  if (!checked.is_object() || checked.value("camera", nlohmann::json()) != "curved" || !checked.contains("turns") ||
      !checked["turns"].is_array()) {
    return text;
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, true, true);
  std::vector<std::string> names;
  bool changed = false;
  for (nlohmann::ordered_json& turn : json["turns"]) {
    if (!turn.is_object()) {
      return text;
    }
    const bool hasName = turn.contains("name") && turn["name"].is_string() && turn["name"] != "root";
    std::string name = hasName ? turn["name"].get<std::string>() : "";
    for (size_t number = names.size() + 1; name.empty() || std::find(names.begin(), names.end(), name) != names.end();
         ++number) {
      name = "turn " + std::to_string(number);
    }
    changed = changed || !hasName || turn["name"] != name;
    turn["name"] = name;
    names.push_back(name);
  }
  return changed ? textOfJson(json, 1) : text;
}

/// Of the size that the file says its images have, if it says one.
PinholeCamera referenceOfSize(const std::string& text, const std::string& where, const PinholeCamera& reference) {
  const nlohmann::json json = parseJson(text, where);
  if (!json.is_object()) {
    return reference;
  }
  JsonFields fields(json, where);
  const std::optional<glm::ivec2> size = readSize(fields);
  return size ? PinholeCamera(reference.view(), size->x, size->y) : reference;
}

/// A camera of another scene, or of the same one fitted: its frusta lie elsewhere.
std::string whatIsSeen(const DrawnCamera& drawn, const Box& world) {
  for (const DrawnFrustum& frustum : drawn.frusta) {
    for (const DrawnVolume& volume : frustum.volumes) {
      Box box;
      for (const glm::dvec3& corner : volume) {
        box.add(glm::vec3(corner));
      }
      const bool isApart = box.empty() || glm::any(glm::lessThan(box.upper, world.lower)) ||
                           glm::any(glm::greaterThan(box.lower, world.upper));
      if (!isApart) {
        return "";
      }
    }
  }
  return "No ray of the camera comes to the scene. Is it the camera of another scene? A camera in metres needs "
         "--no-fit.";
}

std::string overlapMessage(const DrawnOverlap& overlap, bool allowed) {
  const auto number = [](double value) {
    std::string text = std::to_string(roundedTo(value, 0.01));
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
  };
  return "\"" + overlap.first + "\" and \"" + overlap.second + "\" overlap: both hold the point (" +
         number(overlap.point.x) + ", " + number(overlap.point.y) + ", " + number(overlap.point.z) + ")." +
         (allowed ? "" : " The image stays as it was before they did. Move them apart, or end one with a limit.");
}

}  // namespace

std::string FrustumEditor::newGraphCamera(const PinholeCamera& root) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(jsonText(GraphCamera(root)));
  json["overlap"] = "refused";
  return textOfJson(json, 1);
}

std::string FrustumEditor::newCurvedCamera(const PinholeCamera& root) {
  return jsonText(CurvedRayCamera(root));
}

FrustumEditor::FrustumEditor(const std::string& text, const std::string& where, const PinholeCamera& reference,
                             const Mesh& mesh, const SceneGuides& guides)
    : mesh_(&mesh),
      guides_(guides),
      world_(worldOf(mesh)),
      editor_(withNames(text, where), where, referenceOfSize(text, where, reference), world_),
      camera_(editor_.camera()),
      tool_(&editorTools().front()) {
  showDocument();
  message_ = whatIsSeen(*drawn_, world_);
}

bool FrustumEditor::open(const std::string& text, const std::string& where) {
  try {
    editor_ = CameraEditor(withNames(text, where), where, referenceOfSize(text, where, editor_.reference()), world_);
  } catch (const InputError& error) {
    message_ = error.what();
    return false;
  }
  drag_.reset();
  snap_.reset();
  sceneSnaps_ = {};
  selectedHandle_.reset();
  selectedFrustum_.clear();
  tool_ = &editorTools().front();
  showDocument();
  message_ = whatIsSeen(*drawn_, world_);
  return true;
}

MultiperspectiveCamera FrustumEditor::cameraOfWidth(int width) const {
  const glm::dvec2 size = drawn_->imageSize();
  const int height = std::max(1, static_cast<int>(std::lround(width * size.y / size.x)));
  const PinholeCamera reference(editor_.reference().view(), width, height);
  return CameraEditor::cameraOf(text_, kDrawnHere, reference, Box{});
}

void FrustumEditor::show(const std::string& text, MultiperspectiveCamera camera) {
  if (text != text_) {
    ++revision_;
  }
  text_ = text;
  camera_ = std::move(camera);
}

void FrustumEditor::showDocument() {
  show(editor_.text(), editor_.camera());
  drawn_ = std::make_shared<const DrawnCamera>(drawnCamera(text_, camera_, world_));
  keepSelection();
}

void FrustumEditor::keepSelection() {
  if (drawn_->find(selectedFrustum_) == nullptr) {
    selectedFrustum_.clear();
  }
  if (selectedHandle_ && drawn_->find(selectedHandle_->frustum) == nullptr) {
    selectedHandle_.reset();
  }
}

void FrustumEditor::chooseTool(const std::string& name) {
  const EditorTool& tool = editorTool(name);
  cancel();
  if (drawn_->isGraph() ? !tool.ofGraph : !tool.ofCurved) {
    message_ = "The tool \"" + name + "\" is for " + (drawn_->isGraph() ? "curved ray" : "graph") + " cameras.";
    return;
  }
  tool_ = &tool;
  message_ = "";
}

const std::vector<SnapPoint>& FrustumEditor::sceneSnapsOf(PlanSide side) {
  std::optional<std::vector<SnapPoint>>& snaps = sceneSnaps_[static_cast<size_t>(side)];
  if (!snaps) {
    snaps = sceneSnaps(*mesh_, guides_, side, planCut(*mesh_, side, glm::dvec3(drawn_->view.eye)));
  }
  return *snaps;
}

PlanPointer FrustumEditor::snappedPointer(const PlanPointer& pointer) {
  snap_.reset();
  if (!pointer.snaps || !(pointer.reach > 0)) {
    return pointer;
  }
  std::vector<SnapPoint> points = sceneSnapsOf(pointer.side);
  // As the camera was before the drag: what moves with the pointer must not hold it.
  const DrawnCamera& camera = drag_ ? *drag_->before : *drawn_;
  const std::string without = drag_ && drag_->handle ? drag_->handle->frustum : "";
  const std::vector<SnapPoint> own = cameraSnaps(camera, pointer.side, without);
  points.insert(points.end(), own.begin(), own.end());
  // Points first, then planes, then the grid.
  snap_ = snapped(points, pointer.paper, pointer.reach, 0);
  if (!snap_) {
    snap_ = snappedToPlane(camera, pointer.side, without, pointer.paper, pointer.reach);
  }
  if (!snap_) {
    snap_ = snapped({}, pointer.paper, pointer.reach, gridStep(pointer.reach / kPlanReachPixels));
  }
  PlanPointer moved = pointer;
  moved.paper = snap_ ? snap_->at : pointer.paper;
  return moved;
}

/// From near to far; of those on each other, that of the selected frustum comes first.
std::vector<FrustumHandle> FrustumEditor::handlesNear(const PlanPointer& pointer) const {
  std::vector<std::pair<double, FrustumHandle>> ranked;
  for (const FrustumHandle& handle : handlesOf(*drawn_, pointer.side)) {
    const double distance = glm::distance(paperFromWorld(pointer.side, handle.at), pointer.paper);
    if (distance <= pointer.reach) {
      ranked.emplace_back(distance + (handle.frustum == selectedFrustum_ ? 0 : pointer.reach), handle);
    }
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<FrustumHandle> handles;
  for (auto& [rank, handle] : ranked) {
    handles.push_back(std::move(handle));
  }
  return handles;
}

void FrustumEditor::press(const PlanPointer& pointer) {
  cancel();
  message_ = "";
  if (tool_->apply != nullptr) {
    const PlanPointer from = snappedPointer(pointer);
    drag_ = Drag{from, from, std::nullopt, drawn_, "", "", std::nullopt};
    followDrag();
    return;
  }
  const std::vector<FrustumHandle> near = handlesNear(pointer);
  if (!near.empty()) {
    const auto again = std::find_if(near.begin(), near.end(), [&](const FrustumHandle& handle) {
      return selectedHandle_ && handle.isSame(*selectedHandle_);
    });
    const bool isAgain = again != near.end();
    const FrustumHandle handle = isAgain ? *again : near.front();
    drag_ = Drag{pointer, pointer, handle, drawn_, "", "", std::nullopt};
    if (isAgain) {
      drag_->ifClicked = again + 1 == near.end() ? near.front() : *(again + 1);
    }
    selectedHandle_ = handle;
    selectedFrustum_ = handle.frustum;
    return;
  }
  const DrawnFrustum* frustum = frustumAt(*drawn_, pointer.side, pointer.paper);
  selectedHandle_.reset();
  selectedFrustum_ = frustum != nullptr ? frustum->name : "";
}

void FrustumEditor::dragTo(const PlanPointer& pointer) {
  if (!drag_ || pointer.side != drag_->from.side) {
    return;
  }
  drag_->to = snappedPointer(pointer);
  followDrag();
}

StrokeEdit FrustumEditor::editOfDrag() const {
  if (!drag_->handle) {
    return tool_->apply(*drag_->before, *stroke());
  }
  const FrustumHandle& handle = *drag_->handle;
  if (drag_->to.paper == drag_->from.paper) {
    return {};
  }
  // What it snapped to is where the handle goes; else it keeps its distance to the pointer.
  const glm::dvec2 grip = paperFromWorld(handle.side, handle.at);
  const glm::dvec2 to = snap_ ? drag_->to.paper : grip + drag_->to.paper - drag_->from.paper;
  const glm::dvec3 world = worldFromPaper(handle.side, to, handle.at[axisOf(handle.side)]);
  return {handle.kind->drag(*drag_->before, handle, world), handle.frustum};
}

void FrustumEditor::followDrag() {
  message_ = "";
  try {
    const StrokeEdit stroke = editOfDrag();
    if (stroke.edit.empty()) {
      return;
    }
    const std::string text = editor_.edited(stroke.edit, kDrawnHere);
    MultiperspectiveCamera camera = CameraEditor::cameraOf(text, kDrawnHere, editor_.reference(), Box{});
    drawn_ = std::make_shared<const DrawnCamera>(drawnCamera(text, camera, world_));
    if (!drawn_->overlaps.empty()) {
      message_ = overlapMessage(drawn_->overlaps.front(), drawn_->overlapAllowed);
      if (!drawn_->overlapAllowed) {
        return;
      }
    }
    drag_->lastEdit = stroke.edit;
    drag_->selects = stroke.selected;
    show(text, std::move(camera));
  } catch (const InputError& error) {
    message_ = error.what();
  }
}

void FrustumEditor::release() {
  if (!drag_) {
    return;
  }
  const Drag drag = *std::exchange(drag_, std::nullopt);
  std::string message = message_;
  snap_.reset();
  if (!drag.lastEdit.empty()) {
    editor_.apply(drag.lastEdit, kDrawnHere);
    selectedFrustum_ = drag.selects;
    if (!drag.handle) {
      selectedHandle_.reset();
    }
  } else if (drag.ifClicked && drag.to.paper == drag.from.paper) {
    selectedHandle_ = drag.ifClicked;
    selectedFrustum_ = drag.ifClicked->frustum;
  } else if (!drag.handle && message.empty()) {
    message = "The stroke is too short for the tool \"" + tool_->name + "\": " + tool_->says + ".";
  }
  showDocument();
  message_ = message;
}

void FrustumEditor::cancel() {
  if (drag_) {
    drag_.reset();
    snap_.reset();
    showDocument();
    message_ = "";
  }
}

std::optional<PlanStroke> FrustumEditor::stroke() const {
  if (!drag_ || drag_->handle) {
    return std::nullopt;
  }
  return PlanStroke{drag_->from.side, drag_->from.paper, drag_->to.paper, selectedFrustum_};
}

std::optional<FrustumHandle> FrustumEditor::selectedHandle(PlanSide side) const {
  if (selectedHandle_) {
    for (const FrustumHandle& handle : handlesOf(*drawn_, side)) {
      if (handle.isSame(*selectedHandle_)) {
        return handle;
      }
    }
  }
  return std::nullopt;
}

void FrustumEditor::select(const std::string& frustum) {
  if (drawn_->find(frustum) == nullptr) {
    throw InputError("there is no frustum \"" + frustum + "\"", "drawing a camera", "select one that is there");
  }
  selectedFrustum_ = frustum;
  selectedHandle_.reset();
}

void FrustumEditor::selectHandle(PlanSide side, const std::string& frustum, const std::string& kind, int index) {
  select(frustum);
  const HandleKind& wanted = handleKind(kind);
  for (const FrustumHandle& handle : handlesOf(*drawn_, side)) {
    if (handle.kind == &wanted && handle.frustum == frustum && handle.index == index) {
      selectedHandle_ = handle;
      return;
    }
  }
  throw InputError("\"" + frustum + "\" has no handle \"" + kind + "\" " + std::to_string(index) + " in the plan \"" +
                       nameOf(side) + "\"",
                   "drawing a camera", "use another handle, or another plan");
}

void FrustumEditor::selectNextHandle(PlanSide side, int step) {
  const std::vector<FrustumHandle> handles = handlesOf(*drawn_, side);
  if (handles.empty()) {
    return;
  }
  const auto at = std::find_if(handles.begin(), handles.end(), [&](const FrustumHandle& handle) {
    return selectedHandle_ ? handle.isSame(*selectedHandle_) : handle.frustum == selectedFrustum_;
  });
  const int count = static_cast<int>(handles.size());
  const int found = static_cast<int>(at - handles.begin());
  // Without a handle, the first of the selected frustum, or of all.
  const bool isFirst = !selectedHandle_ || at == handles.end();
  const int next = isFirst ? (at == handles.end() ? 0 : found) : ((found + step) % count + count) % count;
  selectedHandle_ = handles[static_cast<size_t>(next)];
  selectedFrustum_ = selectedHandle_->frustum;
}

std::vector<HandleNumber> FrustumEditor::numbers(PlanSide side) const {
  const std::optional<FrustumHandle> handle = selectedHandle(side);
  return handle ? numbersOf(*drawn_, *handle) : std::vector<HandleNumber>{};
}

bool FrustumEditor::apply(const std::string& edit) {
  cancel();
  message_ = "";
  try {
    editor_.apply(edit, kDrawnHere);
  } catch (const InputError& error) {
    message_ = error.what();
    return false;
  }
  showDocument();
  if (!drawn_->overlaps.empty()) {
    message_ = overlapMessage(drawn_->overlaps.front(), drawn_->overlapAllowed);
  }
  return true;
}

bool FrustumEditor::moveHandle(PlanSide side, const glm::dvec2& paper) {
  cancel();
  const std::optional<FrustumHandle> handle = selectedHandle(side);
  if (!handle) {
    message_ = "No handle of this plan is selected.";
    return false;
  }
  try {
    return apply(handle->kind->drag(*drawn_, *handle, worldFromPaper(side, paper, handle->at[axisOf(side)])));
  } catch (const InputError& error) {
    message_ = error.what();
    return false;
  }
}

bool FrustumEditor::nudge(PlanSide side, const glm::dvec2& paper) {
  const std::optional<FrustumHandle> handle = selectedHandle(side);
  return moveHandle(side, handle ? paperFromWorld(side, handle->at) + paper : paper);
}

bool FrustumEditor::typeNumber(PlanSide side, const std::string& number, double value) {
  cancel();
  std::string names;
  try {
    for (const HandleNumber& each : numbers(side)) {
      if (each.name == number) {
        return apply(each.edit(value));
      }
      names += (names.empty() ? "" : ", ") + each.name;
    }
  } catch (const InputError& error) {
    message_ = error.what();
    return false;
  }
  message_ = names.empty() ? "No handle of this plan is selected."
                           : "The handle has no number \"" + number + "\", but " + names + ".";
  return false;
}

bool FrustumEditor::renameSelected(const std::string& to) {
  cancel();
  const std::string from = selectedFrustum_;
  if (from.empty() || from == "root") {
    message_ = from.empty() ? "No frustum is selected." : "The root keeps its name.";
    return false;
  }
  if (to.empty() || drawn_->find(to) != nullptr) {
    message_ = to.empty() ? "A name must not be empty." : "There is a frustum \"" + to + "\" already.";
    return false;
  }
  const bool had = selectedHandle_.has_value();
  std::optional<FrustumHandle> handle = selectedHandle_;
  if (!apply(DrawnEdits::rename(from, to))) {
    return false;
  }
  selectedFrustum_ = to;
  if (had) {
    handle->frustum = to;
    selectedHandle_ = handle;
  }
  return true;
}

bool FrustumEditor::removeSelected() {
  if (selectedFrustum_.empty() || selectedFrustum_ == "root") {
    message_ = selectedFrustum_.empty() ? "No frustum is selected." : "The root stays.";
    return false;
  }
  return apply(DrawnEdits::remove(selectedFrustum_));
}

bool FrustumEditor::allowOverlap(bool allowed) {
  return apply(DrawnEdits::overlap(allowed));
}

bool FrustumEditor::undo() {
  return apply(R"({"edit": "undo"})");
}

bool FrustumEditor::redo() {
  return apply(R"({"edit": "redo"})");
}

}  // namespace ocelli
