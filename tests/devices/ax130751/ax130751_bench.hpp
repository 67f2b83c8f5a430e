// SPDX-License-Identifier: Apache-2.0
// Test fixture of an AX130751: node 127 with default parameters, 24 V, frames as in a candump log.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "devices/ax130751/firmware/ax130751.hpp"
#include "tests/support/frame_bench.hpp"

namespace canproof::test {

class Ax130751Bench : public UnitBench<ax130751::Device, ax130751::Inputs, ax130751::FactoryData> {
  public:
    Ax130751Bench() : UnitBench{8192} {}

    /// Returns a COB-ID as text, for example "67F" for function code 600h and node 127.
    std::string id(unsigned function) const { return fmt::format("{:03X}", function + node); }
    /// Returns the answer of the node to an SDO request; other frames are skipped.
    std::string sdo(const std::string& data) {
        for (const auto& frame : send(id(0x600) + "#" + data)) {
            if (frame.substr(0, 4) == id(0x580) + "#") {
                return frame.substr(4);
            }
        }
        return "";
    }
    /// Writes `bytes` bytes by SDO. Returns "" when the write is accepted, else the abort code as text, for example
    /// "06090031".
    std::string write(std::uint16_t index, int sub, std::int64_t value, int bytes) {
        const std::vector<std::string> specifier{"", "2F", "2B", "27", "23"};
        const std::string text = little_endian(static_cast<std::uint64_t>(value), bytes);
        const std::string answer = sdo(specifier.at(static_cast<std::size_t>(bytes)) + address(index, sub) + text +
                                       std::string(8 - text.size(), '0'));
        if (answer.substr(0, 8) == "60" + address(index, sub)) {
            return "";
        }
        return answer.size() == 16 && answer.substr(0, 2) == "80" ? reversed(answer.substr(8)) : "no answer";
    }
    /// Reads an entry by SDO. Returns its value, or a number with all 64 bits set when the read is refused.
    std::uint64_t read(std::uint16_t index, int sub) {
        const std::string answer = sdo("40" + address(index, sub) + "00000000");
        const std::vector<std::pair<std::string, std::size_t>> lengths{{"4F", 1}, {"4B", 2}, {"47", 3}, {"43", 4}};
        for (const auto& [specifier, bytes] : lengths) {
            if (answer.substr(0, 2) == specifier) {
                return std::stoull(reversed(answer.substr(8, 2 * bytes)), nullptr, 16);
            }
        }
        return ~std::uint64_t{0};
    }
    /// Reads an entry by SDO. Returns the abort code, or "" when the read is accepted.
    std::string refusal(std::uint16_t index, int sub) {
        const std::string answer = sdo("40" + address(index, sub) + "00000000");
        return answer.substr(0, 2) == "80" ? reversed(answer.substr(8)) : "";
    }
    Frames start() { return send(fmt::format("000#01{:02X}", node)); }
    Frames store(int group = 1) { return send(id(0x600) + "#2310100" + std::to_string(group) + "73617665"); }
    Frames restore(int group = 1) { return send(id(0x600) + "#2311100" + std::to_string(group) + "6C6F6164"); }

    static std::string little_endian(std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) {
            text += fmt::format("{:02X}", (value >> (8 * i)) & 0xFFU);
        }
        return text;
    }
    static std::string address(std::uint16_t index, int sub) {
        return little_endian(index, 2) + little_endian(static_cast<std::uint64_t>(sub), 1);
    }
    /// Returns the bytes of a text of hexadecimal digits in reverse order.
    static std::string reversed(const std::string& bytes) {
        std::string text;
        for (std::size_t i = bytes.size(); i >= 2; i -= 2) {
            text += bytes.substr(i - 2, 2);
        }
        return text;
    }

    unsigned node{127};  ///< the node-ID to which the client sends
};

/// A test fixture whose device has booted.
class Ax130751Test : public testing::Test, public Ax130751Bench {
  protected:
    void SetUp() override { power_on(); }
};

}  // namespace canproof::test
