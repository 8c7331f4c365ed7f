#include "oc_core/remote/remote_message.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr int kMaxNumber = std::numeric_limits<int>::max();
constexpr size_t kMaxNameCharacters = 4096;

uint32_t readSequence(JsonFields& fields) {
  return static_cast<uint32_t>(fields.integer("sequence", 0, kMaxNumber));
}

std::array<float, 3> asNumbers(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

Box readBox(JsonFields& fields) {
  constexpr double kFarthest = 1e9;
  const nlohmann::json& corners = fields.value("box");
  std::array<glm::vec3, 2> points{};
  if (!corners.is_array() || corners.size() != 2) {
    fields.fail("box", "must be two corners");
  }
  for (size_t i = 0; i < 2; ++i) {
    const nlohmann::json object{{"box", corners[i]}};
    JsonFields corner(object, fields.where());
    const std::vector<double> numbers = corner.numbers("box", 3, -kFarthest, kFarthest);
    points[i] = {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
  }
  return {points[0], points[1]};
}

RemoteServerMessage readHello(JsonFields& fields) {
  RemoteHello hello;
  hello.version = fields.integer("version", RemoteHello::kVersion, RemoteHello::kVersion);
  hello.scene = fields.text("scene");
  hello.view = viewFromJsonText(fields.value("view").dump(), "message \"hello\", \"view\"");
  hello.box = readBox(fields);
  hello.settings = remoteSettingsFromJson(fields.value("settings").dump(), "message \"hello\", \"settings\"");
  hello.maxScreen =
      fields.integer("max_screen", RemoteRequest::kMinScreen, RemoteRequest::kMaxScreen, RemoteRequest::kMaxScreen);
  return hello;
}

RemoteServerMessage readQueued(JsonFields& fields) {
  const uint32_t sequence = readSequence(fields);
  return RemoteQueued{sequence, fields.integer("before", 0, kMaxNumber)};
}

RemoteServerMessage readDrawing(JsonFields& fields) {
  return RemoteDrawing{readSequence(fields)};
}

RemoteServerMessage readFailure(JsonFields& fields) {
  RemoteFailure failure{.message = fields.shortText("message", kMaxNameCharacters)};
  if (fields.has("sequence")) {
    failure.sequence = readSequence(fields);
  }
  return failure;
}

const std::map<std::string, RemoteServerMessage (*)(JsonFields&)>& readers() {
  static const std::map<std::string, RemoteServerMessage (*)(JsonFields&)> kReaders{
      {"hello", readHello}, {"queued", readQueued}, {"drawing", readDrawing}, {"error", readFailure}};
  return kReaders;
}

[[noreturn]] void failPiece(const std::string& problem) {
  throw InputError(problem, "piece of an image", "see docs/remote_protocol.md");
}

void writeWord(std::byte* to, uint32_t word) {
  for (size_t i = 0; i < 4; ++i) {
    to[i] = static_cast<std::byte>(word >> (8 * i));
  }
}

uint32_t readWord(const std::byte* from) {
  uint32_t word = 0;
  for (size_t i = 0; i < 4; ++i) {
    word |= static_cast<uint32_t>(from[i]) << (8 * i);
  }
  return word;
}

}  // namespace

std::string jsonText(const RemoteHello& hello) {
  return textOfJson({{"type", "hello"},
                     {"version", hello.version},
                     {"scene", hello.scene},
                     {"view", nlohmann::ordered_json::parse(jsonText(hello.view))},
                     {"box", {asNumbers(hello.box.lower), asNumbers(hello.box.upper)}},
                     {"settings", nlohmann::ordered_json::parse(jsonText(hello.settings))},
                     {"max_screen", hello.maxScreen}});
}

std::string jsonText(const RemoteQueued& queued) {
  return textOfJson({{"type", "queued"}, {"sequence", queued.sequence}, {"before", queued.before}});
}

std::string jsonText(const RemoteDrawing& drawing) {
  return textOfJson({{"type", "drawing"}, {"sequence", drawing.sequence}});
}

std::string jsonText(const RemoteFailure& failure) {
  nlohmann::ordered_json json{{"type", "error"}, {"message", failure.message}};
  if (failure.sequence) {
    json["sequence"] = *failure.sequence;
  }
  return textOfJson(json);
}

RemoteServerMessage remoteServerMessageFromJson(const std::string& text) {
  return readAs("docs/remote_protocol.md", [&]() -> RemoteServerMessage {
    constexpr const char* kFromServer = "message of the server";
    if (text.size() > RemoteImageHeader::kMaxTextBytes) {
      throw InputError("it is longer than " + std::to_string(RemoteImageHeader::kMaxTextBytes) + " bytes", kFromServer,
                       "send less");
    }
    const nlohmann::json json = parseJson(text, kFromServer);
    JsonFields fields(json, kFromServer);
    const std::string type = fields.text("type");
    if (type == "image") {
      return remoteImageHeaderFromJson(text);
    }
    const auto reader = readers().find(type);
    if (reader == readers().end()) {
      fields.fail("type", "is no message of a server");
    }
    RemoteServerMessage message = reader->second(fields);
    fields.rejectUnknown();
    return message;
  });
}

std::vector<std::byte> messageOf(const RemotePiece& piece) {
  OC_CHECK(!piece.bytes.empty() && piece.bytes.size() <= RemotePiece::kMaxBytes,
           "a piece has bytes, and fits a message");
  std::vector<std::byte> message(RemotePiece::kHeaderBytes + piece.bytes.size());
  writeWord(message.data(), piece.id);
  message[4] = static_cast<std::byte>(piece.plane);
  writeWord(message.data() + 8, piece.offset);
  std::ranges::copy(piece.bytes, message.begin() + RemotePiece::kHeaderBytes);
  return message;
}

RemotePiece pieceOf(std::span<const std::byte> message) {
  if (message.size() <= RemotePiece::kHeaderBytes || message.size() > RemotePiece::kMaxMessageBytes) {
    failPiece("a piece has from 13 to " + std::to_string(RemotePiece::kMaxMessageBytes) + " bytes");
  }
  const auto plane = static_cast<uint8_t>(message[4]);
  if (plane > static_cast<uint8_t>(RemotePlane::kDepth)) {
    failPiece("it is of plane " + std::to_string(plane) + ", and there are 0 and 1");
  }
  if (message[5] != std::byte{0} || message[6] != std::byte{0} || message[7] != std::byte{0}) {
    failPiece("bytes 5 to 7 are not zero");
  }
  return {.id = readWord(message.data()),
          .plane = static_cast<RemotePlane>(plane),
          .offset = readWord(message.data() + 8),
          .bytes = message.subspan(RemotePiece::kHeaderBytes)};
}

std::vector<RemotePiece> piecesOf(const RemoteImage& image) {
  std::vector<RemotePiece> pieces;
  const auto add = [&](RemotePlane plane, std::span<const std::byte> bytes) {
    for (size_t offset = 0; offset < bytes.size(); offset += RemotePiece::kMaxBytes) {
      pieces.push_back({.id = image.id,
                        .plane = plane,
                        .offset = static_cast<uint32_t>(offset),
                        .bytes = bytes.subspan(offset, std::min(RemotePiece::kMaxBytes, bytes.size() - offset))});
    }
  };
  add(RemotePlane::kColor, image.color);
  add(RemotePlane::kDepth, image.depth);
  return pieces;
}

RemoteAssembly::RemoteAssembly(RemoteImageHeader header) : header_(std::move(header)) {
  const auto prepare = [](Plane& plane, size_t bytes) {
    plane.bytes.resize(bytes);
    plane.has.resize(bytes);
    plane.missing = bytes;
  };
  prepare(color_, header_.colorBytes);
  prepare(depth_, header_.depthBytes);
}

void RemoteAssembly::add(const RemotePiece& piece) {
  Plane& plane = piece.plane == RemotePlane::kColor ? color_ : depth_;
  if (piece.id != header_.id) {
    failPiece("it is of another image");
  }
  if (piece.offset > plane.bytes.size() || piece.bytes.size() > plane.bytes.size() - piece.offset) {
    failPiece("it reaches beyond the bytes of its image");
  }
  const auto first = static_cast<std::ptrdiff_t>(piece.offset);
  const auto last = first + static_cast<std::ptrdiff_t>(piece.bytes.size());
  if (std::find(plane.has.begin() + first, plane.has.begin() + last, true) != plane.has.begin() + last) {
    failPiece("it has bytes that have come already");
  }
  std::copy(piece.bytes.begin(), piece.bytes.end(), plane.bytes.begin() + first);
  std::fill(plane.has.begin() + first, plane.has.begin() + last, true);
  plane.missing -= piece.bytes.size();
}

size_t RemoteAssembly::received() const {
  return expected() - color_.missing - depth_.missing;
}

}  // namespace ocelli
