#include "display_sim/viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <chrono>
#include <cmath>

#include "display_sim/viewer/effect_choice.h"
#include "display_sim/viewer/error_message.h"
#include "display_sim/viewer/lens_choice.h"
#include "display_sim/viewer/lens_file.h"
#include "display_sim/viewer/pane_overlays.h"
#include "display_sim/viewer/transfer_choice.h"
#include "display_sim/viewer/viewer_colors.h"
#include "display_sim/viewer/window_overlays.h"
#include "oc_core/base/error.h"
#include "oc_core/base/free_file_name.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

constexpr double kMessageSeconds = 5;
constexpr double kFrameSmoothing = 0.8;  // of the frame time that is shown

}  // namespace

Viewer::Viewer(GlContext& context, const ViewerOptions& options)
    : context_(context),
      options_(options),
      state_(viewerState(options.source, options.sceneOptions, options.camera, options.reference, options.width,
                         options.height, options.profile)),
      profile_(loadProfile(options.profile)),
      gui_(context, 1) {
  state_.work.volumeOptions = options.volumeOptions;
  state_.work.volumeIsShaded = options.volumeIsShaded;
  state_.volume.rays = options.volumeRays;
  const GlScope scope(context);
  drawing_ = std::make_unique<Drawing>(context);
  facts_.renderer = context.info().renderer;
  facts_.showTimes = options.showTimes;
  facts_.data = &data_;
  state_.effect = options.effect;
  if (options.effect.on) {
    openEffectPane(state_);
  }
  state_.effect.on = options.effect.on || !options.effect.rolesFile.empty() || sceneHasRoles(options.source);
  if (state_.effect.on) {
    if (options.reference == View{}) {
      eyeAtStart_ = state_.reconstruction.view;
    } else if (options.effect.on) {
      state_.reconstruction.view = options.reference;
    }
  }
  work_.want(state_.work);
}

Viewer::~Viewer() = default;

float Viewer::lengthScale() const {
  return static_cast<float>(window_.contentScale / window_.pixelsPerUnit);
}

ViewerLayout Viewer::layout() const {
  return viewerLayout(state_, {window_.width, window_.height}, lengthScale());
}

glm::ivec2 Viewer::pixelsOf(const WindowRect& rect) const {
  return glm::max(
      glm::ivec2(glm::round(glm::vec2(rect.width, rect.height) * static_cast<float>(window_.pixelsPerUnit))),
      glm::ivec2(1));
}

void Viewer::open(const std::string& source) {
  if (state_.work.sceneRevision == loadedRevision_) {
    effectBefore_ = state_.effect;
  }
  openScene(state_, source);
  closeEffectPane(state_);
  state_.effect = {};
  state_.effect.on = sceneHasRoles(source);
  state_.effectHome.reset();
  eyeAtStart_.reset();
}

void Viewer::chooseEffect(const std::string& effect, const std::string& way) {
  attempt([&] {
    ocelli::chooseEffect(state_, effect);
    chooseEffectWay(state_, way);
  });
}

const Image<Rgb8>& Viewer::effectPicture() const {
  const auto& picture = facts_.effect.picture;
  const Image<Rgb8>* shown = picture ? picture->shown(state_.effect.content) : nullptr;
  if (shown == nullptr) {
    throw InputError("the effect pane shows no picture", "the viewer",
                     facts_.effect.error.empty() ? "turn it on and wait until it is drawn" : facts_.effect.error);
  }
  return *shown;
}

const Image<Rgb8>& Viewer::lensPicture() const {
  const auto& picture = facts_.lenses.picture;
  if (!picture) {
    throw InputError("the lens pane shows no picture", "the viewer",
                     facts_.lenses.error.empty() ? "choose the camera \"gpc\" and show pane 6" : facts_.lenses.error);
  }
  return picture->image;
}

std::string Viewer::lensFile() const {
  if (!hasLenses(state_)) {
    throw InputError("camera \"" + state_.work.camera.name + "\" has no lenses", "the viewer",
                     "choose the camera \"gpc\"");
  }
  return lensFileText(state_.work.camera.gpc);
}

void Viewer::choose(const std::string& camera) {
  attempt([&] { chooseCamera(state_, camera); });
}

void Viewer::perform(ViewerAction action) {
  attempt([&] {
    if (applyAction(state_, action)) {
      return;
    }
    if (action == ViewerAction::kScreenshot) {
      wantsScreenshot_ = true;  // of the next frame
    } else if (action == ViewerAction::kSaveView) {
      saveView();
    } else if (action == ViewerAction::kSaveLenses) {
      saveLenses();
    } else if (action == ViewerAction::kSaveTransfer) {
      saveTransfer();
    } else if (action == ViewerAction::kTypeTransferNumbers) {
      if (state_.volume.transfer && state_.volume.transfer->chosen()) {
        state_.panel = true;
        panelHasKeys_ = true;
        panel_.focusPoint();
      }
    } else if (action == ViewerAction::kFocusPanel) {
      state_.panel = true;
      panelHasKeys_ = true;
      panel_.focus();
    } else if (action == ViewerAction::kQuit) {
      quit();
    }
  });
}

void Viewer::attempt(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    say(error.what(), true);
  }
}

void Viewer::say(const std::string& text, bool isError) {
  facts_.message = text;
  facts_.messageIsError = isError && !text.empty();
  messageSeconds_ = kMessageSeconds;
}

void Viewer::saveView() {
  const std::filesystem::path path = makeFreeFile(options_.folder, "ocelli-view", ".json");
  OutputFile file(path);
  file.write(jsonText(state_.reconstruction.view) + "\n");
  file.commit();
  say("wrote " + path.string() + ": give it to --view, or drop it here", false);
}

void Viewer::saveLenses() {
  const std::string text = lensFile();
  const std::filesystem::path path = makeFreeFile(options_.folder, "ocelli-lenses", ".json");
  OutputFile file(path);
  file.write(text);
  file.commit();
  say("wrote " + path.string() + ": give it to --camera, or drop it here", false);
}

void Viewer::saveScreenshot() {
  const std::filesystem::path path = makeFreeFile(options_.folder, "ocelli", ".png");
  writePng(path, screenshot());
  say("wrote " + path.string(), false);
}

void Viewer::take(const WorkResult& result) {
  if (result.error) {
    if (result.step == WorkStep::kScene && loadedRevision_ == 0) {
      std::rethrow_exception(result.error);
    }
    say(errorMessage(result.error), true);
    if (result.step == WorkStep::kScene) {  // what was there stays
      state_.work.source = loadedSource_;
      state_.work.sceneOptions.points = loadedPoints_;
      state_.work.sceneOptions.labels = loadedLabels_;
      state_.work.sceneOptions.iso = loadedIso_;
      state_.work.volumeOptions = loadedVolumeOptions_;
      state_.work.sceneOptions.transfer = loadedVolumeOptions_.transfer;
      state_.work.sceneRevision = loadedRevision_;
      state_.work.volumeRevision = loadedVolumeRevision_;
      state_.work.volumeIsShaded = loadedVolumeIsShaded_;
      state_.effect = effectBefore_;
      showKindOf(state_, loadedSource_);
    }
  }
  try {
    data_.take(context_, result);
  } catch (const GlError& error) {
    say(error.what(), true);
  }
  if (result.scene) {
    loadedSource_ = result.scene->source;
    loadedPoints_ = result.scene->points;
    loadedLabels_ = result.scene->labels;
    loadedRevision_ = result.scene->revision;
    loadedIso_ = result.scene->iso;
    loadedVolumeRevision_ = result.scene->volumeRevision;
    loadedVolumeIsShaded_ = result.scene->volumeIsShaded;
    loadedVolumeOptions_ = result.scene->volumeOptions;
    if (result.scene->volume != loadedVolume_) {
      loadedVolume_ = result.scene->volume;
      if (loadedVolume_) {
        takeVolume(state_, *loadedVolume_);
      } else {
        state_.volume.transfer.reset();
      }
    }
  }
}

void Viewer::update(double seconds) {
  const GlScope scope(context_);
  if (profileName_ != state_.work.profile) {
    profileName_ = state_.work.profile;
    profile_ = loadProfile(profileName_);
  }
  advance(state_, seconds, profile_.rotationsPerMinute);
  secondsOfFrame_ += seconds;
  if (!facts_.messageIsError && (messageSeconds_ -= seconds) <= 0) {
    facts_.message.clear();
  }
  if (!lensPointer_.isDragging()) {  // which what the others build would slow down
    followLenses(state_, false);
  }
  if (layout().find(Pane::kDisplay) != nullptr) {
    displayFollowsVolume(state_);
  }
  work_.want(state_.work);
  while (const std::optional<WorkResult> result = work_.take()) {
    take(*result);
  }
  work_.want(state_.work);  // what failed may have been taken back
  facts_.work = work_.status();
  takeEffect();
  lenses_.want(lensWanted());
  facts_.lenses = lenses_.status();
  volumes_.want(volumeWanted());
  facts_.volume = volumes_.status();
  if (data_.camera && static_cast<size_t>(state_.reference.image) >= data_.camera->representation.images.size()) {
    state_.reference.image = 0;
  }
}

EffectWanted Viewer::effectWanted() const {
  EffectWanted wanted;
  if (state_.work.sceneRevision != loadedRevision_) {  // what there is stays until another scene has come
    wanted = lastWanted_;
    wanted.shows = false;
    return wanted;
  }
  const ViewerLayout where = layout();
  const PaneLayout* pane = where.find(Pane::kEffect);
  wanted.on = state_.effect.on;
  if (!wanted.on) {
    return wanted;
  }
  wanted.shows = pane != nullptr && window_.width > 0;
  wanted.source = loadedSource_;
  wanted.sceneOptions = state_.work.sceneOptions;
  wanted.sceneRevision = loadedRevision_;
  wanted.rolesFile = state_.effect.rolesFile;
  wanted.rolesRead = state_.effect.rolesRead;
  wanted.effect = state_.effect.effect;
  wanted.way = chosenWay(state_);
  const glm::ivec2 size(state_.work.width, state_.work.height);
  wanted.referenceSize = size == glm::ivec2(kDefaultWidth, kDefaultHeight) ? glm::ivec2(0) : size;
  wanted.environmentHeight = options_.environmentHeight;
  wanted.view = state_.reconstruction.view;
  wanted.size = pane != nullptr ? picturePlace(state_, pixelsOf(pane->image)).size : glm::ivec2(1);
  wanted.content = state_.effect.content;
  return wanted;
}

void Viewer::wantEffect() {
  lastWanted_ = effectWanted();
  effects_.want(lastWanted_);
  facts_.effect = effects_.status();
}

void Viewer::takeEffect() {
  wantEffect();
  const EffectStatus& status = facts_.effect;
  if (!lastWanted_.on || status.sceneRevision != state_.work.sceneRevision) {
    return;
  }
  if (state_.effect.effect.empty()) {
    state_.effect.effect = status.effect;
  }
  if (status.home && status.effect == state_.effect.effect) {
    if (eyeAtStart_ && *eyeAtStart_ == state_.reconstruction.view) {
      state_.reconstruction.view = *status.home;
    }
    eyeAtStart_.reset();
    state_.effectHome = status.home;
  }
  wantEffect();  // what has come to be known changes it
}

LensWanted Viewer::lensWanted() const {
  LensWanted wanted;
  const ViewerLayout where = layout();
  const PaneLayout* pane = where.find(Pane::kLenses);
  wanted.shows = pane != nullptr && window_.width > 0 && data_.scene;
  if (!wanted.shows) {
    return wanted;
  }
  wanted.scene = data_.scene;
  wanted.view = state_.reconstruction.view;
  wanted.size = picturePlace(state_, pixelsOf(pane->image)).size;
  wanted.layout = state_.work.camera.gpc;
  wanted.method = state_.lenses.method;
  wanted.rates = state_.lenses.rates;
  return wanted;
}

void Viewer::waitUntilMade() {
  followLenses(state_, true);
  if (layout().find(Pane::kDisplay) != nullptr) {
    displayFollowsVolume(state_);
  }
  work_.want(state_.work);
  work_.waitUntilIdle();
  effects_.waitUntilIdle();
  lenses_.waitUntilIdle();
  volumes_.waitUntilIdle();
}

void Viewer::waitForPictures() {
  do {
    effects_.waitUntilIdle();
    lenses_.waitUntilIdle();
    volumes_.waitUntilIdle();
    update(0);
  } while (isDrawing());
}

bool Viewer::isMoving() const {
  const ViewerLayout where = layout();
  const bool blinks = state_.reconstruction.content == ReconstructionShown::Content::kBlink &&
                      where.find(Pane::kReconstruction) != nullptr;
  const bool turns = state_.display.running && data_.volume && where.find(Pane::kDisplay) != nullptr &&
                     !looksSteady(state_.display, data_.volume->volume.profile());
  return facts_.work.busy || state_.lenses.changedAt || turns || blinks || isSettling() || wantsScreenshot_ ||
         (!facts_.message.empty() && !facts_.messageIsError);
}

bool Viewer::isSettling() const {
  const bool measures = drawing_->reconstruction.wantsToMeasure() && layout().find(Pane::kReconstruction) != nullptr;
  return hasWaitingEvents() || measures;
}

void Viewer::pickPixel() {
  facts_.picked.reset();
  const ViewerLayout where = layout();
  const PaneLayout* pane = gui_.wantsPointer() ? nullptr : where.paneAt(pointer_);
  const ReferenceImage* image = shownImage(state_, data_);
  if (pane == nullptr || pane->pane != Pane::kReference || image == nullptr) {
    return;
  }
  const glm::ivec2 size(image->width(), image->height());
  const ImagePlacement placement = placeImage(state_.reference, size, pixelsOf(pane->image));
  const glm::vec2 at = (pointer_ - glm::vec2(pane->image.x, pane->image.y)) * static_cast<float>(window_.pixelsPerUnit);
  if (const auto pixel = pixelAt(placement, size, at)) {
    facts_.picked = PickedPixel{state_.reference.image, *pixel};
  }
}

bool Viewer::drawAnew(const PaneLayout& pane) {
  const auto lineScale = static_cast<float>(window_.contentScale);
  const glm::ivec2 size = pixelsOf(pane.image);
  switch (pane.pane) {
    case Pane::kScene:
      return drawing_->scene.draw(state_, data_, facts_.picked, size, lineScale, drawing_->meshes);
    case Pane::kReference:
      return drawing_->reference.draw(
          state_, data_, facts_.picked ? std::optional(facts_.picked->pixel) : std::optional<glm::ivec2>(), size);
    case Pane::kReconstruction:
      return drawing_->reconstruction.draw(state_, data_, size, drawing_->meshes);
    case Pane::kDisplay:
      return drawing_->display.draw(state_, data_, size, lineScale);
    case Pane::kEffect:
      return drawing_->effect.draw(state_, facts_.effect, size);
    case Pane::kLenses:
      return drawing_->lenses.draw(state_, facts_.lenses, size);
    case Pane::kVolume:
      return drawing_->volume.draw(state_, facts_.volume, size);
    case Pane::kTransfer:
      drawing_->transfer.begin(size.x, size.y, rgb(kPaneColor));
      return true;
  }
  OC_CHECK(false, "every pane is drawn");
}

void Viewer::drawPane(const PaneLayout& pane) {
  std::string& failure = facts_.failures[static_cast<size_t>(pane.pane)];
  try {
    if (drawAnew(pane)) {
      failure.clear();
    }
  } catch (const GlError& error) {
    if (error.reason().find("context is lost") != std::string::npos) {
      throw;  // nothing can be drawn any more
    }
    failure = error.what();
  } catch (const InputError& error) {  // the GPU does not take this display
    failure = error.what();
  }
}

void Viewer::drawPanes() {
  pickPixel();
  const ViewerLayout where = layout();
  const glm::ivec2 windowPixels =
      pixelsOf({0, 0, static_cast<float>(window_.width), static_cast<float>(window_.height)});
  for (const PaneLayout& pane : where.panes) {
    drawPane(pane);
  }
  drawing_->image.begin(windowPixels.x, windowPixels.y, rgb(kGuiBackground));
  for (const PaneLayout& pane : where.panes) {
    if (!facts_.failures[static_cast<size_t>(pane.pane)].empty()) {
      continue;
    }
    const PaneTarget& target = drawing_->targetOf(pane.pane);
    const auto x = static_cast<GLint>(std::lround(pane.image.x * window_.pixelsPerUnit));
    const auto y = static_cast<GLint>(std::lround(pane.image.y * window_.pixelsPerUnit));
    context_.gl().BlitNamedFramebuffer(target.framebuffer().id(), drawing_->image.framebuffer().id(), 0, 0,
                                       target.width(), target.height(), x, y, x + target.width(), y + target.height(),
                                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  context_.check("composing the window");
  facts_.missing = drawing_->reconstruction.missing(state_, data_);
  facts_.straightRays = drawing_->scene.shownLines().straightRays;
  facts_.bentRays = drawing_->scene.shownLines().bentRays;
  facts_.scale = drawing_->reference.scale();
  facts_.displayProblem = drawing_->display.problem();
}

const PaneTarget& Viewer::Drawing::targetOf(Pane pane) const {
  switch (pane) {
    case Pane::kScene:
      return scene.target();
    case Pane::kReference:
      return reference.target();
    case Pane::kReconstruction:
      return reconstruction.target();
    case Pane::kDisplay:
      return display.target();
    case Pane::kEffect:
      return effect.target();
    case Pane::kLenses:
      return lenses.target();
    case Pane::kVolume:
      return volume.target();
    case Pane::kTransfer:
      return transfer;
  }
  OC_CHECK(false, "every pane has its image");
}

void Viewer::drawGui() {
  context_.gl().BindFramebuffer(GL_FRAMEBUFFER, drawing_->image.framebuffer().id());
  gui_.beginFrame(secondsOfFrame_);
  secondsOfFrame_ = 0;
  if (leavesPanel_) {
    ImGui::SetWindowFocus(nullptr);
    leavesPanel_ = false;
  }
  const ViewerLayout where = layout();
  PanelWishes wishes;
  const PanelDrawing drawing{state_, facts_, where, lengthScale(), wishes};
  attempt([&] { panel_.draw(drawing); });
  drawPaneOverlays(drawing);
  drawStatusBar(drawing);
  drawHelp(drawing);
  drawMessage(drawing);
  gui_.endFrame();
  for (const ViewerAction action : wishes.actions) {
    perform(action);
  }
  if (!wishes.open.empty()) {
    open(wishes.open);
  }
  if (!wishes.camera.empty()) {
    choose(wishes.camera);
  }
  if (!wishes.transfer.empty()) {
    chooseTransfer(wishes.transfer);
  }
  if (wishes.changesIso) {
    chooseIso(wishes.iso);
  }
  if (wishes.dismissMessage) {
    say("", false);
  }
}

Image<Rgb8> Viewer::screenshot() const {
  const GlScope scope(context_);
  return drawing_->image.read();
}

void Viewer::draw() {
  const auto start = std::chrono::steady_clock::now();
  const GlScope scope(context_);
  drawPanes();
  drawGui();
  if (options_.showTimes) {
    context_.gl().Finish();
    const double milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    facts_.frameMilliseconds = facts_.frameMilliseconds > 0
                                   ? kFrameSmoothing * facts_.frameMilliseconds + (1 - kFrameSmoothing) * milliseconds
                                   : milliseconds;
  }
  if (wantsScreenshot_) {
    wantsScreenshot_ = false;
    attempt([&] { saveScreenshot(); });
  }
}

}  // namespace ocelli
