// A slave that has every service of CiA 301, described as any device is: what the conformance suite talks to. Node-ID
// 5; the objects stand here so that a reader of an exchange finds them on one page.
#pragma once

#include <stdexcept>

#include "host/register/load.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"
#include "tests/support/slave_communication.hpp"
#include "tests/support/slave_values.hpp"

namespace canproof::test {

inline host::SpecFiles slave_files() {
    host::SpecFiles files;
    files["spec/manuals/s.toml"] = R"toml(key = "S1"
title = "Conformance slave"
publisher = "canproof"
revision = "1"
date = "2026-11-21"
[[section]]
ref = "1"
title = "Everything"
disposition = "normative"
)toml";
    files["spec/devices/slave/device.toml"] = R"toml(name = "slave"
title = "Conformance slave"
vendor = "canproof"
prefix = "AO4"
manual = "S1"
part_numbers = ["none"]
node_id = 5
bit_rate = 125000
bit_rates = [10000, 20000, 50000, 125000, 250000, 500000, 800000, 1000000]
source = ["S1:1"]
[services]
lss = true
block_sdo = true
limit_abort = "high_low"
error_list = "history"
)toml";
    files["spec/devices/slave/communication.toml"] = slave_communication;
    files["spec/devices/slave/values.toml"] = slave_values;
    return files;
}

/// The slave's part of that register; read once.
inline const host::Part& slave_part() {
    static const host::LoadResult loaded = host::load_register(slave_files());
    if (!loaded.faults.empty()) {
        throw std::logic_error{loaded.faults.front().text()};
    }
    return *loaded.content.part("slave");
}

}  // namespace canproof::test
