// libFuzzer target: any bytes as messages of remote visualisation: as a request, as what a server says, as a piece of
// an image, and, a header up to the first line break and planes behind it, as an image.
#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/remote_plan.h"

namespace {

using namespace ocelli;

template <class Work>
void orRefused(const Work& work) {
  try {
    work();
  } catch (const InputError&) {
    // Any other exception is a finding.
  }
}

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

void readRequest(const std::string& text) {
  const RemoteRequest request = remoteRequestFromJson(text);
  const std::string written = jsonText(request);
  require(jsonText(remoteRequestFromJson(written)) == written);
  try {
    const RemotePlan plan = planRemoteImage(request, {});  // it validates the regions
    require(int64_t{plan.reference.width()} * plan.reference.height() <= kMaxCodedPixels);
  } catch (const InputError&) {
    std::abort();  // what was taken has an image
  }
}

void readServerMessage(const std::string& text) {
  const RemoteServerMessage message = remoteServerMessageFromJson(text);
  const std::string written = std::visit([](const auto& each) { return jsonText(each); }, message);
  const RemoteServerMessage again = remoteServerMessageFromJson(written);
  require(std::visit([](const auto& each) { return jsonText(each); }, again) == written);
}

void readPiece(std::span<const std::byte> bytes) {
  const std::vector<std::byte> written = messageOf(pieceOf(bytes));
  require(std::ranges::equal(written, bytes));
}

void readImage(const std::string& header, std::span<const std::byte> planes) {
  constexpr int kMaxFuzzedPixels = 1 << 14;  // larger ones are as slow as they are large
  const RemoteImageHeader promised = remoteImageHeaderFromJson(header);
  if (promised.size.x * promised.size.y > kMaxFuzzedPixels) {
    return;
  }
  const size_t colorBytes = std::min(promised.colorBytes, planes.size());
  const ReferenceImage image = decodeRemoteImage(header, planes.first(colorBytes), planes.subspan(colorBytes));
  require(image.width() == promised.size.x && image.height() == promised.size.y);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  orRefused([&] { readRequest(text); });
  orRefused([&] { readServerMessage(text); });
  orRefused([&] { readPiece(bytes); });
  const size_t line = std::min(text.find('\n'), size);
  orRefused([&] { readImage(text.substr(0, line), bytes.subspan(std::min(line + 1, size))); });
  return 0;
}
