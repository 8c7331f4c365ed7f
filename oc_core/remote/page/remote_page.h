// The page of remote visualisation (section 5.2.1), as a server hands it out: a client in HTML, CSS and JavaScript that
// needs WebGL2 and nothing from elsewhere. It speaks docs/remote_protocol.md with the WebSocket "ws" beside it, and
// passes on the token of its own address.
#pragma once

#include <span>
#include <string>

namespace ocelli {

struct RemotePageFile {
  std::string path;       ///< "/" is the page itself; it asks for the others
  std::string mediaType;  ///< "text/html; charset=utf-8"
  std::string bytes;
};

/// All of them, the page first. They stay until the program ends.
std::span<const RemotePageFile> remotePageFiles();

}  // namespace ocelli
