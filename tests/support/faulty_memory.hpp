// SPDX-License-Identifier: Apache-2.0
// A memory with faults other than a power cut.
#pragma once

#include <cstddef>
#include <vector>

#include "host/sim/devices/memory.hpp"

namespace canproof::test {

/// Works without faults until a test selects a fault.
class FaultyMemory final : public NonVolatileMemory {
  public:
    explicit FaultyMemory(std::size_t size) : sound{size} {}

    std::size_t size() const override { return sound.size(); }
    /// Delivers the bytes even when it fails, so that only the return value shows the failure.
    bool read(const std::size_t at, const MutableBytes to) const override {
        ++reads;
        return sound.read(at, to) && reads != failing_read;
    }
    /// A worn memory accepts every write and stores nothing. A write that fails stores its bytes all the same.
    bool write(const std::size_t at, const ByteView bytes) override {
        ++writes;
        return (worn || sound.write(at, bytes)) && writes != failing_write;
    }

    /// A commit that fails restores the state of the last successful commit.
    bool commit() override {
        ++commits;
        if (commits == failing_commit) {
            sound.bytes() = committed;
            return false;
        }
        committed = sound.bytes();
        return true;
    }

    /// Lets the n-th read from now on fail. All others succeed.
    void fail_read(const std::size_t n) {
        reads = 0;
        failing_read = n;
    }

    /// Lets the n-th write from now on fail. All others succeed.
    void fail_write(const std::size_t n) {
        writes = 0;
        failing_write = n;
    }

    /// Lets the n-th commit from now on fail. All others succeed.
    void fail_commit(const std::size_t n) {
        commits = 0;
        failing_commit = n;
    }

    host::Memory sound;
    bool worn{false};
    std::size_t failing_read{0};
    mutable std::size_t reads{0};
    std::size_t failing_write{0};
    std::size_t writes{0};
    std::size_t failing_commit{0};
    std::size_t commits{0};
    std::vector<std::uint8_t> committed{sound.bytes()};
};

}  // namespace canproof::test
