// SPDX-License-Identifier: Apache-2.0
// Runs an AX130751: writes parameters, sends frames, changes inputs and lets time pass. Records the frames that the
// device sends, and its outputs.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "properties/devices/ax130751/naive_errors.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"

namespace canproof::test {

class DrivenDevice {
  public:
    DrivenDevice() {
        bench_.power_on_silently();
        collect();
    }

    /// Writes by SDO. Returns 0 on success, the abort code of a refusal, or FFFFFFFFh when there is no answer.
    std::uint32_t write(int index, int sub, std::uint32_t value, int bytes) {
        const auto byte = [](auto number, unsigned at) { return static_cast<int>(number >> (8U * at) & 0xFFU); };
        const auto address = static_cast<unsigned>(index);
        answer_ = Frame{};
        receive(0x600 + node,
                {0x23 + 4 * (4 - bytes), byte(address, 0), byte(address, 1), sub, byte(value, 0),
                 bytes > 1 ? byte(value, 1) : 0, bytes > 2 ? byte(value, 2) : 0, bytes > 3 ? byte(value, 3) : 0});
        if (answer_.data[0] == 0x60) {
            return 0;
        }
        std::uint32_t code = 0;
        for (std::size_t i = 8; i > 4; --i) {
            code = code << 8U | answer_.data.at(i - 1);
        }
        return answer_.data[0] == 0x80 ? code : ~std::uint32_t{0};
    }
    void receive(unsigned id, const std::vector<int>& bytes) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(bytes.size()));
        std::transform(bytes.begin(), bytes.end(), frame.data.begin(),
                       [](int byte) { return static_cast<std::uint8_t>(byte); });
        bench_.device->receive(frame, bench_.now);
        collect();
    }
    void inputs(const naive_ax130751::Inputs& inputs) {
        bench_.inputs.supply = inputs.supply;
        bench_.inputs.cpu_temperature = inputs.temperature;
        bench_.inputs.load = inputs.load;
        bench_.device->set_inputs(bench_.inputs, bench_.now);
        collect();
    }
    void pass(int ms) {
        const Instant end = bench_.now + milliseconds(static_cast<std::uint64_t>(ms));
        while (bench_.device->next_deadline() <= end) {
            bench_.now =
                std::max(bench_.now, bench_.device->next_deadline(), [](Instant a, Instant b) { return a.us < b.us; });
            bench_.device->advance(bench_.now);
            collect();
        }
        bench_.now = end;
    }
    /// Returns the value of a dictionary entry as a bit pattern.
    std::uint64_t read(int index, int sub) const {
        return bench_.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    }
    const ax130751::Device& device() const { return *bench_.device; }

    /// The frames that the device has sent since the test last cleared this list, except answers of the SDO server.
    std::vector<naive_ax130751::Said> said;

    static constexpr unsigned node = 127;

  private:
    struct Bench : Ax130751Bench {
        void power_on_silently() {
            queue = TransmitQueue{};
            device = std::make_unique<ax130751::Device>(memory, queue, factory);
            device->power_on(inputs, now);
        }
    };

    void collect() {
        while (!bench_.queue.empty()) {
            const Frame frame = bench_.queue.pop();
            if (frame.id == 0x580 + node) {
                answer_ = frame;
            } else {
                said.push_back(
                    {bench_.now.us / 1000, frame.id, {frame.data.begin(), frame.data.begin() + frame.length}});
            }
        }
    }

    Bench bench_;
    Frame answer_{};
};

}  // namespace canproof::test
