#include "display_sim/viewer/viewer_state.h"

#include <algorithm>
#include <cmath>

#include "display_sim/frames/display_profile.h"
#include "display_sim/viewer/view_motion.h"
#include "oc_core/base/check.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ocri/representation_kind.h"

namespace ocelli {
namespace {

constexpr double kBlinkSeconds = 0.5;

/// From beside the scene, above: the scene near by on the left, the reference eye and its cell far away on the right.
View outsideView() {
  View view;
  view.eye = {-4.6f, 2.5f, -0.9f};
  view.target = {0, 0, 3};
  view.fovVerticalDegrees = 54;
  return view;
}

/// From beside the scene, close enough to see its rays bend.
View closeUpView() {
  View view;
  view.eye = {-2.4f, 1.5f, 1.9f};
  view.target = {0, -0.1f, 0.1f};
  view.fovVerticalDegrees = 38;
  return view;
}

View displayFrontView() {
  View view;
  view.eye = {0, 2.6f, 9.6f};
  view.fovVerticalDegrees = 16.5;
  return view;
}

ViewCell cellOf(const CameraChoice& camera) {
  return {.sideRadii = camera.cellSideRadii};
}

/// The names that the viewer offers, `step` places further on than `name`.
std::string nameFurtherOn(const std::string& name, int step) {
  const std::vector<CameraName> names = cameraNames();
  const auto count = static_cast<int>(names.size());
  OC_CHECK(count > 0, "there are cameras");
  int at = 0;
  for (int i = 0; i < count; ++i) {
    if (name == names[static_cast<size_t>(i)].name) {
      at = i;
    }
  }
  do {
    at = ((at + step) % count + count) % count;
  } while (!cameraChoice(names[static_cast<size_t>(at)].name).hasImages());
  return names[static_cast<size_t>(at)].name;
}

template <class Enum>
std::string_view named(std::initializer_list<std::string_view> names, Enum value) {
  return names.begin()[static_cast<size_t>(value)];
}

}  // namespace

std::string_view titleOf(Pane pane) {
  return named(
      {"Scene", "Reference image", "Reconstruction", "Display", "Effect", "Lenses", "Volume", "Transfer function"},
      pane);
}

std::string_view nameOf(ReferenceShown::Quantity quantity) {
  return named({"colour", "depth", "displacement"}, quantity);
}

std::string_view nameOf(ReconstructionShown::Content content) {
  return named({"missing marked", "as it is", "truth", "beside truth", "blinking with truth"}, content);
}

std::string_view nameOf(EffectShown::Content content) {
  return named({"way", "traced", "difference"}, content);
}

std::string_view nameOf(LensesShown::Method method) {
  return named({"raster", "rays"}, method);
}

bool hasLenses(const ViewerState& state) {
  return static_cast<bool>(state.work.camera.kind->layout);
}

bool hasMesh(const ViewerState& state) {
  return !state.volume.on || state.work.sceneOptions.iso;
}

bool isOffered(const ViewerState& state, Pane pane) {
  switch (pane) {
    case Pane::kVolume:
    case Pane::kTransfer:
      return state.volume.on;
    case Pane::kEffect:
      return hasMesh(state) && state.effect.on;
    case Pane::kLenses:
      return hasMesh(state) && hasLenses(state);
    case Pane::kScene:
    case Pane::kReference:
    case Pane::kReconstruction:
      return hasMesh(state);
    case Pane::kDisplay:  // volumes are sliced themselves
      return true;
  }
  OC_CHECK(false, "every pane has a place or none");
}

ViewerState viewerState(const std::string& source, const SceneOptions& options, const CameraChoice& camera,
                        const View& reference, int width, int height, const std::string& profile) {
  ViewerState state;
  state.work.source = source;
  state.work.sceneOptions = options;
  state.work.camera = camera;
  state.work.reference = reference;
  state.work.width = width;
  state.work.height = height;
  state.work.profile = profile;
  state.work.lastRevision = 1;
  state.work.sceneRevision = state.work.cameraRevision = state.work.displayRevision = state.work.volumeRevision = 1;
  for (const Pane pane : kPanes) {
    resetPane(state, pane);
  }
  // On the edge of the view cell, where something is missing.
  const float half = hasLenses(state) ? 0 : camera.cellSideRadii / 2;
  state.reconstruction.view = movedEye(reference, {-half, half, 0});
  showKindOf(state, source);
  if (!hasMesh(state)) {  // nothing is missing in a volume
    state.reconstruction.view = reference;
  }
  return state;
}

void leavePane(ViewerState& state, Pane pane) {
  if (state.maximised == pane) {
    state.maximised.reset();
  }
  if (state.active == pane) {
    state.active = hasMesh(state) ? Pane::kReconstruction : Pane::kVolume;
  }
}

void showKindOf(ViewerState& state, const std::string& source) {
  state.volume.on = isVolumeSource(source);
  for (const Pane pane : kPanes) {
    if (!isOffered(state, pane)) {
      leavePane(state, pane);
    }
  }
}

void openScene(ViewerState& state, const std::string& source) {
  if (source != state.work.source) {
    state.work.sceneOptions.points = {};
    state.work.sceneOptions.labels = {};
    state.work.sceneOptions.iso.reset();
    state.work.sceneOptions.transfer.clear();
    state.work.sceneOptions.series.clear();
    state.work.volumeOptions = {};
    state.work.volumeIsShaded.reset();
  }
  state.work.source = source;
  state.work.sceneRevision = state.work.volumeRevision = ++state.work.lastRevision;
  showKindOf(state, source);
}

void displayFollowsVolume(ViewerState& state) {
  if (!state.volume.transfer) {
    return;
  }
  const std::shared_ptr<const VolumeAppearance>& appearance = state.volume.transfer->appearance();
  if (state.work.appearance != appearance || state.work.kept != state.volume.kept) {
    state.work.appearance = appearance;
    state.work.kept = state.volume.kept;
    displayChanged(state);
  }
}

void chooseIso(ViewerState& state, std::optional<double> value) {
  if (state.work.sceneOptions.iso != value) {
    state.work.sceneOptions.iso = value;
    state.work.sceneRevision = ++state.work.lastRevision;
    showKindOf(state, state.work.source);
  }
}

void cameraChanged(ViewerState& state) {
  state.lenses.changedAt.reset();
  state.work.cameraRevision = ++state.work.lastRevision;
}

void displayChanged(ViewerState& state) {
  state.work.displayRevision = ++state.work.lastRevision;
}

void chooseCamera(ViewerState& state, const std::string& nameOrFile) {
  if (state.volume.on && namesConstructor(nameOrFile)) {
    state.volume.rays = nameOrFile;
    return;
  }
  state.volume.rays.clear();
  state.work.camera = cameraChoice(nameOrFile, cellOf(state.work.camera));
  state.reference.image = 0;
  state.lenses.chosen.reset();
  state.lenses.locked.clear();
  if (!hasLenses(state)) {
    leavePane(state, Pane::kLenses);
  }
  cameraChanged(state);
}

void chooseNextCamera(ViewerState& state, int step) {
  chooseCamera(state, nameFurtherOn(state.work.camera.name, step));
}

void chooseCellSide(ViewerState& state, double sideRadii) {
  const auto side = static_cast<float>(std::clamp(sideRadii, kMinCellSide, kMaxCellSide));
  CameraChoice& camera = state.work.camera;
  camera.cellSideRadii = camera.ddoc.cellSideRadii = camera.cell.cell.sideRadii = side;
  cameraChanged(state);
}

void chooseProfile(ViewerState& state, const std::string& nameOrFile) {
  loadProfile(nameOrFile);
  state.work.profile = nameOrFile;
  displayChanged(state);
}

void chooseNextProfile(ViewerState& state) {
  const std::vector<std::string>& names = builtinProfileNames();
  const auto found = std::find(names.begin(), names.end(), state.work.profile);
  chooseProfile(state, found == names.end() || found + 1 == names.end() ? names.front() : *(found + 1));
}

void chooseImageSize(ViewerState& state, int width, int height) {
  state.work.width = std::clamp(width, kMinImageSide, kMaxImageSide);
  state.work.height = std::clamp(height, kMinImageSide, kMaxImageSide);
  cameraChanged(state);
}

void chooseReference(ViewerState& state, const View& view) {
  state.work.reference = view;
  state.reconstruction.view = view;
  cameraChanged(state);
}

void moveReferenceToEye(ViewerState& state) {
  state.work.reference = state.reconstruction.view;
  cameraChanged(state);
}

void orbitPane(ViewerState& state, Pane pane, double right, double up) {
  switch (pane) {
    case Pane::kScene:
      state.scene.view = orbited(state.scene.view, right, up);
      return;
    case Pane::kReference:
      panPane(state, pane, right / kPi, up / kPi);
      return;
    case Pane::kTransfer:
      panPane(state, pane, right / kPi, up / kPi);
      return;
    case Pane::kReconstruction:
    case Pane::kEffect:
    case Pane::kLenses:
    case Pane::kVolume:
      state.reconstruction.view = orbited(state.reconstruction.view, right, up);
      return;
    case Pane::kDisplay:
      View& view = state.display.followsEye ? state.reconstruction.view : state.display.view;
      view = orbited(view, right, up);
      return;
  }
}

void panPane(ViewerState& state, Pane pane, double right, double up) {
  switch (pane) {
    case Pane::kScene:
      state.scene.view = panned(state.scene.view, right, up);
      return;
    case Pane::kReference: {
      const glm::vec2 step(right / state.reference.zoom, -up / state.reference.zoom);
      state.reference.center = glm::clamp(state.reference.center + step, glm::vec2(0), glm::vec2(1));
      return;
    }
    case Pane::kTransfer:
      state.volume.axis = pannedAxis(state.volume.axis, state.volume.values, right);
      return;
    case Pane::kReconstruction:
    case Pane::kEffect:
    case Pane::kLenses:
    case Pane::kVolume:
      state.reconstruction.view = panned(state.reconstruction.view, right, up);
      return;
    case Pane::kDisplay:  // an observer looks at the middle of the display
      orbitPane(state, pane, right, up);
      return;
  }
}

void zoomPane(ViewerState& state, Pane pane, double factor) {
  switch (pane) {
    case Pane::kScene:
      state.scene.view = zoomed(state.scene.view, 1 / factor);
      return;
    case Pane::kReference:
      state.reference.zoom = std::clamp(state.reference.zoom * factor, 1.0, kMaxReferenceZoom);
      return;
    case Pane::kTransfer:
      state.volume.axis = zoomedAxis(state.volume.axis, state.volume.values, state.volume.axis.valueAt(0.5), factor);
      return;
    case Pane::kReconstruction:
    case Pane::kEffect:
    case Pane::kLenses:
    case Pane::kVolume:
      state.reconstruction.view = zoomed(state.reconstruction.view, 1 / factor);
      return;
    case Pane::kDisplay:
      View& view = state.display.followsEye ? state.reconstruction.view : state.display.view;
      view = zoomed(view, 1 / factor);
      return;
  }
}

void resetPane(ViewerState& state, Pane pane) {
  switch (pane) {
    case Pane::kScene:
      state.scene.view = outsideView();
      return;
    case Pane::kReference:
      state.reference.center = glm::vec2(0.5f);
      state.reference.zoom = 1;
      return;
    case Pane::kTransfer:
      state.volume.axis = state.volume.values;
      return;
    case Pane::kReconstruction:
    case Pane::kLenses:
    case Pane::kVolume:
      state.reconstruction.view = state.work.reference;
      return;
    case Pane::kEffect:
      state.reconstruction.view = state.effectHome.value_or(state.work.reference);
      return;
    case Pane::kDisplay:
      state.display.view = displayFrontView();
      return;
  }
}

void toggleCloseUp(ViewerState& state) {
  state.scene.view = state.scene.view == closeUpView() ? outsideView() : closeUpView();
}

void advance(ViewerState& state, double seconds, double rotationsPerMinute) {
  state.seconds += seconds;
  if (state.display.running) {
    const double turns = seconds * state.display.speed * rotationsPerMinute / 60;
    state.display.sweepDegrees = std::fmod(state.display.sweepDegrees + 360 * turns, 360.0);
  }
}

void changeSpeed(ViewerState& state, double factor) {
  state.display.speed = std::clamp(state.display.speed * factor, kMinSpeed, kMaxSpeed);
}

void stepDisplay(ViewerState& state, int slices) {
  state.display.running = false;
  const double step = 180.0 / loadProfile(state.work.profile).slicesPerHalfTurn;
  const double slice = std::round(state.display.sweepDegrees / step) + slices;
  state.display.sweepDegrees = std::fmod(slice * step + 360, 360.0);
}

const View& displayView(const ViewerState& state) {
  return state.display.followsEye ? state.reconstruction.view : state.display.view;
}

bool blinkShowsTruth(const ViewerState& state) {
  return std::fmod(state.seconds, 2 * kBlinkSeconds) >= kBlinkSeconds;
}

}  // namespace ocelli
