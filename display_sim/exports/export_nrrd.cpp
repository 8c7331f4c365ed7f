#include "display_sim/exports/export_nrrd.h"

#include <zlib.h>

#include <array>
#include <string>

#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

/// Compresses what it is given into a file, as one gzip member without a time stamp.
class GzipStream {
 public:
  explicit GzipStream(OutputFile& file) : file_(file) {
    constexpr int kGzip = 16;
    OC_CHECK(
        deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, kGzip + MAX_WBITS, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) == Z_OK,
        "zlib refused its settings");
  }
  ~GzipStream() { deflateEnd(&stream_); }
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  /// At most 4 GiB at once.
  void write(std::span<const uint8_t> bytes) {
    stream_.next_in = const_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    pump(Z_NO_FLUSH);
  }
  void finish() { pump(Z_FINISH); }

 private:
  void pump(int flush) {
    do {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      deflate(&stream_, flush);
      file_.write(std::span(buffer_).first(buffer_.size() - stream_.avail_out));
    } while (stream_.avail_out == 0);
  }

  OutputFile& file_;
  z_stream stream_{};
  std::array<uint8_t, 1 << 16> buffer_;
};

}  // namespace

void exportNrrd(const std::filesystem::path& path, const Volume& volume, const Progress& progress) {
  const DisplayProfile& profile = volume.profile();
  OutputFile file(path);
  file.write(
      "NRRD0005\n# An Ocelli volume: the lit voxels of a swept-screen display\ntype: uint8\ndimension: 4\nsizes: 3 " +
      std::to_string(profile.width) + " " + std::to_string(profile.height) + " " + std::to_string(volume.slices()) +
      "\nkinds: RGB-color domain domain domain\nlabels: \"rgb\" \"column\" \"row\" \"slice\"\nencoding: gzip\n"
      "ocelli_profile:=" +
      jsonText(profile) +
      "\nocelli_geometry:=position in display radii (x y z, y up) = (r cos t, h (1 - (row + 0.5) / (H/2)), r sin t), "
      "r = (column + 0.5 - W/2) / (W/2), t = slice pi / slices_per_half_turn, h = half_height_radii\n\n");
  GzipStream gzip(file);
  for (int i = 0; i < volume.slices(); ++i) {
    report(progress, "writing slices", static_cast<double>(i) / volume.slices());
    const Image<Rgb8> image = sliceImage(volume, i);
    gzip.write(std::span(reinterpret_cast<const uint8_t*>(image.data()), image.size() * sizeof(Rgb8)));
  }
  gzip.finish();
  file.commit();
  report(progress, "writing slices", 1);
}

}  // namespace ocelli
