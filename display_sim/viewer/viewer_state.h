// What the viewer shows and how, as plain data, and the functions that change it. No OpenGL, no window.
//
// Changes that need work (loading, building, slicing) raise the revision of that work; background_work.h does it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "display_sim/viewer/volume_shown.h"
#include "oc_core/camera/view.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

enum class Pane { kScene, kReference, kReconstruction, kDisplay, kEffect, kLenses, kVolume, kTransfer };
inline constexpr size_t kPaneCount = 8;
inline constexpr std::array kPanes{Pane::kScene,  Pane::kReference, Pane::kReconstruction, Pane::kDisplay,
                                   Pane::kEffect, Pane::kLenses,    Pane::kVolume,         Pane::kTransfer};
/// "Scene", "Reference image", "Reconstruction", "Display", "Effect", "Lenses", "Volume", "Transfer function".
std::string_view titleOf(Pane pane);

/// What has to be made. Code that changes a part of it must give that part the next revision.
struct WorkWanted {
  uint64_t lastRevision = 0;
  std::string source;
  SceneOptions sceneOptions;
  VolumeSceneOptions volumeOptions;    ///< of a scene that is a volume; `fit` and `warn` are those of sceneOptions
  std::optional<bool> volumeIsShaded;  ///< nothing: as its transfer function says
  uint64_t sceneRevision = 0;
  uint64_t volumeRevision = 0;  ///< of the volume, where the scene is one: its surface alone changes the scene's

  CameraChoice camera;
  View reference;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  uint64_t cameraRevision = 0;

  std::string profile = "perspecta";
  bool sliceScene = false;  ///< the scene itself, instead of what stands for it
  /// Of a volume that is sliced itself; null: its own.
  std::shared_ptr<const VolumeAppearance> appearance;
  std::array<glm::dvec2, 3> kept = VolumeShown::kWhole;  ///< as in VolumeShown
  uint64_t displayRevision = 0;
};

/// The scene pane: the scene from outside, with the camera in it.
struct SceneShown {
  View view;
  bool frustum = true;
  bool rays = true;
  bool straightRays = true;  ///< the others bend
  bool cell = true;
  bool samples = false;
  int rayColumns = 24;
  int rayRows = 16;
  bool operator==(const SceneShown&) const = default;
};
inline constexpr int kMaxRayRows = 64;

/// The reference image pane.
struct ReferenceShown {
  enum class Quantity { kColor, kDepth, kDisplacement };
  Quantity quantity = Quantity::kColor;
  int image = 0;           ///< of a union
  glm::vec2 center{0.5f};  ///< what lies in the middle of the pane, as a share of the image
  double zoom = 1;         ///< 1 just holds the image
  bool operator==(const ReferenceShown&) const = default;
};
inline constexpr double kMaxReferenceZoom = 200;
std::string_view nameOf(ReferenceShown::Quantity quantity);

/// The reconstruction pane.
struct ReconstructionShown {
  enum class Content { kMarked, kPlain, kTruth, kSideBySide, kBlink };
  View view;  ///< where the user's eye is
  Content content = Content::kMarked;
};
std::string_view nameOf(ReconstructionShown::Content content);

/// The display pane.
struct DisplayShown {
  View view;
  bool followsEye = false;  ///< of the reconstruction pane
  bool running = true;
  double speed = 1;                 ///< 1 turns as fast as the display does
  double sweepDegrees = 0;          ///< angle of the screen, in [0, 360)
  double persistenceSeconds = 0.1;  ///< until what the eye sees has faded to 1 / e
  double gain = 1;                  ///< on the automatic one
  bool operator==(const DisplayShown&) const = default;
};
inline constexpr double kMinSpeed = 1.0 / 16384;
inline constexpr double kMaxSpeed = 4;

/// The effect pane: what `ocelli shade` draws (oc_core/shade/effects.h), from where the user's eye is.
struct EffectShown {
  enum class Content { kByWay, kByTracing, kDifference };
  bool on = false;
  std::string effect;     ///< its name; empty: the first one that the scene has objects for
  std::string way;        ///< what stands for the scene where its rays go; empty: the camera, where the effect takes it
  std::string rolesFile;  ///< empty: that of the scene
  int rolesRead = 0;      ///< counts how often it was given, as it may have changed
  Content content = Content::kByWay;
  bool operator==(const EffectShown&) const = default;
};
inline constexpr std::array kEffectContents{EffectShown::Content::kByWay, EffectShown::Content::kByTracing,
                                            EffectShown::Content::kDifference};
std::string_view nameOf(EffectShown::Content content);

/// The lens pane: what the user's eye sees through a camera with regions of detail (`gpc`). These are lenses, to be
/// edited by hand (lens_choice.h); they stand in `work.camera.gpc`.
struct LensesShown {
  enum class Method { kRaster, kRays };
  Method method = Method::kRaster;
  std::optional<size_t> chosen;     ///< the lens that keys edit
  std::vector<bool> locked;         ///< those that no edit changes; as far as it reaches
  bool rates = false;               ///< sampling rates in false colours over the picture
  std::optional<double> changedAt;  ///< when an edit was made that the other panes have not followed yet
};
std::string_view nameOf(LensesShown::Method method);

struct ViewerState {
  WorkWanted work;
  SceneShown scene;
  ReferenceShown reference;
  ReconstructionShown reconstruction;
  DisplayShown display;
  EffectShown effect;
  LensesShown lenses;
  VolumeShown volume;
  /// Where Home brings the user's eye in the effect pane: the view of the effect, once that is known.
  std::optional<View> effectHome;

  Pane active = Pane::kReconstruction;  ///< the one that keys move
  std::optional<Pane> maximised;
  bool panel = true;
  bool help = false;
  double seconds = 0;  ///< that have passed
};

/// Of a scene seen through a camera. The size is that of the reference image. The user's eye starts at an edge of the
/// view cell; with a camera that has lenses, which is made for one eye, at the reference view.
ViewerState viewerState(const std::string& source, const SceneOptions& options, const CameraChoice& camera,
                        const View& reference, int width, int height, const std::string& profile);

/// Whether the camera has regions of detail, which are edited as lenses.
bool hasLenses(const ViewerState& state);
/// Whether there are triangles, which most panes show: of a volume those of a surface in it, where one is asked for.
bool hasMesh(const ViewerState& state);
/// Whether a pane has a place among the others.
bool isOffered(const ViewerState& state, Pane pane);
/// Where it is alone or active, others show and one of them is.
void leavePane(ViewerState& state, Pane pane);

/// Shows another scene, or the same one anew. The views stay as they are, and so do the options of the scene, except
/// those of its points, whose width is in the units of one file, and of a volume.
void openScene(ViewerState& state, const std::string& source);
/// The panes of what `source` is: a volume, or a mesh.
void showKindOf(ViewerState& state, const std::string& source);
/// The display shows what the transfer function and the clipping of a volume are now.
void displayFollowsVolume(ViewerState& state);
/// The surface of a volume at this value is the mesh that the other panes show; nothing: none is.
void chooseIso(ViewerState& state, std::optional<double> value);
/// By its name, or a file; a view cell that was set stays so, unless a file sets one. Of a volume also a constructor of
/// graph or curved ray cameras (VolumeShown::rays). Throws InputError as cameraChoice() does.
void chooseCamera(ViewerState& state, const std::string& nameOrFile);
/// After a change of parameters of `state.work.camera`, or of what is sliced for the display.
void cameraChanged(ViewerState& state);
void displayChanged(ViewerState& state);
/// The one that is `step` places further on in cameraNames(); those of a mesh alone are passed over.
void chooseNextCamera(ViewerState& state, int step);
void chooseCellSide(ViewerState& state, double sideRadii);
/// Throws InputError where the profile cannot be loaded.
void chooseProfile(ViewerState& state, const std::string& nameOrFile);
void chooseNextProfile(ViewerState& state);
void chooseImageSize(ViewerState& state, int width, int height);
/// Another reference view; the user's eye goes there.
void chooseReference(ViewerState& state, const View& view);
/// What the user's eye sees becomes the reference view.
void moveReferenceToEye(ViewerState& state);
inline constexpr double kMinCellSide = 0.01;
inline constexpr double kMaxCellSide = 18;
inline constexpr int kMinImageSide = 16;
inline constexpr int kMaxImageSide = 8192;

/// Turns, moves or zooms what a pane shows; `right` and `up` as the eye goes. Angles in radians, distances in heights
/// of the pane. In the image, both move it. The reconstruction, the effect and the lenses are seen by one eye, the
/// user's, and so is a volume; the transfer function's pane moves along the values.
void orbitPane(ViewerState& state, Pane pane, double right, double up);
void panPane(ViewerState& state, Pane pane, double right, double up);
/// Above 1 nearer.
void zoomPane(ViewerState& state, Pane pane, double factor);
/// Back to where it was when the viewer opened; the user's eye to the reference view, in the effect pane to its view.
void resetPane(ViewerState& state, Pane pane);

/// The scene pane from close by, or from afar again.
void toggleCloseUp(ViewerState& state);

/// Lets time pass: the screen of the display turns. `rotationsPerMinute` are those of the display.
void advance(ViewerState& state, double seconds, double rotationsPerMinute);
void changeSpeed(ViewerState& state, double factor);
/// Stops the screen so many slices further on, in the middle of one.
void stepDisplay(ViewerState& state, int slices);

/// The view of the display pane: its own, or that of the user's eye.
const View& displayView(const ViewerState& state);
/// Whether a blinking reconstruction shows the truth now.
bool blinkShowsTruth(const ViewerState& state);

}  // namespace ocelli
