// SPDX-License-Identifier: Apache-2.0
// The process that emulates a microcontroller. The process ends when the object that owns it is destroyed.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <utility>

#include "host/base/child_process.hpp"

namespace canproof::host {

class Emulator {
  public:
    /// Makes an object that owns no process.
    Emulator() = default;
    explicit Emulator(pid_t process) : process_{process} {}
    ~Emulator() {
        if (process_ > 0) {
            kill(process_, SIGKILL);  // the emulator has no data that an orderly end would save
            reap_process(process_);
        }
    }
    Emulator(Emulator&& other) noexcept : process_{std::exchange(other.process_, -1)} {}
    Emulator(const Emulator&) = delete;
    Emulator& operator=(const Emulator&) = delete;

  private:
    pid_t process_{-1};
};

}  // namespace canproof::host
