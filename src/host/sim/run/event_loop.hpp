// SPDX-License-Identifier: Apache-2.0
// Waits for descriptors, for a time, and for SIGINT, SIGTERM and SIGHUP. Uses epoll, timerfd and signalfd, and no
// thread.
#pragma once

#include <csignal>
#include <set>
#include <vector>

#include "host/base/descriptor.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host {

class EventLoop {
  public:
    /// As long as this object exists, SIGINT, SIGTERM and SIGHUP end the loop and not the process. A SIGHUP that is
    /// ignored, as under nohup, has no effect. Throws std::system_error.
    EventLoop();
    ~EventLoop();
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;

    /// Waits until one of `watches` is ready, `pause` has passed, or SIGINT, SIGTERM or SIGHUP arrives. A regular file
    /// is always ready.
    void wait(const std::vector<Watch>& watches, Duration pause);
    /// Returns whether a descriptor was ready when wait() last returned.
    bool is_ready(int descriptor) const { return ready_.count(descriptor) != 0; }
    bool is_interrupted() const { return interrupted_; }
    /// Clears the interruption, so that wait() can wait for the next signal.
    void forget_interruption() { interrupted_ = false; }

  private:
    void follow(const std::vector<Watch>& watches);
    void arm(Duration pause) const;

    Descriptor epoll_;
    Descriptor timer_;
    Descriptor signals_;
    struct Known {
        int descriptor;
        std::uint32_t events;
    };
    std::vector<Known> known_;
    std::set<int> always_ready_;
    std::set<int> ready_;
    bool interrupted_{false};
    sigset_t mask_before_{};
};

}  // namespace canproof::host
