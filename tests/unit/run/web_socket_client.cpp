#include "web_socket_client.hpp"

#include <deque>
#include <iterator>
#include <websocketpp/client.hpp>
#include <websocketpp/config/asio_no_tls_client.hpp>

namespace ddtool::test {
namespace {

namespace ws = websocketpp;
using Client = ws::client<ws::config::asio_client>;

}  // namespace

class WebSocketClient::State {
public:
    State(const std::string& place, const std::vector<std::string>& subprotocols) {
        client_.clear_access_channels(ws::log::alevel::all);
        client_.clear_error_channels(ws::log::elevel::all);
        client_.init_asio();
        client_.set_open_handler([this](const ws::connection_hdl&) { open_ = true; });
        client_.set_fail_handler([this](const ws::connection_hdl&) { ended_ = true; });
        client_.set_close_handler([this](const ws::connection_hdl&) {
            open_ = false;
            ended_ = true;
        });
        client_.set_message_handler([this](const ws::connection_hdl&, const Client::message_ptr& message) {
            inbox_.push_back({message->get_opcode() == ws::frame::opcode::text, message->get_payload()});
        });
        connect("ws://" + place, subprotocols);
    }

    void connect(const std::string& url, const std::vector<std::string>& subprotocols) {
        ws::lib::error_code problem;
        connection_ = client_.get_connection(url, problem);
        for (const std::string& each : subprotocols) {
            connection_->add_subprotocol(each);
        }
        client_.connect(connection_);
        while (!open_ && !ended_) {
            client_.run_one();
        }
    }

    std::optional<Message> next() {
        while (inbox_.empty() && !ended_) {
            client_.run_one();
        }
        if (inbox_.empty()) {
            return std::nullopt;
        }
        Message message = std::move(inbox_.front());
        inbox_.pop_front();
        return message;
    }

    void send(const Message& message) {
        connection_->send(message.payload, message.is_text ? ws::frame::opcode::text : ws::frame::opcode::binary);
        client_.poll();
    }

    [[nodiscard]] bool is_open() const { return open_; }
    [[nodiscard]] std::string subprotocol() const { return connection_->get_response_header("Sec-WebSocket-Protocol"); }

private:
    Client client_;
    Client::connection_ptr connection_;
    std::deque<Message> inbox_;
    bool open_ = false;
    bool ended_ = false;
};

WebSocketClient::WebSocketClient(const std::string& place, const std::vector<std::string>& subprotocols)
    : state_(std::make_unique<State>(place, subprotocols)) {}
WebSocketClient::~WebSocketClient() = default;
bool WebSocketClient::is_open() const { return state_->is_open(); }
std::string WebSocketClient::subprotocol() const { return state_->subprotocol(); }
void WebSocketClient::send(const Message& message) { state_->send(message); }
std::optional<WebSocketClient::Message> WebSocketClient::next() { return state_->next(); }

std::string answer_to_raw_bytes(const std::string& place, const std::string& subprotocol, const std::string& bytes) {
    const std::size_t colon = place.rfind(':');
    asio::ip::tcp::iostream stream(place.substr(0, colon), place.substr(colon + 1));
    stream << "GET / HTTP/1.1\r\nHost: " << place << "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
           << "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           << "Sec-WebSocket-Protocol: " << subprotocol << "\r\n\r\n"
           << bytes << std::flush;
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace ddtool::test
