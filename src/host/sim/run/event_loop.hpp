// Waits: for descriptors, for a time, for SIGINT, SIGTERM and SIGHUP. epoll, timerfd and signalfd; no thread.
#pragma once

#include <csignal>
#include <set>
#include <vector>

#include "host/sim/bus/bus.hpp"

namespace canproof::host {

class EventLoop {
  public:
    /// As long as it lives SIGINT, SIGTERM and SIGHUP end the loop instead of the process. A SIGHUP that is ignored, as
    /// under nohup, does nothing. Throws std::system_error.
    EventLoop();
    ~EventLoop();
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;

    /// Waits for one of `watches`, or until `pause` has passed. A regular file is always ready.
    void wait(const std::vector<Watch>& watches, Duration pause);
    /// Whether a descriptor was ready when wait() returned.
    bool is_ready(int descriptor) const { return ready_.count(descriptor) != 0; }
    bool is_interrupted() const { return interrupted_; }
    /// Another signal is awaited.
    void forget_interruption() { interrupted_ = false; }

  private:
    void follow(const std::vector<Watch>& watches);
    void arm(Duration pause) const;

    int epoll_{-1};
    int timer_{-1};
    int signals_{-1};
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
