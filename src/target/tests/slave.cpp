// SPDX-License-Identifier: Apache-2.0
// The conformance slave made from its generated tables: the microcontroller cannot read a requirements register.
#include "tests/support/slave.hpp"

#include "generated/slave/objects.hpp"

namespace canproof::test {

namespace {

host::GenericDescription make_slave() {
    const DictionaryTables& tables = generated::slave::tables;
    host::GenericDescription slave;
    slave.rows.objects.assign(tables.objects.begin(), tables.objects.end());
    slave.rows.entries.assign(tables.entries.begin(), tables.entries.end());
    slave.rows.limits.assign(tables.limits.begin(), tables.limits.end());
    slave.rows.allowed.assign(tables.allowed.begin(), tables.allowed.end());
    slave.rows.layout.constants.assign(tables.constants.begin(), tables.constants.end());
    slave.rows.layout.image.assign(tables.defaults.begin(), tables.defaults.end());
    slave.rows.layout.fingerprint = tables.layout;
    slave.rows.slots.assign(tables.slots.begin(), tables.slots.end());
    slave.rows.slot_factor = tables.slot_factor;
    // The values below are those of [services] in tests/support/slave/spec/devices/slave/device.toml.
    slave.profile.limit_abort = LimitAbort::high_low;
    slave.profile.error_list = ErrorList::history;
    slave.profile.block_sdo = true;
    slave.profile.lss = host::standard_lss();
    return slave;
}

}  // namespace

const host::GenericDescription& slave() {
    static const host::GenericDescription description = make_slave();
    return description;
}

}  // namespace canproof::test
