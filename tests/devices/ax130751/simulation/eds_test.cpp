// SPDX-License-Identifier: Apache-2.0
// Checks the electronic data sheet of the AX130751: it must have every object and entry of chapter 3 of the manual.
// Some of its lines are compared with lines written by hand from the pages of the objects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "generated/ax130751/requirements.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using testing::HasSubstr;

class Ax130751Eds : public testing::Test {
  protected:
    Ax130751Eds() : loaded_{host::load_register(host::embedded_spec())} {
        text_ = host::write_eds(loaded_.content, *loaded_.content.part("ax130751"));
        std::istringstream lines{text_};
        for (std::string line; std::getline(lines, line);) {
            if (line.front() == '[') {
                EXPECT_TRUE(sections_.insert(line.substr(1, line.find(']') - 1)).second) << line << " stands twice";
            }
        }
    }

    host::LoadResult loaded_;
    std::string text_;
    std::set<std::string> sections_;
};

}  // namespace

TEST_F(Ax130751Eds, EdsHasASectionForEachObjectAndEntry) {
    verifies<req::AOR_OD_1000>();
    std::size_t objects = 0;
    std::size_t entries = 0;
    for (const auto& section : sections_) {
        objects += section.size() == 4 ? 1 : 0;
        entries += section.size() > 4 && section.substr(4, 3) == "sub" ? 1 : 0;
    }
    // Numbers of objects: 13 in sections 3.2.1 to 3.2.13, 16 of PDOs, 14 in section 3.3. Section 3.4 has 4 of
    // digital outputs, 16 of the relay, 14 of analogue outputs, 4 of extra values, 90 of lookup tables, 36 of logic, 37
    // of math, 15 of diagnostics and system.
    EXPECT_EQ(objects, 13U + 16U + 14U + 4U + 16U + 14U + 4U + 90U + 36U + 37U + 15U);
    // the sections with a sub-index: all 1099 entries except the 6 + 60 + 15 variables, which have no such section
    EXPECT_EQ(entries, 1099U - (6U + 60U + 15U));
    for (const char* section : {"3105subB", "3106sub1", "3433sub5", "4450sub3", "2500sub6", "1A03sub4", "5B51"}) {
        EXPECT_EQ(sections_.count(section), 1U) << section;
    }
}

TEST_F(Ax130751Eds, EdsEntriesMatchTheObjectPagesOfTheManual) {
    verifies<req::AOR_OD_1000, req::AOR_OD_2342, req::AOR_OD_7330, req::AOR_OD_5020, req::AOR_OD_1400>();
    const auto lines = [](const std::string& text) {
        std::string all;
        for (const char c : text) {
            all += c == '\n' ? "\r\n" : std::string(1, c);
        }
        return all;
    };
    // Section 3.4.25: 2342h (AO Control Response) is UNSIGNED8, rw, 0 to 2, with the default 1.
    EXPECT_THAT(text_, HasSubstr(lines("[2342sub1]\nParameterName=AO1 Control Response\nObjectType=0x7\n"
                                       "DataType=0x0005\nAccessType=rw\nDefaultValue=1\nLowLimit=0\nHighLimit=2\n"
                                       "PDOMapping=0\n")));
    // Section 3.3.13: 7330h (AO Output Field Value) is INTEGER16, ro, and can be mapped.
    EXPECT_THAT(text_, HasSubstr(lines("[7330sub2]\nParameterName=AO2 Field Value\nObjectType=0x7\nDataType=0x0003\n"
                                       "AccessType=ro\nDefaultValue=0\nPDOMapping=1\n")));
    // Section 3.2.14: 1403h:1 is the COB-ID of RPDO4.
    EXPECT_THAT(text_, HasSubstr(lines("[1403sub1]\nParameterName=COB-ID used by RPDO\nObjectType=0x7\n"
                                       "DataType=0x0007\nAccessType=rw\nDefaultValue=$NODEID+0x40000500\n")));
    // AX130751, 3.1, 3.2.11
    EXPECT_THAT(text_, HasSubstr(lines("VendorNumber=0x55\n")));
    EXPECT_THAT(text_, HasSubstr(lines("ProductNumber=0xAA130751\n")));
    EXPECT_THAT(text_, HasSubstr(lines("NrOfRXPDO=4\nNrOfTXPDO=4\nLSS_Supported=1\n")));
    EXPECT_THAT(text_, HasSubstr(lines("BaudRate_125=1\nBaudRate_250=1\nBaudRate_500=1\nBaudRate_800=0\n"
                                       "BaudRate_1000=1\n")));
    // Section 3.4.74: 5020h (Power Supply Field Value) is a REAL32.
    EXPECT_THAT(text_, HasSubstr(lines("[5020]\nParameterName=Power Supply Field Value\nObjectType=0x7\n"
                                       "DataType=0x0008\nAccessType=ro\n")));
}

}  // namespace canproof::test
