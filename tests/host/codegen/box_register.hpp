// SPDX-License-Identifier: Apache-2.0
// The device `box` as described in a register: objects, behaviour and the enumerations of CANopen that it uses.
#pragma once

#include <string>

namespace canproof::host::test {

inline const std::string objects = R"([[object]]
index = 0x1000
name = "Device Type"
type = "UNSIGNED32"
access = "ro"
default = 0x20191
source = ["M1:1"]
[[object]]
index = 0x1001
name = "Error Register"
type = "UNSIGNED8"
access = "ro"
default = 0
service = "emcy"
source = ["M1:1"]
[[object]]
index = 0x1014
name = "COB-ID EMCY"
type = "UNSIGNED32"
access = "rw"
default = "$NODEID+0x80"
range = { min = 1 }
service = "emcy"
source = ["M1:1"]
[[object]]
index = 0x1018
name = "Identity Object"
source = ["M1:1"]
[[object.entry]]
sub = 1
name = "Vendor-ID"
type = "UNSIGNED32"
access = "ro"
default = 0x17
[[object.entry]]
sub = 4
name = "Serial Number"
type = "UNSIGNED32"
access = "ro"
factory = true
default = 1
[[object]]
index = 0x2000
name = "Upper Bound"
type = "INTEGER16"
array = 2
access = "rw"
default = [5, -6]
range = { min = -100, max = { object = "2001", add = -3 } }
mapping = "rpdo"
source = ["M1:2000h"]
[[object]]
index = 0x2001
name = "Limit"
type = "INTEGER16"
array = 2
access = "rw"
default = 100
stored = false
source = ["M1:1"]
[[object]]
index = 0x2100
name = "Label"
type = "VISIBLE_STRING"
length = 4
access = "rw"
default = "ab"
source = ["M1:1"]
[[object]]
index = 0x2200
name = "Mode {n}"
repeat = { first = 1, last = 2, step = 0x10 }
type = "UNSIGNED8"
access = "rw"
default = { 1 = 2, 2 = 8 }
range = { values = [2, 8] }
source = ["M1:1"]
[[object]]
index = 0x2300
name = "Scale"
type = "REAL32"
access = "rw"
default = 1.5
range = { max = 10.0 }
source = ["M1:1"]
[[object]]
index = 0x2400
name = "Choice"
type = "UNSIGNED8"
access = "rw"
default = 1
range = { table = "AO4-T1" }
source = ["M1:1"]
)";

inline const std::string behaviour = R"([[table]]
id = "AO4-T1"
title = "Rate by setting"
source = ["M1:Table 3"]
inputs = [ { name = "setting", min = 0, max = 3 }, "enable", "word" ]
outputs = [ { name = "rate", type = "UNSIGNED32", unit = "bit/s" }, "action", { name = "state", enumeration = "CO-E-STATE" } ]
rows = [
  ["0..1", true, "*", 100000, "run", "stopped"],
  [[2, 3], true, ["a", "b"], 66, "and", "stopped"],
  ["*", false, "*", 0, "shut off", "operational"],
]
[[constant]]
id = "AO4-K-1"
name = "reference_voltage"
value = 4.096
type = "REAL32"
unit = "V"
text = "Reference of the converter."
source = ["M1:1"]
[[constant]]
id = "AO4-K-2"
name = "steps"
value = 4095
type = "UNSIGNED16"
source = ["M1:1"]
[[signal]]
id = "AO4-S-1"
name = "aout{n}"
count = 2
direction = "output"
type = "REAL32"
unit = "V"
min = -10.0
max = 10.0
default = 1.0
text = "Voltage at the output."
source = ["M1:1"]
[[signal]]
id = "AO4-S-2"
name = "switch_high"
direction = "input"
type = "UNSIGNED8"
min = 0
max = 15
default = 3
text = "Coding switch."
source = ["M1:1"]
[[requirement]]
id = "AO4-R-1"
text = "In force."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
[[requirement]]
id = "AO4-R-2"
text = "No longer."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
retired = "merged into AO4-R-1"
)";

inline const std::string shared = R"([[enumeration]]
id = "CO-E-STATE"
name = "NmtState"
values = { initialising = 0, stopped = 4, operational = 5, pre_operational = 127 }
source = ["CiA301:7.3.2"]
[[enumeration]]
id = "CO-E-LEVEL"
name = "Level"
values = { low = -1, default = 0, high = 300 }
source = ["CiA301:7"]
)";

}  // namespace canproof::host::test
