// SPDX-License-Identifier: Apache-2.0
#include "cli/page_server.h"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/system/system_error.hpp>
#include <deque>
#include <list>
#include <sstream>
#include <string_view>
#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using Error = boost::system::error_code;

constexpr std::uint16_t kUsualPort = 8600;
constexpr std::size_t kMostClients = 64;     // asking or being answered
constexpr std::size_t kMostListeners = 32;   // of /events
constexpr std::uint32_t kMostHeader = 8192;  // bytes
constexpr std::chrono::seconds kToAsk{10};
constexpr std::chrono::seconds kToTake{30};
constexpr std::chrono::seconds kToGo{2};
constexpr std::chrono::seconds kHeartbeat{15};

struct Content {
  std::string page;
  std::string version;
};

class Client;
class Listener;

}  // namespace

struct PageServerState {
  std::uint16_t port = 0;
  asio::io_context io{1};
  tcp::acceptor acceptor{io};
  asio::steady_timer timer{io};
  asio::steady_timer heartbeat{io};
  std::shared_ptr<const Content> content = std::make_shared<Content>();
  std::list<std::weak_ptr<Client>> clients;
  std::list<std::shared_ptr<Listener>> listeners;
};

namespace {

using State = PageServerState;

std::string event_of(const std::string& version) { return "retry: 1000\ndata: " + version + "\n\n"; }

// A browser that is told of changes, until it goes.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  explicit Listener(beast::tcp_stream stream) : stream_(std::move(stream)) {}

  void begin(const std::string& version) {
    say("HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n" +
        event_of(version));
    await_end();
  }
  void say(std::string text) {
    if (queue_.size() > kBehind) return close();
    queue_.push_back(std::move(text));
    if (queue_.size() == 1) write();
  }
  void close() {
    gone_ = true;
    stream_.close();
  }
  [[nodiscard]] bool gone() const { return gone_; }

 private:
  static constexpr std::size_t kBehind = 8;

  void write() {
    stream_.expires_after(kToTake);
    asio::async_write(stream_, asio::buffer(queue_.front()), [self = shared_from_this()](Error error, std::size_t) {
      if (error) return self->close();
      self->stream_.expires_never();
      self->queue_.pop_front();
      if (!self->queue_.empty()) self->write();
    });
  }
  // Whatever it says now, or its end: it is no listener any more.
  void await_end() {
    stream_.socket().async_wait(tcp::socket::wait_read, [self = shared_from_this()](Error) { self->close(); });
  }

  beast::tcp_stream stream_;
  std::deque<std::string> queue_;
  bool gone_ = false;
};

// One client that asks.
class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(State& state, tcp::socket socket) : state_(state), stream_(std::move(socket)) {}

  void close() { stream_.close(); }
  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeader);
    stream_.expires_after(kToAsk);
    http::async_read_header(stream_, buffer_, *parser_, [self = shared_from_this()](Error error, std::size_t) {
      if (error == http::error::end_of_stream || error == beast::error::timeout ||
          error == asio::error::operation_aborted)
        return;
      if (error == http::error::header_limit) return self->refuse(http::status::request_header_fields_too_large);
      if (error) return self->refuse(http::status::bad_request);
      self->answer(self->parser_->get());
    });
  }

 private:
  using Request = http::request<http::empty_body>;

  [[nodiscard]] bool names_us(const Request& request) const {
    const std::string port = ":" + std::to_string(state_.port);
    const auto host = request[http::field::host];
    return request.count(http::field::host) == 1 && (host == "127.0.0.1" + port || host == "localhost" + port);
  }

  void answer(const Request& request) {
    if (!names_us(request)) return refuse(http::status::misdirected_request);
    if (request.method() != http::verb::get) return refuse(http::status::method_not_allowed);
    if (request.has_content_length() || request.chunked()) return refuse(http::status::bad_request);
    const std::string target(request.target());
    const std::string path = target.substr(0, target.find('?'));
    if (path == "/events") return listen();
    go_on_ = request.keep_alive();
    if (path == "/") return send(http::status::ok, "text/html", state_.content);
    if (path == "/favicon.ico") return send(http::status::no_content, "text/plain", text({}));
    send(http::status::not_found, "text/plain", text("The only page here is /\n"));
  }

  void refuse(http::status status) {
    go_on_ = false;
    send(status, "text/plain", text(std::string(http::obsolete_reason(status)) + "\n"));
  }

  static std::shared_ptr<const Content> text(std::string body) {
    return std::make_shared<const Content>(Content{std::move(body), {}});
  }

  void send(http::status status, const std::string& type, std::shared_ptr<const Content> body) {
    http::response<http::empty_body> head(status, 11);
    head.set(http::field::content_type, type + "; charset=utf-8");
    head.set(http::field::cache_control, "no-store");
    head.set("X-Content-Type-Options", "nosniff");
    head.set("Cross-Origin-Resource-Policy", "same-origin");
    head.set("Content-Security-Policy", "frame-ancestors 'none'");
    head.set("Referrer-Policy", "no-referrer");
    if (status == http::status::method_not_allowed) head.set(http::field::allow, "GET");
    if (status != http::status::no_content) head.content_length(body->page.size());
    head.keep_alive(go_on_);
    std::ostringstream out;
    out << head.base();
    head_ = out.str();
    body_ = std::move(body);
    stream_.expires_after(kToTake);
    asio::async_write(stream_, std::array<asio::const_buffer, 2>{asio::buffer(head_), asio::buffer(body_->page)},
                      [self = shared_from_this()](Error error, std::size_t) {
                        if (error) return;
                        if (self->go_on_) return self->read();
                        Error end;
                        end = self->stream_.socket().shutdown(tcp::socket::shutdown_send, end);
                        self->stream_.expires_after(kToGo);
                        self->drain();
                      });
  }

  // An answer is lost where the connection is closed while something that was sent is unread.
  void drain() {
    stream_.async_read_some(asio::buffer(unread_), [self = shared_from_this()](Error error, std::size_t) {
      if (!error) self->drain();
    });
  }

  // The oldest makes room.
  void listen() {
    const auto listener = std::make_shared<Listener>(std::move(stream_));
    state_.listeners.remove_if([](const auto& other) { return other->gone(); });
    if (state_.listeners.size() >= kMostListeners) {
      state_.listeners.front()->close();
      state_.listeners.pop_front();
    }
    state_.listeners.push_back(listener);
    listener->begin(state_.content->version);
  }

  State& state_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{kMostHeader};
  std::optional<http::request_parser<http::empty_body>> parser_;
  bool go_on_ = false;
  std::string head_;
  std::shared_ptr<const Content> body_;
  std::array<char, 4096> unread_{};
};

void accept(State& state) {
  state.acceptor.async_accept([&state](Error error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      // Who has been at it longest makes room.
      state.clients.remove_if([](const auto& client) { return client.expired(); });
      if (state.clients.size() >= kMostClients) {
        if (const auto oldest = state.clients.front().lock()) oldest->close();
        state.clients.pop_front();
      }
      const auto client = std::make_shared<Client>(state, std::move(socket));
      state.clients.push_back(client);
      client->read();
    }
    accept(state);
  });
}

void beat(State& state) {
  state.heartbeat.expires_after(kHeartbeat);
  state.heartbeat.async_wait([&state](Error error) {
    if (error) return;
    for (const auto& listener : state.listeners) listener->say(":\n\n");
    beat(state);
  });
}

void tick(State& state, std::chrono::milliseconds interval, const std::function<void()>& at_times) {
  state.timer.expires_after(interval);
  state.timer.async_wait([&state, interval, at_times](Error error) {
    if (error) return;
    at_times();
    tick(state, interval, at_times);
  });
}

Error listen_on(State& state, std::uint16_t port) {
  try {
    const tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    tcp::acceptor acceptor(state.io, here.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(here);
    acceptor.listen();
    state.port = acceptor.local_endpoint().port();
    state.acceptor = std::move(acceptor);
    return {};
  } catch (const boost::system::system_error& error) {
    return error.code();
  }
}

}  // namespace

PageServer::PageServer(std::optional<std::uint16_t> port) : state_(std::make_unique<State>()) {
  Error error = listen_on(*state_, port.value_or(kUsualPort));
  if (error && !port) error = listen_on(*state_, 0);
  if (error)
    throw spec::InputError("--port", 0, 0,
                           "127.0.0.1:" + std::to_string(port.value_or(kUsualPort)) +
                               ": cannot listen on this port: " + error.message() + "; use 0 for any free port");
}

PageServer::~PageServer() = default;

std::string PageServer::address() const { return "http://127.0.0.1:" + std::to_string(state_->port) + "/"; }

void PageServer::show(std::string page, std::string version) {
  asio::post(state_->io, [state = state_.get(),
                          content = std::make_shared<const Content>(Content{std::move(page), std::move(version)})] {
    state->content = content;
    state->listeners.remove_if([](const auto& listener) { return listener->gone(); });
    for (const auto& listener : state->listeners) listener->say(event_of(content->version));
  });
}

void PageServer::run(std::chrono::milliseconds interval, const std::function<void()>& at_times) {
  accept(*state_);
  beat(*state_);
  tick(*state_, interval, at_times);
  state_->io.run();
}

void PageServer::stop() { state_->io.stop(); }

}  // namespace toolcomp::cli
