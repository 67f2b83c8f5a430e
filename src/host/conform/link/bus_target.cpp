// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/bus_target.hpp"

#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace canproof::host::conform {

namespace {

constexpr Duration longest_wait = milliseconds(1000);

}  // namespace

BusTarget::BusTarget(std::unique_ptr<Bus> bus, std::string name)
    : bus_{std::move(bus)}, name_{std::move(name)}, start_{std::chrono::steady_clock::now()} {
    bus_->listen([this](const BusFrame& frame) {
        frame_seen_ = true;
        tell({frame.time, frame.frame, frame.sender == &tester_});
    });
    bus_->use_clock([this] { return now(); });
    bus_->attach(tester_);
}

Instant BusTarget::now() const {
    const auto passed = std::chrono::steady_clock::now() - start_;
    return Instant{static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(passed).count())};
}

void BusTarget::turn(Instant at) {
    const Instant known = bus_->poll(at);
    bus_->advance(earliest(known, at));
}

void BusTarget::send(const Frame& frame) {
    tester_.put(frame);
    turn(now());
}

void BusTarget::advance(Instant until) {
    frame_seen_ = false;
    turn(now());
    while (!frame_seen_ && now() < until) {
        wait(until, bus_->watches());
    }
}

void BusTarget::wait(Instant until, std::vector<Watch> watches) {
    const Instant due = earliest(bus_->next_deadline(), until);
    loop_.wait(watches, elapsed(now(), due));
    if (loop_.is_interrupted()) {
        throw Interrupted{};
    }
    turn(now());
}

void BusTarget::switch_by_hand(int descriptor, std::function<void(const std::string&)> say) {
    hand_ = descriptor;
    say_ = std::move(say);
}

void BusTarget::power(bool on) {
    static_cast<void>(tcflush(hand_, TCIFLUSH));  // drops an Enter that the user pressed before the question
    say_(on ? "Switch the slave on, then press Enter." : "Switch the slave off, then press Enter.");
    do {
        std::vector<Watch> watches = bus_->watches();
        watches.push_back({hand_, true, false});
        wait(now() + longest_wait, std::move(watches));
    } while (!line_came());
}

/// Returns whether the user has entered a line. Throws Interrupted when standard input has ended.
bool BusTarget::line_came() {
    if (!loop_.is_ready(hand_)) {
        return false;
    }
    std::array<char, 256> piece{};
    const ssize_t count = read(hand_, piece.data(), piece.size());
    if (count == 0) {
        say_("Standard input has ended, so nobody can confirm that the slave is switched.");
        throw Interrupted{};
    }
    const auto end = piece.begin() + std::max<ssize_t>(count, 0);
    return std::find(piece.begin(), end, '\n') != end;
}

}  // namespace canproof::host::conform
