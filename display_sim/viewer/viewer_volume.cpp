// What the viewer does with volumes and their transfer functions.
#include "display_sim/viewer/transfer_choice.h"
#include "display_sim/viewer/viewer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/free_file_name.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

const Image<Rgb8>& Viewer::volumePicture() const {
  const auto& picture = facts_.volume.picture;
  if (!picture) {
    throw InputError("the volume pane shows no picture", "the viewer",
                     facts_.volume.error.empty() ? "open a volume and show pane 7" : facts_.volume.error);
  }
  return picture->image;
}

void Viewer::saveTransferTo(const std::filesystem::path& path) {
  OutputFile file(path);
  file.write(transferFileText(state_));
  file.commit();
  state_.volume.transfer->markSaved();
}

void Viewer::chooseTransfer(const std::string& nameOrFile) {
  attempt([&] { ocelli::chooseTransfer(state_, loadedVolume_.get(), nameOrFile); });
}

void Viewer::chooseIso(std::optional<double> value) {
  ocelli::chooseIso(state_, value);
}

void Viewer::saveTransfer() {
  const std::string text = transferFileText(state_);  // throws where there is none, before a file is made
  const std::filesystem::path path = makeFreeFile(options_.folder, "ocelli-transfer", ".json");
  saveTransferTo(path);
  say("wrote " + path.string() + ": give it to --transfer, or drop it here", false);
}

VolumeWanted Viewer::volumeWanted() const {
  VolumeWanted wanted;
  const ViewerLayout where = layout();
  const PaneLayout* pane = where.find(Pane::kVolume);
  wanted.shows = pane != nullptr && window_.width > 0 && data_.scene && data_.scene->volume && state_.volume.transfer;
  if (!wanted.shows) {
    return wanted;
  }
  wanted.scene = data_.scene;
  wanted.view = state_.reconstruction.view;
  wanted.size = picturePlace(state_, pixelsOf(pane->image)).size;
  wanted.camera = state_.work.camera;
  wanted.cameraRevision = state_.work.cameraRevision;
  wanted.appearance = state_.volume.transfer->appearance();
  wanted.rays = state_.volume.rays;
  wanted.kept = state_.volume.kept;
  return wanted;
}

void Viewer::quit() {
  if (!state_.volume.transfer || !state_.volume.transfer->warnsOfLoss()) {
    wantsClose_ = true;
    return;
  }
  say("the transfer function is not saved: Ctrl + S saves it; close once more to lose it", false);
}

}  // namespace ocelli
