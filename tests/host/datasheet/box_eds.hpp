// SPDX-License-Identifier: Apache-2.0
// A hand-written data sheet of a small device, and helpers for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/register/register.hpp"
#include "tests/support/replaced.hpp"

namespace canproof::host::test {

inline const std::string box = R"([FileInfo]
FileName=box.eds
; a comment
[DeviceInfo]
VendorName=Nobody
ProductName=Box
OrderCode=B.1
BaudRate_125=1
BaudRate_250=1
LSS_Supported=1
[DummyUsage]
Dummy0005=1
[MandatoryObjects]
SupportedObjects=3
1=0x1000
2=0x1001
3=0x1018
[1000]
ParameterName=Device Type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x191
PDOMapping=0
[1001]
ParameterName=Error Register
DataType=0x0005
AccessType=ro
DefaultValue=0
PDOMapping=1
[1018]
ParameterName=Identity
ObjectType=0x9
SubNumber=2
[1018sub0]
ParameterName=Highest sub-index
DataType=0x0005
AccessType=ro
DefaultValue=1
[1018sub1]
ParameterName=Vendor-ID
DataType=0x0007
AccessType=ro
DefaultValue=0x17
[OptionalObjects]
SupportedObjects=4
1=0x1017
2=0x1400
3=0x1600
4=0x6200
[1017]
ParameterName=Producer heartbeat time
DataType=0x0006
AccessType=rw
DefaultValue=1000
[1400]
ParameterName=RPDO 1
ObjectType=0x9
SubNumber=3
[1400sub0]
ParameterName=Highest
DataType=0x0005
AccessType=const
DefaultValue=2
[1400sub1]
ParameterName=COB-ID
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x200
[1400sub2]
ParameterName=Transmission type
DataType=0x0005
AccessType=rw
DefaultValue=255
[1600]
ParameterName=RPDO 1 mapping
ObjectType=0x8
SubNumber=2
[1600sub0]
ParameterName=Number
DataType=0x0005
AccessType=rw
DefaultValue=1
LowLimit=0
HighLimit=1
[1600sub1]
ParameterName=First
DataType=0x0007
AccessType=rw
DefaultValue=0x62000108
[6200]
ParameterName=Write outputs
ObjectType=0x8
CompactSubObj=2
DataType=0x0005
AccessType=rww
DefaultValue=3
LowLimit=1
HighLimit=0x40
PDOMapping=1
[6200Name]
NrOfEntries=1
2=Second
[6200Value]
NrOfEntries=1
2=0x20
[ManufacturerObjects]
SupportedObjects=3
1=0x2000
2=0x2001
3=0x2002
[2000]
ParameterName=Trim
DataType=0x0003
AccessType=rw
DefaultValue=-5
LowLimit=0xFF9C
HighLimit=100
[2001]
ParameterName=Name
DataType=0x0009
AccessType=rw
DefaultValue=hello
[2002]
ParameterName=Program
ObjectType=0x2
DataType=0x000F
AccessType=rw
)";

inline std::string texts(const Faults& faults) {
    std::string all;
    for (const Fault& fault : faults) {
        all += fault.text() + "\n";
    }
    return all;
}

/// Returns the number, from 1, of the first line that contains `text`.
inline std::size_t line_of(const std::string& file, const std::string& text) {
    return static_cast<std::size_t>(
        std::count(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(file.find(text)), '\n') + 1);
}

inline const Entry& entry(const Part& part, unsigned index, unsigned sub) {
    for (const Object& object : part.objects) {
        for (const Entry& one : object.entries) {
            if (object.index == index && one.subindex == sub) {
                return one;
            }
        }
    }
    throw std::out_of_range{"no such entry"};
}

}  // namespace canproof::host::test
