// A memory with the faults that a power cut does not show.
#pragma once

#include <cstddef>
#include <vector>

#include "host/sim/devices/memory.hpp"

namespace canproof::test {

/// Sound as long as nothing is asked of it.
class FaultyMemory final : public NonVolatileMemory {
  public:
    explicit FaultyMemory(std::size_t size) : sound{size} {}

    std::size_t size() const override { return sound.size(); }
    /// Delivers the bytes even when it says that it failed: only the answer tells.
    bool read(const std::size_t at, const MutableBytes to) const override {
        ++reads;
        return sound.read(at, to) && reads != failing_read;
    }
    /// A worn memory takes every write and keeps none. A write that fails is kept all the same.
    bool write(const std::size_t at, const ByteView bytes) override {
        ++writes;
        return (worn || sound.write(at, bytes)) && writes != failing_write;
    }

    /// A commit that fails leaves what the last successful one left.
    bool commit() override {
        ++commits;
        if (commits == failing_commit) {
            sound.bytes() = committed;
            return false;
        }
        committed = sound.bytes();
        return true;
    }

    /// The n-th read from now on fails, the others succeed.
    void fail_read(const std::size_t n) {
        reads = 0;
        failing_read = n;
    }

    /// The same for writes.
    void fail_write(const std::size_t n) {
        writes = 0;
        failing_write = n;
    }

    /// The same for commits.
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
