// SPDX-License-Identifier: Apache-2.0
// Properties of the SDO server, checked on a CAN-CBX-AO412.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

std::string hex(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += fmt::format("{:02X}", (value >> (8 * i)) & 0xFF);
    }
    return text;
}

std::string read_back(CbxBench& bench, const std::string& object) {
    return bench.send("603#40" + object + "00000000").at(0);
}

}  // namespace

// CiA 301, 7.2.4.3
RC_GTEST_PROP(SdoServerLaw, WrittenValueIsReadBack, ()) {
    verifies<req::CO_SDO_016>("property");
    CbxBench bench;
    bench.power_on();
    const auto value = *rc::gen::arbitrary<std::int16_t>();
    const auto output = *rc::gen::inRange(1, 5);
    const std::string object = "1164" + hex(static_cast<std::uint64_t>(output), 1);
    const std::string data = hex(static_cast<std::uint16_t>(value), 2);
    RC_ASSERT(bench.send("603#2B" + object + data + "0000").at(0) == "583#60" + object + "00000000");
    RC_ASSERT(read_back(bench, object) == "583#4B" + object + data + "0000");
}

RC_GTEST_PROP(SdoServerLaw, RefusedWriteChangesNothing, ()) {
    verifies<req::CO_SDO_011>("property");
    CbxBench bench;
    bench.power_on();
    // 6443h:1 (Analogue Output Error Mode) accepts 0, 1 and 2 only (CAN-CBX-AO412, 7.10.3).
    const auto mode = *rc::gen::inRange(3, 256);
    RC_ASSERT(bench.send("603#2F436401" + hex(static_cast<std::uint64_t>(mode), 1) + "000000").at(0) ==
              "583#8043640130000906");
    RC_ASSERT(read_back(bench, "436401") == "583#4F43640101000000");
}

// Any request of eight bytes gets at most one answer: eight bytes on 583h, with a command specifier that a server may
// send.
RC_GTEST_PROP(SdoServerLaw, EveryRequestHasAtMostOneWellFormedAnswer, ()) {
    verifies<req::CO_SDO_015, req::CO_SDO_044>("property");
    CbxBench bench;
    bench.power_on();
    const auto requests =
        *rc::gen::container<std::vector<std::array<std::uint8_t, 8>>>(rc::gen::container<std::array<std::uint8_t, 8>>(
            rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                           rc::gen::element<std::uint8_t>(0x00, 0x01, 0x08, 0x10, 0x20, 0x21, 0x23, 0x2B, 0x2F, 0x40,
                                                          0x60, 0x64, 0x70, 0x80))));
    for (const auto& request : requests) {
        std::string text = "603#";
        for (const auto byte : request) {
            text += fmt::format("{:02X}", byte);
        }
        int answers = 0;
        for (const auto& frame : bench.send(text)) {
            if (frame.rfind("583#", 0) == 0) {
                ++answers;
                RC_ASSERT(frame.size() == std::string{"583#"}.size() + 16);
                const auto specifier = std::stoul(frame.substr(4, 2), nullptr, 16) >> 5U;
                RC_ASSERT(specifier <= 4U);  // 0, 1: segment; 2, 3: initiate; 4: abort
            }
        }
        RC_ASSERT(answers <= 1);
    }
}

}  // namespace canproof::test
