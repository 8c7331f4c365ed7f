// The viewer: linked panes of a scene, its reference camera, what stands for the scene, and the simulated display. It
// takes input events and draws an image of a window; it knows neither windows nor scripts.
//
//   Viewer viewer(context, options);
//   viewer.handle(event);            // as they come; a ResizeEvent first
//   viewer.update(secondsSinceLast);
//   viewer.draw();                   // to image()
#pragma once

#include <filesystem>
#include <functional>

#include "display_sim/viewer/display_pane.h"
#include "display_sim/viewer/effect_pane.h"
#include "display_sim/viewer/lens_overlays.h"
#include "display_sim/viewer/lens_pane.h"
#include "display_sim/viewer/reconstruction_pane.h"
#include "display_sim/viewer/reference_pane.h"
#include "display_sim/viewer/scene_pane.h"
#include "display_sim/viewer/side_panel.h"
#include "display_sim/viewer/transfer_pointer.h"
#include "display_sim/viewer/volume_work.h"
#include "oc_core/window/gui_layer.h"

namespace ocelli {

struct ViewerOptions {
  std::string source;
  SceneOptions sceneOptions;
  VolumeSceneOptions volumeOptions = {};    ///< of a scene that is a volume, beside those of every scene
  std::optional<bool> volumeIsShaded = {};  ///< nothing: as its transfer function says
  std::string volumeRays = {};              ///< as VolumeShown::rays
  CameraChoice camera;
  View reference;
  int width = kDefaultWidth;  ///< of the reference image
  int height = kDefaultHeight;
  std::string profile = "perspecta";
  std::filesystem::path folder = ".";  ///< where images and views are saved
  bool showTimes = true;               ///< figures that differ from run to run
  /// Where it is on, the viewer starts in the effect pane. It is among the others where something says the roles of the
  /// scene's objects. Its names are those of oc_core/shade/effects.h.
  EffectShown effect = {};
  int environmentHeight = 1024;  ///< rows of the environment maps of effects: as `ocelli shade` has them
};

class Viewer {
 public:
  Viewer(GlContext& context, const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void handle(const InputEvent& event);
  /// Takes over what has been made meanwhile, and lets time pass. Throws InputError where the first scene cannot be
  /// loaded: there is nothing to view then. All other errors are messages in the window.
  void update(double seconds);
  /// What OpenGL has no room for is told in its pane. Throws GlError where nothing can be drawn at all.
  void draw();

  /// What was drawn last.
  const PaneTarget& image() const { return drawing_->image; }
  Image<Rgb8> screenshot() const;
  const ViewerState& state() const { return state_; }
  const ViewerFacts& facts() const { return facts_; }
  /// Asked to by a key or a CloseEvent.
  bool wantsClose() const { return wantsClose_; }
  /// Whether another frame would look different: something moves, waits or is being made. A picture of the effect may
  /// come at any time while facts().effect is busy, and so may one of lenses or of a volume.
  bool isMoving() const;
  /// Whether events still wait for a frame.
  bool hasWaitingEvents() const { return gui_.hasWaitingEvents(); }
  /// Whether the next frame would tell more, though nothing moves.
  bool isSettling() const;
  /// Until nothing is being made any more. Update and draw afterwards.
  void waitUntilMade();
  /// Until the pictures of the effect, of the lenses and of the volume are whole, where their panes show. Draw
  /// afterwards.
  void waitForPictures();
  /// Whether pictures of the effect, of the lenses or of the volume are being drawn.
  bool isDrawing() const { return facts_.effect.busy || facts_.lenses.busy || facts_.volume.busy; }
  /// Whether something is being made.
  bool isMaking() const { return facts_.work.busy || isDrawing() || state_.lenses.changedAt; }

  /// As if these had been asked for in the window.
  void open(const std::string& source);
  void choose(const std::string& camera);
  /// Opens the effect pane; `way` may be empty, for the camera.
  void chooseEffect(const std::string& effect, const std::string& way);
  void chooseEffectContent(EffectShown::Content content) { state_.effect.content = content; }
  /// A preset of a transfer function, or a file.
  void chooseTransfer(const std::string& nameOrFile);
  /// The surface of a volume that the panes of meshes show.
  void chooseIso(std::optional<double> value);

  /// What the effect pane shows, as large as there, without texts over it. Throws InputError where it shows nothing.
  const Image<Rgb8>& effectPicture() const;
  /// The same of the lens pane, without outlines.
  const Image<Rgb8>& lensPicture() const;
  /// The camera file of its lenses. Throws InputError where there are none.
  std::string lensFile() const;
  /// What the volume pane shows, as large as there, without texts over it. Throws InputError where it shows nothing.
  const Image<Rgb8>& volumePicture() const;
  /// The file of the transfer function, which counts as saved then. Throws InputError where the scene is no volume.
  void saveTransferTo(const std::filesystem::path& path);

 private:
  /// What draws, made under one GlScope.
  struct Drawing {
    explicit Drawing(GlContext& context)
        : meshes(context),
          scene(context),
          reference(context),
          reconstruction(context),
          display(context),
          effect(context),
          lenses(context),
          volume(context),
          transfer(context),
          image(context) {}

    const PaneTarget& targetOf(Pane pane) const;

    MeshDraw meshes;
    ScenePane scene;
    ReferencePane reference;
    ReconstructionPane reconstruction;
    DisplayPane display;
    EffectPane effect;
    LensPane lenses;
    VolumePane volume;
    PaneTarget transfer;  ///< empty: panels draw over it
    PaneTarget image;
  };
  struct Drag {
    Pane pane = Pane::kScene;
    bool turns = true;
  };

  void handleKey(const KeyEvent& event);
  void handleButton(const PointerButtonEvent& event);
  void leavePanel();
  void handleMove(const glm::vec2& to);
  void handleScroll(const ScrollEvent& event);
  void openDropped(const std::string& file);
  void perform(ViewerAction action);
  /// Runs `body`, and shows its error as a message.
  void attempt(const std::function<void()>& body);
  void say(const std::string& text, bool isError);
  void take(const WorkResult& result);
  EffectWanted effectWanted() const;
  void wantEffect();
  void takeEffect();
  LensWanted lensWanted() const;
  VolumeWanted volumeWanted() const;
  void saveLenses();
  void saveTransfer();
  void quit();
  void saveScreenshot();
  void saveView();
  void pickPixel();
  /// Whether there was something to draw.
  bool drawAnew(const PaneLayout& pane);
  /// The same; where OpenGL cannot do it, that is shown in the pane and the others go on. Throws GlError where the
  /// context is lost.
  void drawPane(const PaneLayout& pane);
  void drawPanes();
  void drawGui();
  ViewerLayout layout() const;
  float lengthScale() const;
  glm::ivec2 pixelsOf(const WindowRect& rect) const;

  GlContext& context_;
  ViewerOptions options_;
  ViewerState state_;
  std::string profileName_;  ///< of `profile_`
  DisplayProfile profile_;
  BackgroundWork work_;
  EffectWork effects_;
  LensWork lenses_;
  VolumeWork volumes_;
  LensPointer lensPointer_;
  TransferPointer transferPointer_;
  EffectWanted lastWanted_;
  EffectShown effectBefore_;        ///< while another scene is being loaded
  std::optional<View> eyeAtStart_;  ///< which goes to the view of the effect, unless it has moved
  ViewerData data_;
  GuiLayer gui_;
  SidePanel panel_;
  std::unique_ptr<Drawing> drawing_;
  ViewerFacts facts_;
  uint64_t loadedRevision_ = 0;  ///< of the scene that shows; 0: none yet
  std::string loadedSource_;
  PointSceneOptions loadedPoints_;  ///< of that scene
  LabelOptions loadedLabels_;
  std::shared_ptr<const LoadedVolume> loadedVolume_;  ///< that the transfer function is of; null: none
  VolumeSceneOptions loadedVolumeOptions_;
  std::optional<double> loadedIso_;
  uint64_t loadedVolumeRevision_ = 0;
  std::optional<bool> loadedVolumeIsShaded_;
  bool panelHasKeys_ = false;  ///< after F6
  bool leavesPanel_ = false;   ///< in the next frame
  ResizeEvent window_;
  glm::vec2 pointer_{-1};
  std::optional<Drag> drag_;
  double secondsOfFrame_ = 0;
  double messageSeconds_ = 0;  ///< left to show it; errors stay
  bool wantsScreenshot_ = false;
  bool wantsClose_ = false;
};

}  // namespace ocelli
