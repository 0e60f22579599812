#include "run/web_socket_server.hpp"

#include <algorithm>
#include <map>
#include <thread>
#include <utility>
#include <websocketpp/config/asio_no_tls.hpp>
#include <websocketpp/server.hpp>

#include "ddtool/base/error.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

namespace ws = websocketpp;
using Server = ws::server<ws::config::asio>;
using Connection = Server::connection_ptr;

constexpr std::size_t longest_request_bytes = std::size_t{1} << 16;
constexpr long tick_ms = 50;
constexpr long goodbye_ms = 1000;
/// A client that has vanished without closing the connection, for example because its cable was pulled, does not answer
/// a ping. A slow client does answer, but only after it has read what was sent before the ping, which is why the wait
/// is long.
constexpr long ping_interval_ms = 120'000;
constexpr long pong_wait_ms = 100'000;

/// The address and the port as they are written in a URL.
std::string url_part(const asio::ip::tcp::endpoint& at) {
    const std::string address = at.address().to_string();
    return (at.address().is_v6() ? "[" + address + "]" : address) + ":" + std::to_string(at.port());
}

}  // namespace

class WebSocketServer::Endpoint {
public:
    Endpoint(const std::string& address, std::uint16_t port, std::vector<std::string> subprotocols)
        : subprotocols_(std::move(subprotocols)) {
        std::error_code problem;
        const asio::ip::address parsed = asio::ip::make_address(address, problem);
        if (problem) {
            throw UsageError("'" + address + "' is no IP address; expected for example 127.0.0.1 or 0.0.0.0");
        }
        set_up();
        listen({parsed, port});
    }
    ~Endpoint() {
        if (thread_.joinable()) {
            post([this] { say_goodbye(); });
            thread_.join();
        }
    }
    Endpoint(const Endpoint&) = delete;
    Endpoint& operator=(const Endpoint&) = delete;

    void start(WebSocketEvents events) {
        events_ = std::move(events);
        server_.start_accept();
        schedule_tick();
        schedule_pings();
        thread_ = std::thread([this] { serve(); });
    }
    std::string place() {
        std::error_code problem;
        return url_part(server_.get_local_endpoint(problem));
    }
    void post(std::function<void()> task) { asio::post(server_.get_io_service(), std::move(task)); }

    void send(ClientId client, const std::string& payload, ws::frame::opcode::value kind) {
        if (const auto found = clients_.find(client); found != clients_.end()) {
            // an error is ignored: it means that the connection is about to be closed
            found->second->send(payload, kind);
        }
    }
    std::size_t unsent_bytes(ClientId client) const {
        const auto found = clients_.find(client);
        return found == clients_.end() ? 0 : found->second->get_buffered_amount();
    }

private:
    void set_up() {
        server_.clear_access_channels(ws::log::alevel::all);
        server_.clear_error_channels(ws::log::elevel::all);
        server_.set_max_message_size(longest_request_bytes);
        server_.set_max_http_body_size(longest_request_bytes);
        server_.set_close_handshake_timeout(goodbye_ms);
        server_.set_pong_timeout(pong_wait_ms);
        server_.init_asio();
        server_.set_reuse_addr(true);
        server_.set_validate_handler([this](const ws::connection_hdl& handle) { return accept(handle); });
        server_.set_open_handler([this](const ws::connection_hdl& handle) { open(handle); });
        server_.set_pong_timeout_handler(
            [this](const ws::connection_hdl& handle, const std::string&) { drop(handle); });
    }

    void listen(const asio::ip::tcp::endpoint& at) {
        ws::lib::error_code problem;
        server_.listen(at, problem);
        if (problem) {
            throw Error("cannot serve at " + url_part(at) + ": " + problem.message());
        }
    }

    void serve() {
        // An exception that the library throws because of a client's behaviour must not end the run.
        while (!server_.stopped()) {
            try {
                server_.run();
            } catch (const std::exception& error) {
                log_debug(std::string("serve: ") + error.what());
            }
        }
    }

    bool accept(const ws::connection_hdl& handle) {
        const Connection connection = server_.get_con_from_hdl(handle);
        if (clients_.size() >= most_clients) {
            connection->set_status(ws::http::status_code::service_unavailable);
            return false;
        }
        for (const std::string& asked : connection->get_requested_subprotocols()) {
            if (std::find(subprotocols_.begin(), subprotocols_.end(), asked) != subprotocols_.end()) {
                connection->select_subprotocol(asked);
                return true;
            }
        }
        connection->set_status(ws::http::status_code::bad_request);
        return false;
    }

    void open(const ws::connection_hdl& handle) {
        const ClientId client = next_client_++;
        const Connection connection = server_.get_con_from_hdl(handle);
        connection->set_message_handler([this, client](const ws::connection_hdl&, const Server::message_ptr& message) {
            events_.received(client, message->get_payload(), message->get_opcode() == ws::frame::opcode::text);
        });
        connection->set_close_handler([this, client](const ws::connection_hdl&) { close(client); });
        clients_.emplace(client, connection);
        events_.opened(client);
    }

    void close(ClientId client) {
        clients_.erase(client);
        events_.closed(client);
        if (leaving_ && clients_.empty()) {
            server_.stop();
        }
    }

    void drop(const ws::connection_hdl& handle) {
        ws::lib::error_code ignored;
        server_.close(handle, ws::close::status::going_away, "no answer to a ping", ignored);
    }

    void schedule_tick() {
        server_.set_timer(tick_ms, [this](const ws::lib::error_code& cancelled) {
            if (!cancelled) {
                events_.tick();
                schedule_tick();
            }
        });
    }

    void schedule_pings() {
        server_.set_timer(ping_interval_ms, [this](const ws::lib::error_code& cancelled) {
            if (!cancelled) {
                for (const auto& [client, connection] : clients_) {
                    ws::lib::error_code ignored;
                    connection->ping("", ignored);
                }
                schedule_pings();
            }
        });
    }

    void say_goodbye() {
        leaving_ = true;
        if (clients_.empty()) {
            return server_.stop();
        }
        ws::lib::error_code ignored;
        server_.stop_listening(ignored);
        // iterates over a copy, because closing a connection may erase it from clients_
        for (const auto& [client, connection] : std::map(clients_)) {
            connection->close(ws::close::status::going_away, "the run is over", ignored);
        }
        server_.set_timer(goodbye_ms, [this](const ws::lib::error_code&) { server_.stop(); });
    }

    Server server_;
    std::vector<std::string> subprotocols_;
    WebSocketEvents events_;
    std::map<ClientId, Connection> clients_;
    ClientId next_client_ = 0;
    bool leaving_ = false;
    std::thread thread_;
};

WebSocketServer::WebSocketServer(const std::string& address, std::uint16_t port, std::vector<std::string> subprotocols)
    : endpoint_(std::make_unique<Endpoint>(address, port, std::move(subprotocols))) {}

WebSocketServer::~WebSocketServer() = default;

void WebSocketServer::start(WebSocketEvents events) { endpoint_->start(std::move(events)); }

std::string WebSocketServer::place() const { return endpoint_->place(); }

void WebSocketServer::post(std::function<void()> task) { endpoint_->post(std::move(task)); }

void WebSocketServer::send_text(ClientId client, const std::string& text) {
    endpoint_->send(client, text, ws::frame::opcode::text);
}

void WebSocketServer::send_binary(ClientId client, const std::string& bytes) {
    endpoint_->send(client, bytes, ws::frame::opcode::binary);
}

std::size_t WebSocketServer::unsent_bytes(ClientId client) const { return endpoint_->unsent_bytes(client); }

}  // namespace ddtool
