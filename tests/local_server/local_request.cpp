#include "tests/local_server/local_request.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace ocelli::test {

int connectTo(const char* host, int port) {
  const int client = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  inet_pton(AF_INET, host, &address.sin_addr);
  if (connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    close(client);
    return -1;
  }
  return client;
}

std::string ask(int port, const std::string& request) {
  const int client = connectTo("127.0.0.1", port);
  EXPECT_GE(client, 0);
  EXPECT_EQ(send(client, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  std::string answer;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 1; count > 0;) {
    count = recv(client, bytes.data(), bytes.size(), 0);
    answer.append(bytes.data(), static_cast<size_t>(std::max<ssize_t>(count, 0)));
  }
  close(client);
  return answer;
}

std::string askFor(int port, const std::string& path, const std::string& host, const std::string& method) {
  return ask(port, method + " " + path + " HTTP/1.1\r\nHost: " +
                       (host.empty() ? "127.0.0.1:" + std::to_string(port) : host) + "\r\nConnection: close\r\n\r\n");
}

}  // namespace ocelli::test
