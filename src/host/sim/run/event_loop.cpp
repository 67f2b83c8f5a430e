// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/event_loop.hpp"

#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace canproof::host {

namespace {

Descriptor sound(int descriptor, const char* what) {
    if (descriptor < 0) {
        throw std::system_error{errno, std::generic_category(), what};
    }
    return Descriptor{descriptor};
}

std::uint32_t events_of(const Watch& watch) {
    const std::uint32_t in = watch.readable ? std::uint32_t{EPOLLIN} : 0U;
    return watch.writable ? in | std::uint32_t{EPOLLOUT} : in;
}

bool add(int epoll, int operation, int descriptor, std::uint32_t events) {
    epoll_event event{};
    event.events = events;
    event.data.fd = descriptor;
    return epoll_ctl(epoll, operation, descriptor, &event) == 0;
}

bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

EventLoop::EventLoop() {
    sigset_t ending{};
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    if (!is_ignored(SIGHUP)) {  // a signalfd receives a blocked signal even if the signal is ignored
        sigaddset(&ending, SIGHUP);
    }
    sigprocmask(SIG_BLOCK, &ending, &mask_before_);
    std::signal(SIGPIPE, SIG_IGN);
    epoll_ = sound(epoll_create1(EPOLL_CLOEXEC), "epoll");
    timer_ = sound(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC), "timerfd");
    signals_ = sound(signalfd(-1, &ending, SFD_NONBLOCK | SFD_CLOEXEC), "signalfd");
    add(epoll_.number(), EPOLL_CTL_ADD, timer_.number(), EPOLLIN);
    add(epoll_.number(), EPOLL_CTL_ADD, signals_.number(), EPOLLIN);
}

EventLoop::~EventLoop() {
    sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
}

/// Updates the set of watched descriptors. The kernel removes a closed descriptor from the set, and a new descriptor
/// can have the same number. So each descriptor is first added and, if it is already there, modified.
void EventLoop::follow(const std::vector<Watch>& watches) {
    std::vector<Known> wanted;
    for (const Watch& watch : watches) {
        wanted.push_back({watch.descriptor, events_of(watch)});
    }
    for (const Known& old : known_) {
        const bool stays = std::any_of(wanted.begin(), wanted.end(),
                                       [&](const Known& one) { return one.descriptor == old.descriptor; });
        if (!stays) {
            epoll_ctl(epoll_.number(), EPOLL_CTL_DEL, old.descriptor, nullptr);
            always_ready_.erase(old.descriptor);
        }
    }
    for (const Known& one : wanted) {
        if (!add(epoll_.number(), EPOLL_CTL_ADD, one.descriptor, one.events)) {
            if (errno == EPERM) {
                always_ready_.insert(one.descriptor);
            } else {
                add(epoll_.number(), EPOLL_CTL_MOD, one.descriptor, one.events);
            }
        }
    }
    known_ = std::move(wanted);
}

void EventLoop::arm(Duration pause) const {
    const std::uint64_t us = always_ready_.empty() ? pause.us : 0;
    itimerspec when{};
    when.it_value.tv_sec = static_cast<time_t>(us / 1000000);
    when.it_value.tv_nsec = static_cast<long>(us % 1000000) * 1000 + 1;  // the value 0 would switch the timer off
    timerfd_settime(timer_.number(), 0, &when, nullptr);
}

void EventLoop::wait(const std::vector<Watch>& watches, Duration pause) {
    follow(watches);
    arm(pause);
    std::array<epoll_event, 64> events{};
    const int count = epoll_wait(epoll_.number(), events.data(), static_cast<int>(events.size()), -1);
    ready_ = always_ready_;
    for (int i = 0; i < count; ++i) {
        const int descriptor = events[static_cast<std::size_t>(i)].data.fd;
        if (descriptor == signals_.number()) {
            signalfd_siginfo signal{};
            interrupted_ = read(signals_.number(), &signal, sizeof signal) > 0 || interrupted_;
        } else if (descriptor == timer_.number()) {
            std::uint64_t expirations = 0;
            static_cast<void>(!read(timer_.number(), &expirations, sizeof expirations));
        } else {
            ready_.insert(descriptor);
        }
    }
}

}  // namespace canproof::host
