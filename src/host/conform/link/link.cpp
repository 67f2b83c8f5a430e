// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/link.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/conform/language/value.hpp"

namespace canproof::host::conform {

namespace {

constexpr double traffic_frame_bits = 125.0;  // bits of a frame with eight data bytes, about a tenth of them stuff bits
constexpr std::uint32_t rate_when_unknown = 125000U;
constexpr std::size_t most_waiting = 64;  // while this many frames wait to be sent, no background traffic is added

// First identifiers of the background traffic. CiA 301 (7.3.5) reserves them, so few slaves use them.
constexpr std::uint32_t first_high = 0x101U;
constexpr std::uint32_t first_low = 0x6E0U;
constexpr std::uint32_t ids_of_a_kind = 0x20U;

}  // namespace

bool Watched::fits(const FrameRecord& record) const {
    const bool wanted = keys.empty() || std::any_of(keys.begin(), keys.end(),
                                                    [&](const FrameKey& one) { return one.fits(record.frame); });
    return wanted && (!counts || counts(record));
}

std::vector<std::uint64_t> Watched::gaps() const {
    std::vector<std::uint64_t> all;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        all.push_back(elapsed(frames[i - 1].time, frames[i].time).us);
    }
    return all;
}

Link::Link(Target& target) : target_{target} {
    target_.listen([this](const FrameRecord& record) { take_in(record); });
}

Link::~Link() {
    target_.listen({});
}

void Link::take_in(const FrameRecord& record) {
    use_.add(record);
    if (log_.size() < most_logged) {
        log_.push_back(record);
    }
    if (record.own) {
        const bool of_a_step = record.frame.id == last_frame_.id && record.frame.data == last_frame_.data;
        last_sent_ = of_a_step ? record.time : last_sent_;
        return;
    }
    const auto watching =
        std::find_if(watches_.rbegin(), watches_.rend(), [&](const auto& one) { return one->fits(record); });
    if (watching != watches_.rend()) {
        (*watching)->frames.push_back(record);
        return;
    }
    if (inbox_.size() < most_logged) {
        inbox_.push_back(record);
    }
}

void Link::send(const Frame& frame) {
    if (on_send_) {
        on_send_(frame);
    }
    last_sent_ = now();
    last_frame_ = frame;
    target_.send(frame);
}

Instant Link::next_background() const {
    Instant next = next_traffic_;
    for (const Produced& one : produced_) {
        next = earliest(next, one.next);
    }
    return next;
}

/// Sends the background frames that are due. Sends a repeated frame only once when several of its periods have passed.
/// Skips frames of the background traffic while too many frames wait to be sent.
void Link::send_background() {
    for (Produced& one : produced_) {
        if (one.next <= now()) {
            target_.send(one.frame);
            one.next = one.next + one.period <= now() ? now() + one.period : one.next + one.period;
        }
    }
    while (next_traffic_ <= now()) {
        if (const auto frame = target_.waiting() < most_waiting ? traffic_frame() : std::nullopt) {
            target_.send(*frame);
        }
        next_traffic_ = next_traffic_ + traffic_period_;
    }
}

/// Returns the next frame of the background traffic. Returns nothing when the slave may use all identifiers of the
/// traffic.
std::optional<Frame> Link::traffic_frame() {
    const std::uint32_t first = traffic_high_ ? first_high : first_low;
    for (std::uint32_t tried = 0; tried < ids_of_a_kind; ++tried) {
        const std::uint32_t id = first + ++traffic_number_ % ids_of_a_kind;
        if (reserved_.count(id) == 0) {
            Frame frame = data_frame(id, max_frame_length);
            frame.data.fill(static_cast<std::uint8_t>(traffic_number_ * 37U));
            return frame;
        }
    }
    return std::nullopt;
}

void Link::pass(Instant until) {
    const Instant due = earliest(until, next_background());
    target_.advance(due);
    worst_delay_.us = std::max(worst_delay_.us, elapsed(due, now()).us);
    send_background();
    if (log_.size() >= most_logged) {
        throw BrokenCase{
            fmt::format("the case has more than {} frames, which do not fit the log; shorten the case", most_logged)};
    }
}

void Link::wait_until(Instant until) {
    while (now() < until) {
        pass(until);
    }
}

bool Link::wait_for(const std::function<bool()>& done, Instant deadline) {
    while (!done() && now() < deadline) {
        pass(deadline);
    }
    return done();
}

const FrameRecord* Link::peek(const std::function<bool(const FrameRecord&)>& wanted) const {
    const auto found = std::find_if(inbox_.begin(), inbox_.end(), wanted);
    return found == inbox_.end() ? nullptr : &*found;
}

std::optional<FrameRecord> Link::take(const FrameKey& key, Instant deadline) {
    const auto fits = [&](const FrameRecord& one) { return key.fits(one.frame); };
    auto found = inbox_.end();
    const auto arrived = [&] {
        found = std::find_if(inbox_.begin(), inbox_.end(), fits);
        return found != inbox_.end();
    };
    if (!wait_for(arrived, deadline) || deadline < found->time) {
        return std::nullopt;
    }
    const FrameRecord record = *found;
    inbox_.erase(found);
    return record;
}

void Link::forget(const FrameKey& key) {
    inbox_.erase(
        std::remove_if(inbox_.begin(), inbox_.end(), [&](const FrameRecord& one) { return key.fits(one.frame); }),
        inbox_.end());
}

std::shared_ptr<const Watched> Link::watch(Watched wanted) {
    wanted.since = now();
    watches_.push_back(std::make_shared<Watched>(std::move(wanted)));
    return watches_.back();
}

void Link::end_watch(const std::shared_ptr<const Watched>& watched) {
    watches_.erase(std::remove(watches_.begin(), watches_.end(), watched), watches_.end());
}

void Link::end_watches() {
    watches_.clear();
}

void Link::produce(const Frame& frame, Duration period) {
    stop_producing(frame.id);
    if (on_send_) {
        on_send_(frame);
    }
    produced_.push_back({frame, period, now()});
    send_background();
}

void Link::stop_producing() {
    produced_.clear();
}

void Link::stop_producing(std::uint32_t id) {
    produced_.erase(
        std::remove_if(produced_.begin(), produced_.end(), [&](const Produced& one) { return one.frame.id == id; }),
        produced_.end());
}

void Link::set_traffic(double percent, bool high) {
    traffic_high_ = high;
    next_traffic_ = never;
    if (percent > 0.0) {
        const std::uint32_t rate = target_.bit_rate() == 0 ? rate_when_unknown : target_.bit_rate();
        const double seconds = traffic_frame_bits / static_cast<double>(rate) * 100.0 / percent;
        traffic_period_ = Duration{std::max<std::uint64_t>(1U, static_cast<std::uint64_t>(seconds * 1.0e6))};
        next_traffic_ = now();
    }
}

void Link::begin_case() {
    stop_producing();
    set_traffic(0.0, false);
    end_watches();
    inbox_.clear();
    log_.clear();
    worst_delay_ = {};
}

}  // namespace canproof::host::conform
