// SPDX-License-Identifier: Apache-2.0
// A test fixture (bench) that reads and writes the objects of its device by SDO.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "tests/support/frame_bench.hpp"

namespace canproof::test {

/// The result of an SDO access: the value and the value's length in bytes, or the abort code.
struct SdoAnswer {
    std::uint32_t abort{0xFFFFFFFF};  ///< 0 on success; FFFFFFFFh when no answer came
    std::uint32_t value{0};
    int size{0};

    float real() const {
        float number = 0.0F;
        std::memcpy(&number, &value, sizeof number);
        return number;
    }
    std::int16_t word() const { return static_cast<std::int16_t>(value); }
};

/// A device of type `Device` with node-ID `node`.
template <typename Device, typename Inputs, typename FactoryData>
class DeviceBench : public UnitBench<Device, Inputs, FactoryData> {
  public:
    DeviceBench(std::size_t memory_size, int node_id)
        : UnitBench<Device, Inputs, FactoryData>{memory_size}, node{node_id} {}

    SdoAnswer read(int index, int sub = 0) {
        return answer_of(this->send(
            fmt::format("{:03X}#40{:02X}{:02X}{:02X}00000000", 0x600 + node, index & 0xFF, index >> 8, sub)));
    }
    /// Writes `size` bytes of `value`. Returns the abort code, or 0 on success.
    std::uint32_t write(int index, int sub, int size, std::uint32_t value) {
        const int command = 0x23 | ((4 - size) << 2);
        return answer_of(this->send(fmt::format("{:03X}#{:02X}{:02X}{:02X}{:02X}{}", 0x600 + node, command,
                                                index & 0xFF, index >> 8, sub, little_endian(value))))
            .abort;
    }
    std::uint32_t write_real(int index, int sub, float value) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        return write(index, sub, 4, bits);
    }

    static std::string little_endian(std::uint32_t value) {
        return fmt::format("{:02X}{:02X}{:02X}{:02X}", value & 0xFF, (value >> 8) & 0xFF, (value >> 16) & 0xFF,
                           value >> 24);
    }

    int node;

  private:
    /// Returns the SDO answer found in `frames`; other frames are skipped.
    SdoAnswer answer_of(const Frames& frames) const {
        SdoAnswer answer;
        const std::string id = fmt::format("{:03X}#", 0x580 + node);
        for (const auto& text : frames) {
            if (text.rfind(id, 0) != 0) {
                continue;
            }
            const auto frame = host::parse_frame(text, "answer");
            answer.value = read_u32(frame.payload(), 4);
            const int command = frame.data[0];
            answer.abort = command == 0x80 ? answer.value : 0;
            answer.size = (command & 0xE0) == 0x40 ? 4 - ((command >> 2) & 3) : 0;
        }
        return answer;
    }
};

}  // namespace canproof::test
