#include "oc_core/remote/server/remote_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <map>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/server/client_session.h"
#include "oc_core/remote/server/http_answer.h"
#include "oc_core/remote/server/listening_socket.h"
#include "oc_core/remote/server/note_queue.h"
#include "oc_core/remote/server/socket_loop.h"

namespace ocelli {
namespace {

constexpr int kHttpOk = 200;
constexpr int kSwitchingProtocols = 101;

/// What this program has open besides: files, and sockets that are refused.
constexpr size_t kOtherDescriptors = 64;

void requireToken(const RemoteServerSetup& setup) {
  if (!isLoopbackAddress(setup.address) && setup.access.token.empty()) {
    throw InputError("other computers reach this address, and there is no token", setup.address,
                     "give a token, or listen at 127.0.0.1");
  }
}

struct ServedConnection {
  std::string address;
  std::string network;
  int64_t since = 0;
  size_t client = 0;                       ///< its number among clients
  std::optional<ClientSession> session{};  ///< of a client
};

}  // namespace

// All but counts() and the events of draws_ happens on the thread of the loop.
class RemoteServer::State : public LoopEvents {
 public:
  explicit State(RemoteServerSetup setup)
      : setup_(std::move(setup)),
        listener_(setup_.address, setup_.port),
        notes_(setup_.note),
        loop_(std::make_unique<SocketLoop>(LoopSetup{.maxConnections = maxConnections(setup_.limits),
                                                     .handshakeSeconds = setup_.limits.handshakeSeconds,
                                                     .pingSeconds = setup_.limits.pingSeconds},
                                           listener_, *this)) {
    draws_ = std::make_unique<DrawService>(setup_.drawThreads, setup_.draw, drawEvents());
    loop_->start();
  }

  ~State() override {
    loop_->stop();
    draws_.reset();
    loop_.reset();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const RemoteServerSetup& setup() const { return setup_; }
  const ListeningSocket& listener() const { return listener_; }

  RemoteServerCounts counts() {
    const auto promise = std::make_shared<std::promise<RemoteServerCounts>>();
    auto counted = promise->get_future();
    loop_->post([this, promise] { promise->set_value(countsNow()); });
    constexpr std::chrono::seconds kPatience{30};
    if (counted.wait_for(kPatience) != std::future_status::ready) {
      throw WorkError("it does not answer any more", "the server of remote visualisation", "start it again");
    }
    return counted.get();
  }

 private:
  bool accepts(const AcceptedSocket& accepted) override {
    const auto same =
        std::ranges::count_if(connections_, [&](const auto& each) { return each.second.network == accepted.network; });
    const bool isRoom = same < setup_.limits.connectionsPerAddress &&
                        connections_.size() < static_cast<size_t>(maxConnections(setup_.limits));
    counts_.refused += isRoom ? 0 : 1;
    return isRoom;
  }

  void couldNotAccept() override { ++counts_.rests; }

  void connected(uint64_t connection, const AcceptedSocket& accepted) override {
    connections_[connection] = {accepted.address, accepted.network, steadyNanoseconds()};
  }

  void closed(uint64_t connection) override {
    // It is not among them any more, whatever happens below.
    const auto left = connections_.extract(connection);
    if (left.empty()) {
      return;
    }
    const ServedConnection& served = left.mapped();
    if (const auto& session = served.session) {
      if (draws_) {
        draws_->leave(connection);
      }
      counts_.looks += session->looks();
      counts_.images += session->outbox().imagesSent();
      counts_.bytesSent += session->bytesSent();
      note(fmt::format("client {} left: {} looks, {} images, {:.1f} MB", served.client, session->looks(),
                       session->outbox().imagesSent(), static_cast<double>(session->bytesSent()) * 1e-6));
    }
  }

  HttpAnswer answer(uint64_t /*connection*/, const HttpRequest& request) override {
    HttpAnswer answer = httpAnswer(request, setup_.assets, setup_.access);
    counts_.refused += answer.code == kHttpOk ? 0 : 1;
    return answer;
  }

  HttpAnswer upgradeAnswer(uint64_t /*connection*/, const HttpRequest& request) override {
    HttpAnswer answer =
        webSocketAnswer(request, setup_.access, clientsNow() >= static_cast<size_t>(setup_.limits.clients));
    counts_.refused += answer.code == kSwitchingProtocols ? 0 : 1;
    return answer;
  }

  void becameWebSocket(uint64_t connection) override {
    ServedConnection& served = connections_.at(connection);
    const int64_t now = steadyNanoseconds();
    served.client = ++counts_.clients;
    served.session.emplace(setup_.limits, setup_.link, now);
    served.session->outbox().addText(ClientOutbox::Kind::kHello, setup_.hello, now);
    loop_->wantToSend(connection);
    note(fmt::format("client {} came from {}", served.client, served.address));
  }

  std::optional<CloseReason> received(uint64_t connection, std::string_view part, bool isBinary, bool isLast) override {
    ServedConnection& served = connections_.at(connection);
    ClientSession& session = *served.session;
    const int64_t now = steadyNanoseconds();
    ClientSession::Received received = session.receive(part, isBinary, isLast, now);
    if (received.close) {
      ++counts_.refused;
      note(fmt::format("client {} is closed: {}", served.client, received.close->text));
      return received.close;
    }
    if (received.look) {
      const uint32_t sequence = received.look->sequence;
      const size_t before = draws_->ask(connection, std::move(*received.look));
      session.outbox().addText(ClientOutbox::Kind::kQueued,
                               jsonText(RemoteQueued{.sequence = sequence, .before = static_cast<int>(before)}), now);
    }
    loop_->wantToSend(connection);  // an answer to what cannot be read, too
    return std::nullopt;
  }

  std::optional<OutgoingMessage> nextMessage(uint64_t connection, int64_t& waitNanoseconds) override {
    ClientSession& session = *connections_.at(connection).session;
    const int64_t now = steadyNanoseconds();
    const bool hadImage = session.outbox().hasImage();
    std::optional<OutgoingMessage> message = session.nextDue(now);
    if (hadImage && !session.outbox().hasImage()) {
      draws_->setReady(connection, true);
    }
    if (!message) {
      waitNanoseconds = session.leavesAt().value_or(now) - now;
    }
    return message;
  }

  void tick() override {
    const int64_t now = steadyNanoseconds();
    for (const auto& [number, served] : connections_) {
      if (!served.session) {
        if (now - served.since > int64_t{setup_.limits.handshakeSeconds} * 1'000'000'000) {
          loop_->closeNow(number);
        }
      } else if (const auto reason = served.session->outOfTime(now)) {
        loop_->closeSoon(number, *reason);
      }
    }
  }

  DrawEvents drawEvents() {
    return {.drawing =
                [this](uint64_t client, uint32_t sequence) {
                  tell(client, ClientOutbox::Kind::kDrawing, jsonText(RemoteDrawing{sequence}));
                },
            .drawn =
                [this](uint64_t client, RemoteImage image, double seconds) {
                  const auto shared = std::make_shared<RemoteImage>(std::move(image));
                  postFor(client, [this, client, shared, seconds] { addImage(client, std::move(*shared), seconds); });
                },
            .failed =
                [this](uint64_t client, uint32_t sequence, const std::string& problem) {
                  tell(client, ClientOutbox::Kind::kError,
                       jsonText(RemoteFailure{.message = problem, .sequence = sequence}));
                }};
  }

  /// What fails ends this connection: its client would wait for ever for what it was to hear.
  void postFor(uint64_t connection, std::function<void()> work) {
    loop_->post([this, connection, work = std::move(work)] {
      try {
        work();
      } catch (...) {
        loop_->closeNow(connection);
      }
    });
  }

  void tell(uint64_t connection, ClientOutbox::Kind kind, const std::string& text) {
    postFor(connection, [this, connection, kind, text] {
      if (const auto found = connections_.find(connection); found != connections_.end()) {
        found->second.session->outbox().addText(kind, text, steadyNanoseconds());
        loop_->wantToSend(connection);
      }
    });
  }

  void addImage(uint64_t connection, RemoteImage image, double seconds) {
    const auto found = connections_.find(connection);
    if (found == connections_.end()) {
      return;
    }
    std::string line =
        fmt::format("client {}: image {} for look {}: {:.2f} s, {:.0f} KB", found->second.client, image.id,
                    image.sequence, seconds, static_cast<double>(image.color.size() + image.depth.size()) * 1e-3);
    found->second.session->outbox().addImage(std::move(image), steadyNanoseconds());
    loop_->wantToSend(connection);
    note(std::move(line));
  }

  size_t clientsNow() const {
    return static_cast<size_t>(
        std::ranges::count_if(connections_, [](const auto& each) { return each.second.session.has_value(); }));
  }

  RemoteServerCounts countsNow() const {
    RemoteServerCounts counts = counts_;
    counts.clientsNow = clientsNow();
    counts.connectionsNow = connections_.size();
    for (const auto& [number, served] : connections_) {
      if (served.session) {
        counts.looks += served.session->looks();
        counts.images += served.session->outbox().imagesSent();
        counts.bytesSent += served.session->bytesSent();
        counts.imageBytesNow += served.session->outbox().heldBytes() + served.session->heldBytes();
      }
    }
    return counts;
  }

  void note(std::string line) {
    if (setup_.note) {
      notes_.add(std::move(line));
    }
  }

  const RemoteServerSetup setup_;
  ListeningSocket listener_;
  NoteQueue notes_;
  RemoteServerCounts counts_;
  std::map<uint64_t, ServedConnection> connections_;
  std::unique_ptr<SocketLoop> loop_;
  std::unique_ptr<DrawService> draws_;
};

RemoteServer::RemoteServer(RemoteServerSetup setup) {
  requireToken(setup);
  allowDescriptors(static_cast<size_t>(maxConnections(setup.limits)) + kOtherDescriptors);
  state_ = std::make_unique<State>(std::move(setup));
}

RemoteServer::~RemoteServer() = default;

int RemoteServer::port() const {
  return state_->listener().port();
}

std::string RemoteServer::pageAddress() const {
  const std::string& token = state_->setup().access.token;
  return "http://" + state_->listener().hostAndPort() + "/" + (token.empty() ? "" : "?token=" + token);
}

RemoteServerCounts RemoteServer::counts() const {
  return state_->counts();
}

}  // namespace ocelli
