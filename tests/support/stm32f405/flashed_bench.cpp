// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/flashed_bench.hpp"

#include "tests/support/stm32f405/core_model.hpp"

namespace canproof::test {

namespace {

constexpr std::uintptr_t tim2_counter = 0x40000024;  // the main loop reads the time once, at the start of a pass
constexpr std::uintptr_t can_status = 0x40006404;    // CAN_MSR

}  // namespace

FlashedBench::FlashedBench(const FlashedImage& image) : image_{image} {
    image_.reset();
    chip.port_c.set_levels(0xFFCF);  // the switches of the CAN-CBX-AO412: node 3, 1 Mbit/s
    before_access = [this](const Access& access) { note(access); };
}

FlashedBench::~FlashedBench() {
    before_access = nullptr;
    core_model() = CoreModel{};
}

bool FlashedBench::run(std::uint32_t passes) {
    last_ = passes;
    if (setjmp(end_) != 0) {
        is_inside_ = false;
        return true;
    }
    image_.run();
    return false;
}

stm32f405::SelfTest FlashedBench::take_record() {
    return stm32f405::FailureRecord{common_store().failure.registers()}.take();
}

void FlashedBench::note(const Access& access) {
    if (is_inside_ || access.is_write) {
        return;
    }
    is_inside_ = true;
    if (access.address == tim2_counter) {
        begin_pass();
    }
    status_reads_ += access.address == can_status ? 1 : 0;
    if (on_read) {
        on_read(access.address);
    }
    is_inside_ = false;
}

/// Also counts each of the two reads of the time at the power-on of the device.
void FlashedBench::begin_pass() {
    status_reads_ = 0;
    if (passes_ == last_) {
        std::longjmp(end_, 1);
    }
    ++passes_;
    chip.tim2.at(0x24) += 100;
    chip.tim5.pass(100);
    chip.watchdog.pass(0.1);
    if (!bus_is_busy) {
        if (const auto frame = chip.can.transmit()) {
            sent_.push_back(*frame);
        }
    }
    if (on_pass) {
        on_pass();
    }
    image_.received();
}

}  // namespace canproof::test
