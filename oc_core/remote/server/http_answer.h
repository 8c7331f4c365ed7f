// How the server of remote visualisation answers a request of HTTP: files of the page for GET and HEAD, and a WebSocket
// at /ws. Everything else is refused. Pages and WebSockets ask for the host, the WebSocket for the page's origin too,
// and both for the token where there is one: access_rules.h. Scripts and styles ask for the host alone; they are no
// secrets.
#pragma once

#include <span>
#include <string>

#include "oc_core/remote/server/access_rules.h"
#include "oc_core/remote/server/page_asset.h"

namespace ocelli {

inline constexpr const char* kWebSocketPath = "/ws";

struct HttpRequest {
  std::string method;  ///< "GET"
  std::string path;    ///< "/remote.js"
  std::string query;   ///< what stands behind "?"
  std::string host;    ///< the header of that name, like the next ones
  std::string origin;
  std::string upgrade;  ///< "websocket", or empty
};

struct HttpAnswer {
  int code = 200;
  std::string head;                  ///< to the empty line, with security headers; the connection ends after the answer
  std::string text;                  ///< the body, where it is short and made for this request
  const PageAsset* asset = nullptr;  ///< the body otherwise
  bool withBody = true;              ///< not for HEAD

  const std::string& body() const { return asset != nullptr ? asset->bytes : text; }
};

/// `assets` must live as long as the answer.
HttpAnswer httpAnswer(const HttpRequest& request, std::span<const PageAsset> assets, const AccessRules& rules);

/// Whether it may become a WebSocket: 101 where it may, otherwise an answer that refuses it. `isFull`: no more clients.
HttpAnswer webSocketAnswer(const HttpRequest& request, const AccessRules& rules, bool isFull);

}  // namespace ocelli
