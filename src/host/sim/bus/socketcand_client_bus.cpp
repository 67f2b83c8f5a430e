// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_client_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/base/input_error.hpp"
#include "host/base/tcp_socket.hpp"
#include "host/sim/bus/can_bits.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_bus.hpp"
#include "host/sim/bus/stamped_read.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t lines_held = 256;  // number of frames of put() that can wait
constexpr std::size_t piece_size = 16384;
constexpr std::uint64_t ns_per_us = 1000;

std::string name_of(const SocketcandPlace& place) {
    return fmt::format("{}:{}/{}", place.host, place.port, place.bus);
}

AddressUse joining(const SocketcandPlace& place) {
    return {"join " + name_of(place),
            "start this socketcand server or name another, as in --bus socketcand-client:127.0.0.1:29536/can0"};
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
    : place_{std::move(place)},
      bit_rate_{bit_rate == 0 ? 125000U : bit_rate},
      address_{find_address(place_.host, place_.port, HostForm::name_or_number, joining(place_))} {
    connect_to_server(now);
}

void SocketcandClientBus::connect_to_server(Instant now) {
    look_at_ = never;
    join_by_ = now + join_limit;
    complaint_told_.clear();
    client_.emplace(place_.bus, [this](const Frame& frame) { arrived_.push_back({read_at_, frame}); });
    StartedConnection started = start_connecting(address_);
    socket_ = std::move(started.socket);
    connecting_ = socket_.is_open();
    if (connecting_) {
        ask_for_stamps(socket_.number());
    } else {
        lose_server(std::strerror(started.error), now);
    }
}

void SocketcandClientBus::lose_server(const std::string& why, Instant now) {
    socket_ = {};
    if (!joined_once_) {
        refuse_address(joining(place_), why);
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
    if (!socket_.is_open()) {
        return {};
    }
    return {
        {socket_.number(), !connecting_ && arrived_.size() < most_arrived, connecting_ || !client_->output().empty()}};
}

Instant SocketcandClientBus::poll(Instant now) {
    polled_at_ = now;
    if (look_at_ <= now) {
        connect_to_server(now);
    }
    if (connecting_) {
        finish_connecting();
    }
    read_server(now);
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
    const ConnectionState state = connection_state(socket_);
    connecting_ = !state.established;
    if (state.error != 0) {
        lose_server(std::strerror(state.error), polled_at_);
    }
}

void SocketcandClientBus::read_server(Instant now) {
    std::array<char, piece_size> piece{};
    arrival_clock().compare(now, kernel_realtime_ns);
    while (socket_.is_open() && arrived_.size() < most_arrived) {
        const StampedRead got = receive_stamped(socket_.number(), piece.data(), piece.size());
        if (got.count > 0) {
            read_at_ = std::max(arrival_clock().of_read(got.stamp_ns, now), advanced_to_);
            client_->take({piece.data(), static_cast<std::size_t>(got.count)});
        } else if (got.count == 0) {
            lose_server(client_->complaint().empty() ? "the server has closed the connection" : client_->complaint(),
                        now);
        } else if (errno == EAGAIN) {
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
    if (!client_ || client_->output().empty()) {
        return;  // there is no text before the server has answered
    }
    if (const auto count = send_some(socket_, client_->output())) {
        client_->sent(*count);
    } else {
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
    load_.add(now.us * ns_per_us, now.us * ns_per_us + frame_time_ns(frame, bit_rate_));
    ++frames_;
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
    BusReport report;
    report.frames = frames_;
    report.load = load_.at(now.us * ns_per_us, now.us * ns_per_us);
    report.bit_rate = bit_rate_;
    return report;
}

}  // namespace canproof::host
