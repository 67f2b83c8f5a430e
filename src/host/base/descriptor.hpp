// SPDX-License-Identifier: Apache-2.0
// A file descriptor with one owner at a time. The destructor of the owner closes it.
#pragma once

#include <unistd.h>

#include <utility>

namespace canproof::host {

class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_{number} {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_{other.release()} {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        if (this != &other) {
            close();
            number_ = other.release();
        }
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    /// Returns the number; from now on the caller must close the descriptor.
    int release() { return std::exchange(number_, -1); }

  private:
    void close() const {
        if (number_ >= 0) {
            ::close(number_);
        }
    }

    int number_{-1};
};

}  // namespace canproof::host
