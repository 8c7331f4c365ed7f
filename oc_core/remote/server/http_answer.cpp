#include "oc_core/remote/server/http_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ocelli {
namespace {

constexpr const char* kPlainText = "text/plain; charset=utf-8";
constexpr const char* kPagePath = "/";

struct StatusPhrase {
  int code;
  const char* phrase;
};
constexpr std::array<StatusPhrase, 6> kStatusPhrases{{{200, "OK"},
                                                      {400, "Bad Request"},
                                                      {403, "Forbidden"},
                                                      {404, "Not Found"},
                                                      {405, "Method Not Allowed"},
                                                      {503, "Service Unavailable"}}};

std::string headOf(int code, const std::string& mediaType, size_t size, const std::string& host) {
  const auto* const row = std::ranges::find(kStatusPhrases, code, &StatusPhrase::code);
  std::string head = fmt::format("HTTP/1.1 {} {}\r\n", code, row != kStatusPhrases.end() ? row->phrase : "");
  head += fmt::format("Content-Type: {}\r\nContent-Length: {}\r\n", mediaType, size);
  // Browsers differ in whether 'self' stands for WebSockets too. A host that was not allowed stands in no header.
  head += fmt::format(
      "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'{}; "
      "img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n",
      host.empty() ? "" : " ws://" + host);
  head +=
      "Cache-Control: no-store\r\n"
      "Cross-Origin-Opener-Policy: same-origin\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\n"
      "Referrer-Policy: no-referrer\r\n"
      "X-Content-Type-Options: nosniff\r\n";
  if (code == 405) {
    head += "Allow: GET, HEAD\r\n";
  }
  return head + "Connection: close\r\n\r\n";
}

HttpAnswer refusal(int code, const std::string& text) {
  HttpAnswer answer;
  answer.code = code;
  answer.text = text + "\n";
  answer.head = headOf(code, kPlainText, answer.text.size(), "");
  return answer;
}

HttpAnswer refusedHost() {
  return refusal(403, "this server is known by the address of its computer alone, and by names that it was given");
}

HttpAnswer refusedToken() {
  return refusal(403, "the address lacks the token, or has another one: use the address that the server printed");
}

}  // namespace

HttpAnswer httpAnswer(const HttpRequest& request, std::span<const PageAsset> assets, const AccessRules& rules) {
  if (!isHostAllowed(request.host, rules.names)) {
    return refusedHost();
  }
  if (request.method != "GET" && request.method != "HEAD") {
    return refusal(405, "this page can only be read");
  }
  const auto asset = std::ranges::find(assets, request.path, &PageAsset::path);
  if (asset == assets.end()) {
    return refusal(404, "there is nothing here");
  }
  if (request.path == kPagePath && !isTokenRight(tokenOfQuery(request.query), rules.token)) {
    return refusedToken();
  }
  HttpAnswer answer;
  answer.asset = &*asset;
  answer.withBody = request.method == "GET";
  answer.head = headOf(answer.code, asset->mediaType, asset->bytes.size(), request.host);
  return answer;
}

HttpAnswer webSocketAnswer(const HttpRequest& request, const AccessRules& rules, bool isFull) {
  if (!isHostAllowed(request.host, rules.names)) {
    return refusedHost();
  }
  if (request.method != "GET" || request.upgrade != "websocket") {
    return refusal(400, "a connection can become a WebSocket, and nothing else");
  }
  if (request.path != kWebSocketPath) {
    return refusal(404, "WebSockets are at /ws");
  }
  if (!isOriginAllowed(request.origin, request.host)) {
    return refusal(403, "the page of another site may not use this server");
  }
  if (!isTokenRight(tokenOfQuery(request.query), rules.token)) {
    return refusedToken();
  }
  if (isFull) {
    return refusal(503, "as many clients as this server takes are there already");
  }
  HttpAnswer answer;
  answer.code = 101;
  return answer;
}

}  // namespace ocelli
