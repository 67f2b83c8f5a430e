#include "host/conform/link/bus_target.hpp"

namespace canproof::host::conform {

BusTarget::BusTarget(std::unique_ptr<Bus> bus, std::string name, bool remote_frames)
    : bus_{std::move(bus)},
      name_{std::move(name)},
      remote_frames_{remote_frames},
      start_{std::chrono::steady_clock::now()} {
    bus_->listen([this](const BusFrame& frame) {
        frame_seen_ = true;
        tell({frame.time, frame.frame, frame.sender == &tester_});
    });
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
        const Instant due = earliest(bus_->next_deadline(), until);
        loop_.wait(bus_->watches(), elapsed(now(), due));
        if (loop_.is_interrupted()) {
            throw Interrupted{};
        }
        turn(now());
    }
}

}  // namespace canproof::host::conform
