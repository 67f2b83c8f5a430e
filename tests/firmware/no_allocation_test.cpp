// SPDX-License-Identifier: Apache-2.0
// Tests that nothing allocates memory after the start: the test runs a session that uses every CANopen service while
// every allocation fails.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/memory.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/slave_bench.hpp"

namespace {

bool allocation_fails{false};
int refused{0};

bool may_allocate() {
    if (allocation_fails) {
        ++refused;
        return false;
    }
    return true;
}

}  // namespace

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define CANPROOF_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CANPROOF_SANITIZED
#endif

// A sanitizer has its own malloc(), so with a sanitizer the test monitors only operator new.
#if !defined(CANPROOF_SANITIZED)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);

void* malloc(std::size_t size) {
    return may_allocate() ? __libc_malloc(size) : nullptr;
}
void* calloc(std::size_t count, std::size_t size) {
    return may_allocate() ? __libc_calloc(count, size) : nullptr;
}
void* realloc(void* old, std::size_t size) {
    return may_allocate() ? __libc_realloc(old, size) : nullptr;
}
}
#endif

namespace {

void* allocate(std::size_t size) {
    void* const memory = allocation_fails ? nullptr : std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) {
        ++refused;
        throw std::bad_alloc{};
    }
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace canproof::test {

namespace {

/// Makes every allocation fail during its lifetime.
class FailingAllocator {
  public:
    FailingAllocator() {
        refused = 0;
        allocation_fails = true;
    }
    ~FailingAllocator() { allocation_fails = false; }
    FailingAllocator(const FailingAllocator&) = delete;
    FailingAllocator& operator=(const FailingAllocator&) = delete;
};

/// The received answers, counted without a container: SDO answers and aborts, and all other frames.
struct Tally {
    int sdo_answers{0};
    int sdo_aborts{0};
    int others{0};
};

void count(TransmitQueue& queue, Tally& tally) {
    while (!queue.empty()) {
        const Frame frame = queue.pop();
        const bool is_sdo = (frame.id & 0x780U) == 0x580U;
        const bool is_abort = is_sdo && frame.data[0] == 0x80;
        tally.sdo_answers += is_sdo ? 1 : 0;
        tally.sdo_aborts += is_abort ? 1 : 0;
        tally.others += is_sdo ? 0 : 1;
    }
}

std::vector<Frame> parsed(const std::vector<std::string>& lines) {
    std::vector<Frame> frames;
    for (const auto& line : lines) {
        frames.push_back(host::parse_frame(line, "test"));
    }
    return frames;
}

/// Sends `frames` 100 ms apart and calls the device at each of its deadlines. Then lets 5 s pass without received
/// frames.
template <typename Device>
Tally session(Device& device, TransmitQueue& queue, const std::vector<Frame>& frames, Instant now) {
    Tally tally;
    const FailingAllocator none;
    const auto let_pass = [&](Duration length) {
        const Instant end = now + length;
        while (device.next_deadline() <= end) {
            now = device.next_deadline() < now ? now : device.next_deadline();
            device.advance(now);
            count(queue, tally);
        }
        now = end;
    };
    for (const Frame& frame : frames) {
        device.receive(frame, now);
        count(queue, tally);
        let_pass(milliseconds(100));
    }
    let_pass(milliseconds(5000));
    return tally;
}

}  // namespace

TEST(NoAllocation, HeapAllocationFailsWhileAllocationIsForbidden) {
    shows_rule("nothing is taken from the heap after start");
    int caught = 0;
    {
        const FailingAllocator none;
        try {
            void* const memory = ::operator new(1000);
            ::operator delete(memory);
        } catch (const std::bad_alloc&) {
            ++caught;
        }
#if !defined(CANPROOF_SANITIZED)
        void* volatile memory = std::malloc(1000);
        caught += memory == nullptr ? 1 : 0;
        std::free(memory);
#else
        ++caught;
#endif
    }
    EXPECT_EQ(caught, 2);
    EXPECT_GE(refused, 1);
}

TEST(NoAllocation, SlaveWithEveryServiceAllocatesNothingAfterStart) {
    shows_rule("nothing is taken from the heap after start");
    SlaveBench bench;
    bench.device->take_domain_memory();
    const auto frames = parsed({
        // SDO requests: expedited, segmented and block transfers in both directions, refused, aborted and stalled ones
        "605#4000100000000000",
        "605#2B00220064000000",
        "605#2B00220065000000",
        "605#4008100000000000",
        "605#6000000000000000",
        "605#7000000000000000",
        "605#6000000000000000",
        "605#210023000A000000",
        "605#0061626364656667",
        "605#1968696A00000000",
        "605#C600240009000000",
        "605#0131323334353637",
        "605#8238390000000000",
        "605#D5C3310000000000",
        "605#A40024007F000000",
        "605#A300000000000000",
        "605#A2017F0000000000",
        "605#A2017F0000000000",
        "605#A100000000000000",
        "605#C600240009000000",
        "605#0131323334353637",
        "605#8000240000000008",
        "605#FF00000000000000",
        // frames for heartbeat producer and consumer, node guarding, SYNC and the EMCY inhibit time
        "605#23161001C8000900",
        "605#2B171000C8000000",
        "709#05",
        "605#2B171000000000",
        "605#2B17100000000000",
        "605#2B0C100064000000",
        "605#2F0D100003000000",
        "705#R",
        "705#R",
        "605#2B15100064000000",
        "605#2305100080000000",
        // PDOs: a new mapping, start, RPDOs that take effect at once or with SYNC, a TPDO sent on change, a too short
        // RPDO
        "605#2300140105020080",
        "605#2F00160000000000",
        "605#2300160108010020",
        "605#2F00160001000000",
        "605#2300140105020000",
        "000#0105",
        "205#AA",
        "305#0102030405060708",
        "305#01",
        "080#",
        "080#01",
        "605#2F01200155000000",
        "185#R",
        "285#R",
        // frames that store and restore parameters, reset the node and stop it
        "605#2310100173617665",
        "605#231110016C6F6164",
        "000#8205",
        "000#8105",
        "000#0105",
        "000#0205",
        "000#8005",
        // frames of LSS: selection, inquiry, identification, Fastscan
        "7E5#0401000000000000",
        "7E5#5A00000000000000",
        "7E5#5E00000000000000",
        "7E5#1107000000000000",
        "7E5#1300040000000000",
        "7E5#1700000000000000",
        "7E5#0400000000000000",
        "7E5#405F000000000000",
        "7E5#41010302AA000000",
        "7E5#4202000100000000",
        "7E5#4321112620000000",
        "7E5#4C00000000000000",
        "7E5#5100000000800000",
    });
    bench.device->fill(SlaveBench::program_index, 0, {1, 2, 3});
    const Tally tally = session(*bench.device, bench.queue, frames, bench.now);
    EXPECT_EQ(refused, 0);
    // the session took place: most SDO requests were confirmed, and the other services sent frames
    EXPECT_GE(tally.sdo_answers, 35);
    EXPECT_LE(tally.sdo_aborts, 12);
    EXPECT_GE(tally.others, 12);
}

TEST(NoAllocation, CanCbxAo412AllocatesNothingAfterStart) {
    shows_rule("nothing is taken from the heap after start");
    host::Memory memory{1024};
    TransmitQueue queue;
    cbx_ao412::Device device{memory, queue, cbx_ao412::FactoryData{}};
    const auto frames = parsed({"000#0103", "603#4008100000000000", "603#6000000000000000", "603#7000000000000000",
                                "603#2B171000C8000000", "203#0102030405060708", "603#2F43640102000000", "080#",
                                "603#2310100173617665", "603#2B116401FF7F0000", "703#R", "000#8103"});
    {
        const FailingAllocator none;
        device.power_on(cbx_ao412::Inputs{}, Instant{});
    }
    EXPECT_EQ(refused, 0);
    Tally start;
    count(queue, start);
    const Tally tally = session(device, queue, frames, Instant{});
    EXPECT_EQ(refused, 0);
    EXPECT_GE(tally.sdo_answers, 6);
    EXPECT_GE(tally.others, 2);
}

}  // namespace canproof::test
