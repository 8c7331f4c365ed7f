#include "oc_core/feeds_editor/face_editor.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kFirstHeight = 2.5;  ///< metres, of a face that is drawn where there is no other one
constexpr size_t kMaxUndo = 200;

glm::dvec2 onPlan(const glm::dvec3& p) {
  return {p.x, p.z};
}

}  // namespace

PlanFace planFaceOf(const FeedFrustum& frustum) {
  const auto& p = frustum.near;
  PlanFace face{frustum.feed, frustum.parent, {}, {}, p[0].y, p[0].y};
  for (const glm::dvec3& corner : p) {
    face.bottom = std::min(face.bottom, corner.y);
    face.top = std::max(face.top, corner.y);
  }
  // Its sides that go up join corners that lie one over the other in the plan, or nearly so.
  const bool isFirstUpright = glm::distance(onPlan(p[0]), onPlan(p[1])) + glm::distance(onPlan(p[2]), onPlan(p[3])) <=
                              glm::distance(onPlan(p[1]), onPlan(p[2])) + glm::distance(onPlan(p[3]), onPlan(p[0]));
  face.from = (onPlan(p[0]) + onPlan(isFirstUpright ? p[1] : p[3])) * 0.5;
  face.to = (onPlan(p[2]) + onPlan(isFirstUpright ? p[3] : p[1])) * 0.5;
  return face;
}

FaceEditor::FaceEditor(const FeedSetup& setup, std::vector<SnapPoint> corners)
    : setup_(setup), corners_(std::move(corners)), selected_(setup.feeds.front().name) {
  orderFrusta(setup_, "the setup");
  check();
}

FeedFrustum* FaceEditor::frustumOf(const std::string& feed) {
  const auto found = std::ranges::find(setup_.frusta, feed, &FeedFrustum::feed);
  return found == setup_.frusta.end() ? nullptr : &*found;
}

const FeedFrustum* FaceEditor::frustumOf(const std::string& feed) const {
  const auto found = std::ranges::find(setup_.frusta, feed, &FeedFrustum::feed);
  return found == setup_.frusta.end() ? nullptr : &*found;
}

std::vector<PlanFace> FaceEditor::faces() const {
  std::vector<PlanFace> faces;
  for (const FeedFrustum& frustum : setup_.frusta) {
    if (!frustum.isRoot()) {
      faces.push_back(planFaceOf(frustum));
    }
  }
  return faces;
}

void FaceEditor::check() {
  ++revision_;
  try {
    FeedSetup ordered = setup_;
    orderFrusta(ordered, "the setup");
    graph_ = std::make_shared<const FeedGraph>(ordered);
    problem_.clear();
  } catch (const InputError& error) {
    problem_ = error.what();
  }
}

void FaceEditor::change(std::vector<FeedFrustum> before) {
  undo_.push_back(std::move(before));
  if (undo_.size() > kMaxUndo) {
    undo_.erase(undo_.begin());
  }
  redo_.clear();
  check();
}

void FaceEditor::undo() {
  if (canUndo() && !drag_) {
    redo_.push_back(std::exchange(setup_.frusta, undo_.back()));
    undo_.pop_back();
    check();
  }
}

void FaceEditor::redo() {
  if (canRedo() && !drag_) {
    undo_.push_back(std::exchange(setup_.frusta, redo_.back()));
    redo_.pop_back();
    check();
  }
}

void FaceEditor::select(const std::string& feed) {
  OC_CHECK(setup_.feedIndex(feed) >= 0, "there is no such feed");
  selected_ = feed;
}

void FaceEditor::selectNext(int step) {
  const int count = static_cast<int>(setup_.feeds.size());
  selected_ = setup_.feeds[static_cast<size_t>((setup_.feedIndex(selected_) + step % count + count) % count)].name;
}

void FaceEditor::setFace(const PlanFace& face) {
  const auto corner = [&](const glm::dvec2& at, double y) { return glm::dvec3(at.x, y, at.y); };
  FeedFrustum* frustum = frustumOf(face.feed);
  if (frustum == nullptr) {
    setup_.frusta.push_back({face.feed, face.parent, {}});
    frustum = &setup_.frusta.back();
  }
  frustum->near = {corner(face.from, face.bottom), corner(face.from, face.top), corner(face.to, face.top),
                   corner(face.to, face.bottom)};
}

void FaceEditor::press(const glm::dvec2& paper, double reach) {
  cancel();
  double nearest = reach;
  for (const PlanFace& face : faces()) {
    const std::array<std::pair<Held, glm::dvec2>, 3> handles{
        {{Held::kFrom, face.from}, {Held::kTo, face.to}, {Held::kMiddle, (face.from + face.to) * 0.5}}};
    for (const auto& [held, at] : handles) {
      // The selected face has the handles that others share with it.
      const double distance = glm::distance(at, paper) * (face.feed == selected_ ? 0.5 : 1);
      if (distance < nearest) {
        nearest = distance;
        drag_ = Drag{face.feed, held, paper, face, setup_.frusta};
      }
    }
  }
  if (drag_) {
    selected_ = drag_->feed;
    return;
  }
  if (frustumOf(selected_) == nullptr) {
    const auto others = faces();
    const double bottom = others.empty() ? setup_.floorHeight : others.front().bottom;
    const double top = others.empty() ? setup_.floorHeight + kFirstHeight : others.front().top;
    drag_ = Drag{
        selected_, Held::kTo, paper, {selected_, setup_.frusta.front().feed, paper, paper, bottom, top}, setup_.frusta};
  }
}

void FaceEditor::dragTo(const glm::dvec2& paper, double reach, double grid, bool snaps) {
  if (!drag_) {
    return;
  }
  PlanFace face = drag_->face;
  glm::dvec2 to = paper;
  snap_.reset();
  if (snaps) {
    std::vector<SnapPoint> points = corners_;
    for (const PlanFace& other : faces()) {
      if (other.feed != face.feed) {
        points.push_back({"face of " + other.feed, other.from});
        points.push_back({"face of " + other.feed, other.to});
      }
    }
    snap_ = snapped(points, paper, reach, grid);
    to = snap_ ? snap_->at : paper;
  }
  switch (drag_->held) {
    case Held::kFrom:
      face.from = to;
      break;
    case Held::kTo:
      face.to = to;
      break;
    case Held::kMiddle: {
      const glm::dvec2 way = to - (face.from + face.to) * 0.5;
      face.from += way;
      face.to += way;
      break;
    }
  }
  if (glm::distance(face.from, face.to) >= kMinFaceSize) {
    setFace(face);
    check();
  }
}

void FaceEditor::release() {
  if (drag_) {
    std::vector<FeedFrustum> before = std::move(drag_->before);
    drag_.reset();
    snap_.reset();
    if (before != setup_.frusta) {
      change(std::move(before));
    }
  }
}

void FaceEditor::cancel() {
  if (drag_) {
    setup_.frusta = std::move(drag_->before);
    drag_.reset();
    snap_.reset();
    check();
  }
}

bool FaceEditor::isBelow(const std::string& feed, const std::string& ancestor) const {
  for (const FeedFrustum* f = frustumOf(feed); f != nullptr; f = f->isRoot() ? nullptr : frustumOf(f->parent)) {
    if (f->feed == ancestor) {
      return true;
    }
  }
  return false;
}

void FaceEditor::changeParent() {
  FeedFrustum* frustum = frustumOf(selected_);
  if (frustum == nullptr || frustum->isRoot()) {
    return;
  }
  const std::vector<FeedFrustum> before = setup_.frusta;
  const size_t count = before.size();
  const auto now = static_cast<size_t>(std::ranges::find(before, frustum->parent, &FeedFrustum::feed) - before.begin());
  for (size_t step = 1; step < count; ++step) {
    const std::string& other = before[(now + step) % count].feed;
    if (!isBelow(other, selected_)) {
      frustum->parent = other;
      change(before);
      return;
    }
  }
}

void FaceEditor::moveTop(double metres) {
  if (const FeedFrustum* frustum = frustumOf(selected_); frustum != nullptr && !frustum->isRoot()) {
    std::vector<FeedFrustum> before = setup_.frusta;
    PlanFace face = planFaceOf(*frustum);
    face.top = std::max(face.bottom + kMinFaceSize, face.top + metres);
    setFace(face);
    change(std::move(before));
  }
}

void FaceEditor::moveBottom(double metres) {
  if (const FeedFrustum* frustum = frustumOf(selected_); frustum != nullptr && !frustum->isRoot()) {
    std::vector<FeedFrustum> before = setup_.frusta;
    PlanFace face = planFaceOf(*frustum);
    face.bottom = std::min(face.top - kMinFaceSize, face.bottom + metres);
    setFace(face);
    change(std::move(before));
  }
}

void FaceEditor::remove() {
  const FeedFrustum* frustum = frustumOf(selected_);
  if (frustum == nullptr || frustum->isRoot()) {
    return;
  }
  std::vector<FeedFrustum> before = setup_.frusta;
  const std::string parent = frustum->parent;
  for (FeedFrustum& other : setup_.frusta) {
    if (other.parent == selected_) {
      other.parent = parent;
    }
  }
  std::erase_if(setup_.frusta, [&](const FeedFrustum& f) { return f.feed == selected_; });
  change(std::move(before));
}

}  // namespace ocelli
