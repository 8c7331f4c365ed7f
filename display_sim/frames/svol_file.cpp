#include "display_sim/frames/svol_file.h"

#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_writer.h"

namespace ocelli {

void writeSvol(const std::filesystem::path& path, const Volume& volume, const std::string& metadata) {
  SvolWriter writer(path, volume.profile(), {.metadata = metadata, .framesPerKey = 1});
  writer.append(volume, 0);
  writer.finish();
}

void requireFrame(const SvolReader& reader, size_t frame) {
  const size_t count = reader.frames().size();
  if (frame < count) {
    return;
  }
  if (reader.damage()) {
    throw *reader.damage();
  }
  const std::string has = count == 0   ? "no whole frame"
                          : count == 1 ? "frame 0 alone"
                                       : "frames 0 to " + std::to_string(count - 1);
  throw InputError("there is no frame " + std::to_string(frame) + ": the file has " + has, reader.where(),
                   count == 0 ? "write the file again, or give another one" : "give one of these");
}

Volume readFrame(SvolReader& reader, size_t frame) {
  requireFrame(reader, frame);
  SvolPlayer player(reader);
  player.seek(frame);
  return player.volume();
}

Volume readSvol(const std::filesystem::path& path, size_t frame) {
  SvolReader reader(path);
  return readFrame(reader, frame);
}

}  // namespace ocelli
