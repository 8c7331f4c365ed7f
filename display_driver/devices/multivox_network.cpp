#include "display_driver/devices/multivox_network.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

constexpr std::chrono::milliseconds kConnectTime{3000};
constexpr std::chrono::milliseconds kFirstPause{100};
constexpr std::chrono::milliseconds kLongestPause{2000};
constexpr std::string_view kBits = "bits=";
constexpr size_t kHeadBytes = 8;

[[noreturn]] void refusePlace(const std::string& text, const std::string& what) {
  throw InputError(what, "multivox:" + text, "as in multivox:vortex.local, multivox:192.168.0.7:22104,bits=3");
}

int bitsFromText(std::string_view option, const std::string& text) {
  const std::optional<int> bits =
      option.starts_with(kBits) ? numberFromText<int>(option.substr(kBits.size())) : std::nullopt;
  if (!bits || *bits < 1 || *bits > kMaxShownBits) {
    refusePlace(text, "after the comma stands bits=1, bits=2 or bits=3");
  }
  return *bits;
}

HostPort hostFromText(const std::string& text, const std::string& whole) {
  HostPort place{text, kMultivoxPort};
  const size_t bracket = text.starts_with('[') ? text.find(']') : std::string::npos;
  if (text.starts_with('[') && bracket == std::string::npos) {
    refusePlace(whole, "an address that begins with a bracket ends with one");
  }
  if (text.starts_with(':')) {
    refusePlace(whole, "the host is missing");
  }
  const size_t colon = text.find(':', bracket == std::string::npos ? 0 : bracket);
  if (bracket == std::string::npos && text.rfind(':') != colon) {
    refusePlace(whole, "an address of IPv6 stands in brackets");
  }
  if (colon != std::string::npos && colon + 1 < text.size()) {
    const std::optional<HostPort> given = hostPortFromText(text);
    if (!given) {
      refusePlace(whole, "a port is a number from 1 to 65535");
    }
    place = *given;
  }
  place.host = place.host.substr(0, place.host.find(':', bracket == std::string::npos ? 0 : bracket));
  if (bracket != std::string::npos) {
    if (place.host.size() != bracket + 1) {
      refusePlace(whole, "a colon and a port follow the bracket");
    }
    place.host = place.host.substr(1, bracket - 1);
  }
  if (place.host.empty()) {
    refusePlace(whole, "the host is missing");
  }
  return place;
}

std::vector<uint8_t> litCells(std::span<const uint8_t> cells, const VoxelGrid& grid) {
  std::vector<uint8_t> lit;
  for (int y = 0; y < grid.y; ++y) {
    for (int x = 0; x < grid.x; ++x) {
      for (int z = 0; z < grid.z; ++z) {
        if (const uint8_t color = cells[grid.index(x, y, z)]; color != 0) {
          for (const int value : {x, y, z, static_cast<int>(color)}) {
            lit.push_back(static_cast<uint8_t>(value));
          }
        }
      }
    }
  }
  if (lit.empty()) {
    lit.assign(4, 0);
  }
  return lit;
}

}  // namespace

std::optional<MultivoxPlace> multivoxPlace(const std::string& text) {
  if (text.starts_with('/') || text.find_first_of(".:[") == std::string::npos) {
    return std::nullopt;
  }
  MultivoxPlace place;
  place.text = text;
  const size_t comma = text.find(',');
  if (comma != std::string::npos) {
    place.bitsPerChannel = bitsFromText(std::string_view(text).substr(comma + 1), text);
  }
  place.host = hostFromText(text.substr(0, comma), text);
  return place;
}

std::vector<uint8_t> multivoxMessage(std::span<const uint8_t> cells, const VoxelGrid& grid) {
  OC_CHECK(cells.size() == grid.cells() && std::max({grid.x, grid.y, grid.z}) <= 256, "cells of another grid");
  std::vector<uint8_t> lit = litCells(cells, grid);
  constexpr int kGzip = 16;
  z_stream stream{};
  OC_CHECK(
      deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzip + MAX_WBITS, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) == Z_OK,
      "zlib refused its settings");
  std::vector<uint8_t> message(kHeadBytes + deflateBound(&stream, static_cast<uLong>(lit.size())));
  stream.next_in = lit.data();
  stream.avail_in = static_cast<uInt>(lit.size());
  stream.next_out = message.data() + kHeadBytes;
  stream.avail_out = static_cast<uInt>(message.size() - kHeadBytes);
  const int ended = deflate(&stream, Z_FINISH);
  const auto length = static_cast<uint32_t>(stream.total_out);
  deflateEnd(&stream);
  OC_CHECK(ended == Z_STREAM_END, "zlib refused a buffer of the size that it asked for");
  message.resize(kHeadBytes + length);
  std::fill_n(message.begin(), 4, uint8_t{0xff});
  for (size_t i = 0; i < 4; ++i) {
    message[4 + i] = static_cast<uint8_t>(length >> (8 * (3 - i)) & 0xff);
  }
  return message;
}

MultivoxNetwork::MultivoxNetwork(const MultivoxPlace& place, const VoxelGrid& grid, std::chrono::milliseconds stall)
    : place_(place), grid_(grid), stream_(place.host, "multivox:" + place.text, stall), pause_(kFirstPause) {
  if (!stream_.connect(kConnectTime)) {
    throw WorkError(
        stream_.problem(), "multivox:" + place.text,
        "start the display's receiver, as in python3 pointvision.py of the multivox project, and check that "
        "its machine lets connections to this port in");
  }
}

std::string MultivoxNetwork::link() const {
  return fmt::format("TCP to {}, port {}", place_.host.host, place_.host.port);
}

MultivoxTarget::Found MultivoxNetwork::look() {
  if (stream_.isOpen() && stream_.look()) {
    return std::exchange(isNew_, false) ? Found::kNew : Found::kSame;
  }
  if (std::exchange(wasOpen_, false)) {  // first what happened is told, then a new connection is tried
    nextTry_ = Clock::now() + pause_;
  }
  if (Clock::now() < nextTry_) {
    return Found::kNothing;
  }
  if (!stream_.connect(kConnectTime)) {
    nextTry_ = Clock::now() + pause_;
    pause_ = std::min(2 * pause_, kLongestPause);
    return Found::kNothing;
  }
  pause_ = kFirstPause;
  wasOpen_ = true;
  isNew_ = false;
  return Found::kNew;
}

std::optional<MultivoxStatus> MultivoxNetwork::status() const {
  return stream_.isOpen() ? std::optional(MultivoxStatus{.bitsPerChannel = place_.bitsPerChannel}) : std::nullopt;
}

bool MultivoxNetwork::write(std::span<const uint8_t> cells) {
  message_ = multivoxMessage(cells, grid_);
  return stream_.isOpen();
}

bool MultivoxNetwork::show() {
  const bool isShown = stream_.send(message_);
  rested_ = Clock::now() + kMinRest;
  return isShown;
}

}  // namespace ocelli
