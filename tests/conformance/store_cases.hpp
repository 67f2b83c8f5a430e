// SPDX-License-Identifier: Apache-2.0
// The fixture for tests of storing. It has a CAN-CBX-AO412 as node 3 with its memory, and sets one value of each
// parameter group.
#pragma once

#include <algorithm>
#include <array>

#include "tests/devices/cbx-ao412/bench.hpp"

namespace canproof::test {

class Store : public CbxTest {
  protected:
    // 1017h (communication), 2404h:1 (manufacturer) and 6411h:1 (application): one value of each group.
    void set_values(const std::string& value) {
        write("603#2B171000" + value + "0000");
        write("603#2B042401" + value + "0000");
        write("603#2B116401" + value + "0000");
    }
    std::string values() {
        std::string all;
        for (const char* object : {"171000", "042401", "116401"}) {
            all += send(std::string{"603#40"} + object + "00000000").at(0).substr(12, 4) + " ";
        }
        return all;
    }
    /// Powers on a new device that uses the memory `other`.
    Frames power_on_with(NonVolatileMemory& other) {
        queue = TransmitQueue{};
        device = std::make_unique<cbx_ao412::Device>(other, queue, factory);
        device->power_on(inputs, now);
        forget_settings();
        return sent();
    }
    std::string save() { return send("603#2310100173617665").at(0); }

    // Offsets of the fields in the header of a bank. The fields are little-endian.
    static constexpr std::size_t magic_at = 0;
    static constexpr std::size_t layout_at = 4;
    static constexpr std::size_t sequence_at = 8;

    static constexpr const char* saved = "583#6010100100000000";
    static constexpr const char* hardware_error = "583#8010100100000606";

    /// Returns the size of a bank, which is the offset of the second bank. Each bank begins with "COP" and a marker.
    std::size_t bank_size() {
        const std::array<std::uint8_t, 3> magic{'C', 'O', 'P'};
        const auto& bytes = memory.bytes();
        return static_cast<std::size_t>(std::search(bytes.begin() + 4, bytes.end(), magic.begin(), magic.end()) -
                                        bytes.begin());
    }
    /// Marks the bank of `size` bytes at `at` as committed, writes `number` to offset `offset` in the bank, and makes
    /// its CRC-32 right again.
    void set_header(std::size_t at, std::size_t size, std::size_t offset, std::uint32_t number) {
        memory.bytes()[at + 3] = 'S';
        put(at + offset, number);
        std::uint32_t crc = 0xFFFFFFFF;
        for (std::size_t i = at; i < at + size - 4; ++i) {
            crc ^= memory.bytes()[i];
            for (int bit = 0; bit < 8; ++bit) {
                crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
            }
        }
        put(at + size - 4, ~crc);
    }

  private:
    void put(std::size_t at, std::uint32_t number) {
        for (std::size_t i = 0; i < 4; ++i) {
            memory.bytes()[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
        }
    }
};

}  // namespace canproof::test
