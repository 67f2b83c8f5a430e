// SPDX-License-Identifier: Apache-2.0
// A non-volatile memory whose reads, writes and commits can fail. It does not model a power cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/sim/devices/memory.hpp"

namespace canproof::test {

/// A memory that works without faults until the test sets a fault.
class FaultyMemory final : public NonVolatileMemory {
  public:
    explicit FaultyMemory(std::size_t size) : sound{size} {}

    std::size_t size() const override { return sound.size(); }
    /// Reads bytes. A read that fails still delivers the right bytes, so that only the return value shows the failure.
    bool read(const std::size_t at, const MutableBytes to) const override {
        ++reads;
        return sound.read(at, to) && reads != failing_read;
    }
    /// Writes bytes. A memory set to `worn` reports success and stores nothing.
    bool write(const std::size_t at, const ByteView bytes) override {
        ++writes;
        if (writes == failing_write) {
            static_cast<void>(sound.write(at, bytes.part(0, stored_of_failing)));
            return false;
        }
        return worn || sound.write(at, bytes);
    }

    /// Commits all writes. A commit that fails restores the content of the last successful commit.
    bool commit() override {
        ++commits;
        if (commits == failing_commit) {
            sound.bytes() = committed;
            return false;
        }
        committed = sound.bytes();
        return true;
    }

    /// Makes the n-th read after this call fail. All other reads succeed.
    void fail_read(const std::size_t n) {
        reads = 0;
        failing_read = n;
    }

    /// Makes the n-th write after this call fail. All other writes succeed. The failing write stores its first `stored`
    /// bytes.
    void fail_write(const std::size_t n, const std::size_t stored = SIZE_MAX) {
        writes = 0;
        failing_write = n;
        stored_of_failing = stored;
    }

    /// Makes the n-th commit after this call fail. All other commits succeed.
    void fail_commit(const std::size_t n) {
        commits = 0;
        failing_commit = n;
    }

    host::Memory sound;
    bool worn{false};
    std::size_t failing_read{0};
    mutable std::size_t reads{0};
    std::size_t failing_write{0};
    std::size_t stored_of_failing{SIZE_MAX};
    std::size_t writes{0};
    std::size_t failing_commit{0};
    std::size_t commits{0};
    std::vector<std::uint8_t> committed{sound.bytes()};
};

}  // namespace canproof::test
