// The values of the conformance slave, as a register describes them: what can be read, written and mapped.
#pragma once

namespace canproof::test {

inline const char* const slave_values = R"toml(
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

}  // namespace canproof::test
