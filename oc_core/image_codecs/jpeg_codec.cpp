#include "oc_core/image_codecs/jpeg_codec.h"

#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

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

/// Where the bytes of a JPEG go: jpeg_mem_dest() would leave a pointer to what it has freed when memory runs out.
struct GrowingOutput {
  jpeg_destination_mgr base;  ///< first: libjpeg knows this part alone
  std::vector<std::byte>* bytes;
};

/// Without memory it does not return, but jumps as errors of libjpeg do.
void growTo(j_compress_ptr jpeg, size_t size) {
  std::vector<std::byte>& bytes = *reinterpret_cast<GrowingOutput*>(jpeg->dest)->bytes;
  const size_t used = bytes.size();
  bool isGrown = true;
  try {
    bytes.resize(size);
  } catch (const std::exception&) {  // bad_alloc or length_error; the jump must not start in here
    isGrown = false;
  }
  if (!isGrown) {
    auto* errors = reinterpret_cast<JumpingErrors*>(jpeg->err);
    std::snprintf(errors->message, sizeof errors->message, "there is no memory for %zu bytes of it", size);
    std::longjmp(errors->start, 1);
  }
  jpeg->dest->next_output_byte = reinterpret_cast<JOCTET*>(bytes.data() + used);
  jpeg->dest->free_in_buffer = size - used;
}

void beginOutput(j_compress_ptr jpeg) {
  constexpr size_t kFirstBytes = size_t{1} << 14;
  growTo(jpeg, kFirstBytes);
}

boolean continueOutput(j_compress_ptr jpeg) {
  growTo(jpeg, 2 * reinterpret_cast<GrowingOutput*>(jpeg->dest)->bytes->size());
  return TRUE;
}

void endOutput(j_compress_ptr jpeg) {
  std::vector<std::byte>& bytes = *reinterpret_cast<GrowingOutput*>(jpeg->dest)->bytes;
  bytes.resize(bytes.size() - jpeg->dest->free_in_buffer);
}

struct JpegForm {
  int quality;
  bool wholeChroma;
  bool isProgressive;
};

/// Fills `bytes`, which are empty. Returns whether it could; otherwise errors.message says why not.
bool compressJpeg(const Rgb8* pixels, int width, int height, const JpegForm& form, JumpingErrors& errors,
                  std::vector<std::byte>& bytes) {
  jpeg_compress_struct jpeg{};
  GrowingOutput output{};
  jpeg.err = &errors.base;
  if (setjmp(errors.start) != 0) {
    jpeg_destroy_compress(&jpeg);
    return false;
  }
  jpeg_create_compress(&jpeg);
  output.base.init_destination = beginOutput;
  output.base.empty_output_buffer = continueOutput;
  output.base.term_destination = endOutput;
  output.bytes = &bytes;
  jpeg.dest = &output.base;
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, form.quality, TRUE);
  const int sampling = form.wholeChroma ? 1 : 2;
  jpeg.comp_info[0].h_samp_factor = sampling;
  jpeg.comp_info[0].v_samp_factor = sampling;
  jpeg.optimize_coding = TRUE;
  if (form.isProgressive) {
    jpeg_simple_progression(&jpeg);
  }
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    // libjpeg reads from a pointer to what it could change.
    auto* row = reinterpret_cast<JSAMPROW>(
        const_cast<Rgb8*>(pixels + static_cast<size_t>(jpeg.next_scanline) * static_cast<size_t>(width)));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  return true;
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

std::vector<std::byte> encodedJpeg(const Image<Rgb8>& image, double quality, bool isProgressive) {
  JumpingErrors errors{};
  prepareErrors(errors);
  std::vector<std::byte> bytes;
  const JpegForm form{static_cast<int>(std::lround(quality)), quality >= kJpegWholeChroma, isProgressive};
  if (!compressJpeg(image.data(), image.width(), image.height(), form, errors, bytes)) {
    throw WorkError(std::string("cannot make a JPEG of this image (") + errors.message + ")", "image",
                    "use a smaller one");
  }
  return bytes;
}

}  // namespace

std::vector<std::byte> encodeJpeg(const Image<Rgb8>& image, double quality) {
  return encodedJpeg(image, quality, true);
}

std::vector<std::byte> encodeBaselineJpeg(const Image<Rgb8>& image, double quality) {
  return encodedJpeg(image, quality, false);
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
