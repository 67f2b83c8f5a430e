// The communication objects of the conformance slave, as a register describes them.
#pragma once

namespace canproof::test {

inline const char* const slave_communication = R"toml(
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
)toml";

}  // namespace canproof::test
