// Requests by hand, as browsers and worse send them.
#pragma once

#include <string>

namespace ocelli::test {

/// Connects to an address of this computer; -1 where nobody listens there.
int connectTo(const char* host, int port);

/// All that the server at 127.0.0.1 sends until it closes the connection.
std::string ask(int port, const std::string& request);

/// The answer to METHOD PATH, asked with this Host, which by default is the server's own address.
std::string askFor(int port, const std::string& path, const std::string& host = "", const std::string& method = "GET");

}  // namespace ocelli::test
