#include "oc_core/image_codecs/jpeg_codec.h"

#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <string>

// It takes FILE from whoever includes it.
#include <jpeglib.h>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/codec_error.h"

namespace ocelli {
namespace {

constexpr const char* kJpegName = "JPEG";
/// A progressive image of ours has about ten; each of a hostile one costs the time of the whole image.
constexpr int kMaxScans = 40;

/// libjpeg reports errors by a function that must not return: it jumps to where the work began. Nothing that stands
/// between has a destructor.
struct JumpingErrors {
  jpeg_error_mgr base;  ///< first: libjpeg knows this part alone
  std::jmp_buf start;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void jumpToStart(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JumpingErrors*>(jpeg->err);
  (*jpeg->err->format_message)(jpeg, errors->message);
  std::longjmp(errors->start, 1);
}

/// A warning of a decoder means damaged data; messages of a lower level, trace, are left out.
void refuseWarnings(j_common_ptr jpeg, int level) {
  if (level < 0) {
    jumpToStart(jpeg);
  }
}

void prepareErrors(JumpingErrors& errors) {
  jpeg_std_error(&errors.base);
  errors.base.error_exit = jumpToStart;
  errors.base.emit_message = refuseWarnings;
  errors.message[0] = '\0';
}

void refuseManyScans(j_common_ptr jpeg) {
  auto* decoder = reinterpret_cast<j_decompress_ptr>(jpeg);
  if (decoder->input_scan_number > kMaxScans) {
    auto* errors = reinterpret_cast<JumpingErrors*>(jpeg->err);
    std::snprintf(errors->message, sizeof errors->message, "it has more than %d scans", kMaxScans);
    std::longjmp(errors->start, 1);
  }
}

/// What the functions with a jump leave behind.
struct JpegBytes {
  unsigned char* data = nullptr;
  unsigned long size = 0;
  bool isDone = false;
};

void compressJpeg(const Rgb8* pixels, int width, int height, int quality, bool wholeChroma, JumpingErrors& errors,
                  JpegBytes& bytes) {
  jpeg_compress_struct jpeg{};
  jpeg.err = &errors.base;
  if (setjmp(errors.start) != 0) {
    jpeg_destroy_compress(&jpeg);
    return;
  }
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, &bytes.data, &bytes.size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  const int sampling = wholeChroma ? 1 : 2;
  jpeg.comp_info[0].h_samp_factor = sampling;
  jpeg.comp_info[0].v_samp_factor = sampling;
  jpeg.optimize_coding = TRUE;
  jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    // libjpeg reads from a pointer to what it could change.
    auto* row = reinterpret_cast<JSAMPROW>(
        const_cast<Rgb8*>(pixels + static_cast<size_t>(jpeg.next_scanline) * static_cast<size_t>(width)));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  bytes.isDone = true;
}

/// Returns whether all of it was read; otherwise errors.message says why not.
bool decompressJpeg(std::span<const std::byte> bytes, Image<Rgb8>& image, JumpingErrors& errors) {
  jpeg_decompress_struct jpeg{};
  jpeg_progress_mgr progress{};
  progress.progress_monitor = refuseManyScans;
  jpeg.err = &errors.base;
  if (setjmp(errors.start) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg_create_decompress(&jpeg);
  jpeg.progress = &progress;
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width != static_cast<JDIMENSION>(image.width()) ||
      jpeg.image_height != static_cast<JDIMENSION>(image.height())) {
    std::snprintf(errors.message, sizeof errors.message, "it is of %u x %u pixels, not %d x %d", jpeg.image_width,
                  jpeg.image_height, image.width(), image.height());
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg.out_color_space = JCS_RGB;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    auto* row = reinterpret_cast<JSAMPROW>(&image(0, static_cast<int>(jpeg.output_scanline)));
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return true;
}

}  // namespace

std::vector<std::byte> encodeJpeg(const Image<Rgb8>& image, double quality) {
  JumpingErrors errors{};
  prepareErrors(errors);
  JpegBytes jpeg;
  compressJpeg(image.data(), image.width(), image.height(), static_cast<int>(std::lround(quality)),
               quality >= kJpegWholeChroma, errors, jpeg);
  const auto* first = reinterpret_cast<const std::byte*>(jpeg.data);
  std::vector<std::byte> bytes(first, first + (jpeg.isDone ? jpeg.size : 0));
  std::free(jpeg.data);
  if (!jpeg.isDone) {
    throw WorkError(std::string("cannot make a JPEG of this image (") + errors.message + ")", "image",
                    "use a smaller one");
  }
  return bytes;
}

Image<Rgb8> decodeJpeg(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kJpegName, expectedSize);
  Image<Rgb8> image(expectedSize.x, expectedSize.y);
  JumpingErrors errors{};
  prepareErrors(errors);
  if (!decompressJpeg(bytes, image, errors)) {
    failDecoding(kJpegName, errors.message);
  }
  return image;
}

}  // namespace ocelli
