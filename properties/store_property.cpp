// SPDX-License-Identifier: Apache-2.0
// A power cut at any byte of a save leaves the old set of stored values or the new one, never a mixture (CiA 301,
// 7.5.2.13).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

std::string heartbeat_and_output(CbxBench& bench) {
    return bench.send("603#4017100000000000").at(0) + bench.send("603#4011640100000000").at(0);
}

}  // namespace

RC_GTEST_PROP(StoreLaw, PowerCutDuringASaveLeavesTheOldOrTheNewParameterSet, ()) {
    verifies<req::CO_STORE_004>("property");
    CbxBench bench;
    bench.power_on();
    // Old set: 1017h (producer heartbeat time) = 0, 6411h:1 (output value) = 1111h. New set: 1017h = 2710h (10 s),
    // 6411h:1 = 2222h.
    bench.send("603#2B11640111110000");
    bench.send("603#2310100173617665");
    const std::string old_set = heartbeat_and_output(bench);
    bench.send("603#2B17100010270000");
    bench.send("603#2B11640122220000");
    const std::string new_set = heartbeat_and_output(bench);
    bench.memory.cut_power_after(*rc::gen::inRange<std::size_t>(0, 400));
    bench.send("603#2310100173617665");
    bench.memory.restore_power();
    bench.power_on();
    const std::string found = heartbeat_and_output(bench);
    RC_ASSERT(found == old_set || found == new_set);
}

}  // namespace canproof::test
