// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_client_bus.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_bus.hpp"
#include "host/sim/bus/stamped_read.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t lines_held = 256;  // number of frames of put() that can wait
constexpr std::size_t piece_size = 16384;
constexpr Duration load_window = milliseconds(1000);

std::string name_of(const SocketcandPlace& place) {
    return fmt::format("{}:{}/{}", place.host, place.port, place.bus);
}

[[noreturn]] void refuse(const SocketcandPlace& place, const std::string& why) {
    throw InputError{
        fmt::format("cannot join {} ({}); start this socketcand server or name another, as in --bus "
                    "socketcand-client:127.0.0.1:29536/can0",
                    name_of(place), why)};
}

bool must_wait() {
    return errno == EAGAIN || errno == EINPROGRESS;
}

}  // namespace

SocketcandPlace parse_socketcand_place(const std::string& text) {
    SocketcandPlace place;
    const auto slash = std::min(text.find('/'), text.size());
    const ListenAddress address = parse_listen_address(text.substr(0, slash));
    place.host = address.host;
    place.port = address.port;
    if (slash != text.size()) {
        place.bus = text.substr(slash + 1);
    }
    const bool sound = !place.bus.empty() && place.bus.find_first_of("<> \t/") == std::string::npos && place.port != 0;
    if (!sound) {
        throw InputError{
            fmt::format("`{}` names no bus of a server; write socketcand-client:127.0.0.1:29536/can0", text)};
    }
    return place;
}

SocketcandClientBus::SocketcandClientBus(SocketcandPlace place, std::uint32_t bit_rate, Instant now)
    : place_{std::move(place)}, bit_rate_{bit_rate == 0 ? 125000U : bit_rate} {
    addrinfo wish{};
    wish.ai_socktype = SOCK_STREAM;
    wish.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const int unknown = getaddrinfo(place_.host.c_str(), std::to_string(place_.port).c_str(), &wish, &found);
    if (unknown != 0) {
        refuse(place_, gai_strerror(unknown));
    }
    std::memcpy(&address_, found->ai_addr, found->ai_addrlen);
    address_size_ = found->ai_addrlen;
    freeaddrinfo(found);
    connect_to_server(now);
}

SocketcandClientBus::~SocketcandClientBus() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

void SocketcandClientBus::connect_to_server(Instant now) {
    look_at_ = never;
    join_by_ = now + join_limit;
    complaint_told_.clear();
    client_.emplace(place_.bus, [this](const Frame& frame) { arrived_.push_back({read_at_, frame}); });
    descriptor_ = socket(address_.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (descriptor_ < 0) {
        lose_server(std::strerror(errno), now);
        return;
    }
    int on = 1;
    static_cast<void>(setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on));  // a failure is ignored
    ask_for_stamps(descriptor_);
    connecting_ = connect(descriptor_, reinterpret_cast<const sockaddr*>(&address_), address_size_) == 0 || must_wait();
    if (!connecting_) {
        lose_server(std::strerror(errno), now);
    }
}

void SocketcandClientBus::lose_server(const std::string& why, Instant now) {
    if (descriptor_ >= 0) {
        close(descriptor_);
        descriptor_ = -1;
    }
    if (!joined_once_) {
        refuse(place_, why);
    }
    if (has_joined()) {
        notice(fmt::format("{} is gone ({}); looking for it", name_of(place_), why));
        tell_state(CanState::bus_off, now);
    }
    client_.reset();
    connecting_ = false;
    join_by_ = never;
    look_at_ = now + search_period;
}

void SocketcandClientBus::tell_state(CanState state, Instant now) {
    for (const Node& one : nodes_) {
        one.node->set_can_state(state, now);
    }
}

std::vector<Watch> SocketcandClientBus::watches() const {
    if (descriptor_ < 0) {
        return {};
    }
    return {{descriptor_, !connecting_ && arrived_.size() < most_arrived, connecting_ || !client_->output().empty()}};
}

Instant SocketcandClientBus::poll(Instant now) {
    polled_at_ = now;
    if (look_at_ <= now) {
        connect_to_server(now);
    }
    if (connecting_) {
        write_server();
    }
    if (!connecting_) {
        read_server(now);
    }
    look_at_joining(now);
    if (has_joined() && client_->complaint() != complaint_told_) {
        complaint_told_ = client_->complaint();
        notice(fmt::format("{} reports: {}", name_of(place_), complaint_told_));
    }
    write_server();
    return now;
}

/// Completes a connection. The connection is established when the socket becomes writable without an error.
void SocketcandClientBus::finish_connecting() {
    sockaddr_storage peer{};
    socklen_t size = sizeof peer;
    int error = 0;
    socklen_t error_size = sizeof error;
    getsockopt(descriptor_, SOL_SOCKET, SO_ERROR, &error, &error_size);
    if (error != 0) {
        lose_server(std::strerror(error), polled_at_);
    } else {
        connecting_ = getpeername(descriptor_, reinterpret_cast<sockaddr*>(&peer), &size) != 0;
    }
}

void SocketcandClientBus::read_server(Instant now) {
    std::array<char, piece_size> piece{};
    arrival_clock().compare(now, kernel_realtime_ns);
    while (descriptor_ >= 0 && arrived_.size() < most_arrived) {
        const StampedRead got = receive_stamped(descriptor_, piece.data(), piece.size());
        if (got.count > 0) {
            read_at_ = std::max(arrival_clock().of_read(got.stamp_ns, now), advanced_to_);
            client_->take({piece.data(), static_cast<std::size_t>(got.count)});
        } else if (got.count == 0) {
            lose_server(client_->complaint().empty() ? "the server has closed the connection" : client_->complaint(),
                        now);
        } else if (must_wait()) {
            return;
        } else {
            lose_server(std::strerror(errno), now);
        }
    }
}

void SocketcandClientBus::look_at_joining(Instant now) {
    if (join_by_ == never) {  // no connection attempt is active
        return;
    }
    if (client_->has_joined()) {
        join_by_ = never;
        if (joined_once_) {
            notice(fmt::format("{} is joined again", name_of(place_)));
            tell_state(CanState::error_active, now);
        }
        joined_once_ = true;
    } else if (client_->is_refused()) {
        lose_server(client_->complaint(), now);
    } else if (join_by_ <= now) {
        lose_server(fmt::format("the server did not let this program join within {} s", join_limit.us / 1000000U), now);
    }
}

void SocketcandClientBus::write_server() {
    if (connecting_) {
        finish_connecting();
    }
    if (descriptor_ < 0 || connecting_ || client_->output().empty()) {
        return;
    }
    const std::string& text = client_->output();
    const ssize_t count = ::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL);
    if (count > 0) {
        client_->sent(static_cast<std::size_t>(count));
    } else if (!must_wait()) {
        lose_server(std::strerror(errno), polled_at_);
    }
}

bool SocketcandClientBus::put(const Frame& frame, Instant) {
    if (outside_.size() == lines_held) {
        return false;
    }
    outside_.push_back(frame);
    return true;
}

BusNode* SocketcandClientBus::next_sender() const {
    BusNode* best = nullptr;
    for (const Node& one : nodes_) {
        const Frame* const frame = one.node->next_frame();
        if (frame != nullptr && (best == nullptr || arbitration_rank(*frame) < arbitration_rank(*best->next_frame()))) {
            best = one.node;
        }
    }
    return best;
}

void SocketcandClientBus::advance(Instant now) {
    advanced_to_ = now;
    for (; !arrived_.empty() && arrived_.front().time <= now; arrived_.pop_front()) {
        deliver(arrived_.front().frame, nullptr, arrived_.front().time);
    }
    if (client_ && client_->may_send() && may_send_from_ <= now && any_frame_waits()) {
        send_one(now);
    }
    follow_bit_rates();
    while (!busy_.empty() && busy_.front().end + load_window < now) {
        busy_.pop_front();
    }
    write_server();
}

/// Sends the waiting frame that wins the arbitration. Frames of the user take part in it like those of a node.
void SocketcandClientBus::send_one(Instant now) {
    BusNode* const sender = next_sender();
    const bool from_outside = !outside_.empty() && (sender == nullptr || arbitration_rank(outside_.front()) <
                                                                             arbitration_rank(*sender->next_frame()));
    const Frame frame = from_outside ? outside_.front() : *sender->next_frame();
    if (from_outside) {
        outside_.pop_front();
    } else {
        sender->take_frame();
    }
    const std::uint64_t bits = frame_bits(frame) + intermission_bits;
    may_send_from_ = now + Duration{(bits * 1000000U + bit_rate_ - 1U) / bit_rate_};
    if (frame.remote && !remote_frame_told_) {
        remote_frame_told_ = true;
        notice(
            fmt::format("{} is a remote frame, which socketcand's protocol does not have: the server does not get it; "
                        "node guarding by or of another program needs --bus socketcan:vcan0",
                        format_frame(frame)));
    }
    if (!frame.remote) {
        client_->send(frame);
    }
    deliver(frame, from_outside ? nullptr : sender, now);
}

void SocketcandClientBus::deliver(const Frame& frame, const BusNode* sender, Instant now) {
    ++frames_;
    const std::uint64_t bits = frame_bits(frame) + intermission_bits;
    busy_.push_back({now, now + Duration{bits * 1000000U / bit_rate_}});
    tell(BusFrame{now, frame, sender});
    for (const Node& one : nodes_) {
        if (one.node != sender) {
            one.node->receive(frame, now);
        }
    }
}

void SocketcandClientBus::follow_bit_rates() {
    for (Node& one : nodes_) {
        const std::uint32_t rate = one.node->bit_rate();
        if (rate != one.bit_rate && rate != 0) {
            notice(fmt::format("{}: LSS sets {} bit/s; the bus behind {} keeps its bit rate", one.node->name(), rate,
                               name_of(place_)));
        }
        one.bit_rate = rate;
    }
}

Instant SocketcandClientBus::next_deadline() const {
    Instant next = earliest(join_by_, look_at_);
    if (!arrived_.empty()) {
        next = earliest(next, arrived_.front().time);
    }
    const bool sends = client_ && client_->may_send() && any_frame_waits();
    return sends ? earliest(next, may_send_from_) : next;
}

BusReport SocketcandClientBus::report(Instant now) const {
    std::uint64_t used = 0;
    for (const Busy& one : busy_) {
        used += now <= one.end + load_window ? elapsed(one.start, one.end).us : 0U;
    }
    BusReport report;
    report.frames = frames_;
    report.load = static_cast<double>(used) / static_cast<double>(load_window.us);
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
