// A slave that has every service of CiA 301, described as any device is: what the conformance suite talks to. Node-ID
// 5; the objects stand here so that a reader of an exchange finds them on one page.
#pragma once

#include <stdexcept>

#include "host/register/load.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::test {

inline const char* const slave_objects = R"toml(
# -- communication ------------------------------------------------------------------------------------------------
[[object]]
index = 0x1000
name = "Device Type"
type = "UNSIGNED32"
access = "ro"
default = 0x12345678
source = ["S1:1"]
[[object]]
index = 0x1001
name = "Error Register"
type = "UNSIGNED8"
access = "ro"
default = 0
service = "emcy"
mapping = "tpdo"
source = ["S1:1"]
[[object]]
index = 0x1003
name = "Pre-Defined Error Field"
type = "UNSIGNED32"
array = 4
access = "ro"
default = 0
service = "emcy"
source = ["S1:1"]
  [[object.entry]]
  sub = 0
  name = "Number of errors"
  type = "UNSIGNED8"
  access = "rw"
  default = 0
  range = { min = 0, max = 0 }
  service = "emcy"
  stored = false
[[object]]
index = 0x1005
name = "COB-ID SYNC"
type = "UNSIGNED32"
access = "rw"
default = 0x80
service = "sync"
source = ["S1:1"]
[[object]]
index = 0x1006
name = "Communication Cycle Period"
type = "UNSIGNED32"
access = "rw"
default = 0
unit = "us"
service = "sync"
source = ["S1:1"]
[[object]]
index = 0x1008
name = "Manufacturer Device Name"
type = "VISIBLE_STRING"
access = "const"
default = "Conformance slave"
source = ["S1:1"]
[[object]]
index = 0x100C
name = "Guard Time"
type = "UNSIGNED16"
access = "rw"
default = 0
service = "guarding"
source = ["S1:1"]
[[object]]
index = 0x100D
name = "Life Time Factor"
type = "UNSIGNED8"
access = "rw"
default = 0
service = "guarding"
source = ["S1:1"]
[[object]]
index = 0x1010
name = "Store Parameters"
type = "UNSIGNED32"
array = 4
access = "rw"
default = 1
stored = false
service = "store"
source = ["S1:1"]
[[object]]
index = 0x1011
name = "Restore Default Parameters"
type = "UNSIGNED32"
array = 4
access = "rw"
default = 1
stored = false
service = "store"
source = ["S1:1"]
[[object]]
index = 0x1014
name = "COB-ID EMCY"
type = "UNSIGNED32"
access = "rw"
default = "$NODEID+0x80"
service = "emcy"
source = ["S1:1"]
[[object]]
index = 0x1015
name = "Inhibit Time EMCY"
type = "UNSIGNED16"
access = "rw"
default = 0
service = "emcy"
source = ["S1:1"]
[[object]]
index = 0x1016
name = "Consumer Heartbeat Time"
type = "UNSIGNED32"
array = 4
access = "rw"
default = 0
service = "heartbeat"
source = ["S1:1"]
[[object]]
index = 0x1017
name = "Producer Heartbeat Time"
type = "UNSIGNED16"
access = "rw"
default = 0
service = "heartbeat"
source = ["S1:1"]
[[object]]
index = 0x1018
name = "Identity Object"
source = ["S1:1"]
  [[object.entry]]
  sub = 1
  name = "Vendor-ID"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x0000005F
  [[object.entry]]
  sub = 2
  name = "Product Code"
  type = "UNSIGNED32"
  access = "ro"
  default = 0xAA020301
  [[object.entry]]
  sub = 3
  name = "Revision Number"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x00010002
  [[object.entry]]
  sub = 4
  name = "Serial Number"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x20261121
[[object]]
index = 0x1019
name = "Synchronous Counter Overflow Value"
type = "UNSIGNED8"
access = "rw"
default = 0
service = "sync"
source = ["S1:1"]
[[object]]
index = 0x1020
name = "Verify Configuration"
type = "UNSIGNED32"
array = 2
access = "rw"
default = 0
source = ["S1:1"]
[[object]]
index = 0x1029
name = "Error Behaviour"
type = "UNSIGNED8"
array = 2
access = "rw"
default = 0
range = { min = 0, max = 2 }
service = "error_behaviour"
source = ["S1:1"]

# -- PDOs ---------------------------------------------------------------------------------------------------------
[[object]]
index = 0x1400
repeat = { first = 1, last = 4, step = 1 }
name = "RPDO{n} Communication Parameter"
source = ["S1:1"]
  [[object.entry]]
  sub = 1
  name = "COB-ID"
  type = "UNSIGNED32"
  access = "rw"
  default = { 1 = "$NODEID+0x200", 2 = "$NODEID+0x300", 3 = "$NODEID+0x80000400", 4 = "$NODEID+0x80000500" }
  service = "pdo"
  [[object.entry]]
  sub = 2
  name = "Transmission Type"
  type = "UNSIGNED8"
  access = "rw"
  default = 255
  service = "pdo"
  [[object.entry]]
  sub = 3
  name = "Inhibit Time"
  type = "UNSIGNED16"
  access = "rw"
  default = 0
  service = "pdo"
  [[object.entry]]
  sub = 5
  name = "Event Timer"
  type = "UNSIGNED16"
  access = "rw"
  default = 0
  service = "pdo"
[[object]]
index = 0x1600
repeat = { first = 1, last = 4, step = 1 }
name = "RPDO{n} Mapping"
type = "UNSIGNED32"
array = 8
kind = "record"
access = "rw"
default = { 1 = [0x20000108, 0x20000208, 0, 0, 0, 0, 0, 0], 2 = [0x21000110, 0x21000210, 0x21000310, 0x21000410, 0, 0, 0, 0], 3 = [0, 0, 0, 0, 0, 0, 0, 0], 4 = [0, 0, 0, 0, 0, 0, 0, 0] }
service = "pdo"
source = ["S1:1"]
  [[object.entry]]
  sub = 0
  name = "Number of mapped objects"
  type = "UNSIGNED8"
  access = "rw"
  default = { 1 = 2, 2 = 4, 3 = 0, 4 = 0 }
  range = { min = 0, max = 8 }
  service = "pdo"
[[object]]
index = 0x1800
repeat = { first = 1, last = 4, step = 1 }
name = "TPDO{n} Communication Parameter"
source = ["S1:1"]
  [[object.entry]]
  sub = 1
  name = "COB-ID"
  type = "UNSIGNED32"
  access = "rw"
  default = { 1 = "$NODEID+0x180", 2 = "$NODEID+0x280", 3 = "$NODEID+0x80000380", 4 = "$NODEID+0x80000480" }
  service = "pdo"
  [[object.entry]]
  sub = 2
  name = "Transmission Type"
  type = "UNSIGNED8"
  access = "rw"
  default = { 1 = 254, 2 = 1, 3 = 254, 4 = 254 }
  service = "pdo"
  [[object.entry]]
  sub = 3
  name = "Inhibit Time"
  type = "UNSIGNED16"
  access = "rw"
  default = 0
  service = "pdo"
  [[object.entry]]
  sub = 5
  name = "Event Timer"
  type = "UNSIGNED16"
  access = "rw"
  default = 0
  service = "pdo"
  [[object.entry]]
  sub = 6
  name = "SYNC Start Value"
  type = "UNSIGNED8"
  access = "rw"
  default = 0
  range = { min = 0, max = 240 }
  service = "pdo"
[[object]]
index = 0x1A00
repeat = { first = 1, last = 4, step = 1 }
name = "TPDO{n} Mapping"
type = "UNSIGNED32"
array = 8
kind = "record"
access = "rw"
default = { 1 = [0x20010108, 0x20010208, 0, 0, 0, 0, 0, 0], 2 = [0x21010110, 0x21010210, 0x21010310, 0x21010410, 0, 0, 0, 0], 3 = [0, 0, 0, 0, 0, 0, 0, 0], 4 = [0, 0, 0, 0, 0, 0, 0, 0] }
service = "pdo"
source = ["S1:1"]
  [[object.entry]]
  sub = 0
  name = "Number of mapped objects"
  type = "UNSIGNED8"
  access = "rw"
  default = { 1 = 2, 2 = 4, 3 = 0, 4 = 0 }
  range = { min = 0, max = 8 }
  service = "pdo"

# -- values to read and write -------------------------------------------------------------------------------------
[[object]]
index = 0x2000
name = "Received Bytes"
type = "UNSIGNED8"
array = 8
access = "rw"
default = 0
mapping = "rpdo"
source = ["S1:1"]
[[object]]
index = 0x2001
name = "Sent Bytes"
type = "UNSIGNED8"
array = 8
access = "rw"
default = 0
mapping = "tpdo"
source = ["S1:1"]
[[object]]
index = 0x2002
name = "Received Bits"
type = "BOOLEAN"
array = 8
access = "rw"
default = false
mapping = "rpdo"
source = ["S1:1"]
[[object]]
index = 0x2003
name = "Sent Bits"
type = "BOOLEAN"
array = 8
access = "rw"
default = false
mapping = "tpdo"
source = ["S1:1"]
[[object]]
index = 0x2100
name = "Received Words"
type = "INTEGER16"
array = 4
access = "rw"
default = 0
mapping = "rpdo"
source = ["S1:1"]
[[object]]
index = 0x2101
name = "Sent Words"
type = "INTEGER16"
array = 4
access = "rw"
default = 0
mapping = "tpdo"
source = ["S1:1"]
[[object]]
index = 0x2200
name = "Limited Word"
text = "Takes -100 … 100 only."
type = "INTEGER16"
access = "rw"
default = 7
range = { min = -100, max = 100 }
mapping = "both"
source = ["S1:1"]
[[object]]
index = 0x2201
name = "Listed Byte"
type = "UNSIGNED8"
access = "rw"
default = 2
range = { values = [2, 8] }
source = ["S1:1"]
[[object]]
index = 0x2202
name = "Real"
type = "REAL32"
access = "rw"
default = 1.5
range = { min = -10.0, max = 10.0 }
mapping = "both"
source = ["S1:1"]
[[object]]
index = 0x2203
name = "Lower Bound"
type = "INTEGER16"
access = "rw"
default = -50
range = { max = "2204" }
source = ["S1:1"]
[[object]]
index = 0x2204
name = "Upper Bound"
type = "INTEGER16"
access = "rw"
default = 50
range = { min = "2203" }
source = ["S1:1"]
[[object]]
index = 0x2205
name = "Write Only"
type = "UNSIGNED32"
access = "wo"
default = 0
source = ["S1:1"]
[[object]]
index = 0x2206
name = "Wide"
type = "UNSIGNED64"
access = "rw"
default = 0
mapping = "both"
source = ["S1:1"]
[[object]]
index = 0x2207
name = "Long Word"
type = "UNSIGNED32"
access = "rw"
default = 0
mapping = "both"
source = ["S1:1"]
[[object]]
index = 0x2300
name = "Label"
type = "VISIBLE_STRING"
access = "rw"
default = "abc"
length = 40
source = ["S1:1"]
[[object]]
index = 0x2301
name = "Long Label"
text = "Longer than the largest value that an SDO client usually sends in segments."
type = "VISIBLE_STRING"
access = "const"
default = "The quick brown fox jumps over the lazy dog 0123456789"
source = ["S1:1"]
[[object]]
index = 0x2302
name = "Story"
text = "Longer than the 64 bytes that the SDO server copies: it is read where it lies and cannot be written."
type = "VISIBLE_STRING"
access = "rw"
default = "A value of seventy-two bytes is longer than what the server itself holds"
stored = false
source = ["S1:1"]
[[object]]
index = 0x2400
name = "Program"
text = "A memory of 64 KiB that the device lends; see SlaveBench."
type = "DOMAIN"
access = "rw"
source = ["S1:1"]
[[object]]
index = 0x2401
name = "Program Without Memory"
text = "A DOMAIN for which the device lends no memory."
type = "DOMAIN"
access = "rw"
source = ["S1:1"]
[[object]]
index = 0x2402
name = "Program To Read"
type = "DOMAIN"
access = "ro"
source = ["S1:1"]
)toml";

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
    files["spec/devices/slave/objects.toml"] = slave_objects;
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
