// SPDX-License-Identifier: Apache-2.0
// A bad and a good data sheet for each rule of `canproof eds check` about entries and their values.
#include "tests/host/datasheet/check/examples.hpp"

namespace canproof::host::test {

std::vector<RuleExample> entry_examples() {
    return {
        {"data-type-missing", "[2000] -DataType", "[2002] -DataType"},
        {"data-type-unknown", "[2000] DataType=0x0099", "[2000] DataType=0x0010"},
        {"data-type-record", "[2000] DataType=0x0021", "[1600] DataType=0x0021"},
        {"access-missing", "[2000] -AccessType", "[2002] -AccessType"},
        {"access-unknown", "[2000] AccessType=wr", "[2000] AccessType=wo"},
        {"access-case", "[2000] AccessType=RW", "[2000] AccessType=ro"},
        {"const-default", "[1008] -DefaultValue", "[2001] -DefaultValue"},
        {"domain-type", "[2002] DataType=0x0007", "[2002] -DataType"},
        {"domain-object", "[2001] DataType=0x000F", "[2002] DataType=15"},
        {"domain-default", "[2002] DefaultValue=0", "[2002] DefaultValue="},
        {"mapping-flag", "[2000] PDOMapping=yes", "[2000] PDOMapping=0x0"},
        {"mapping-type", "[2002] PDOMapping=1", "[2004] PDOMapping=1"},
        {"mapping-text", "[2001] PDOMapping=1", "[2000] PDOMapping=1"},
        {"mapping-const", "[2000] AccessType=const | [2000] PDOMapping=1", "[2000] AccessType=const"},
        {"mapping-no-direction", "[2000] PDOMapping=1 | @[2000] AccessType",
         "[2000] PDOMapping=1 | [2000] AccessType=rwr"},
        {"mapping-direction-unused", "[2004] AccessType=rwr", "[2004] AccessType=rwr | [2004] PDOMapping=1"},
        {"mapping-parameter", "[1A00sub1] PDOMapping=1", "[1001] PDOMapping=1"},

        {"default-no-number", "[2000] DefaultValue=five", "[2000] DefaultValue=0x5"},
        {"default-outside-type", "[2000] DefaultValue=0x10000", "[2000] DefaultValue=0xFFFF"},
        {"default-boolean", "[2004] DefaultValue=2", "[2004] DefaultValue=0x1"},
        {"default-real", "[2003] DefaultValue=1,5", "[2003] DefaultValue=0x3FC00000"},
        {"default-octets", "[2005] DefaultValue=01 A", "[2005] DefaultValue=01A0"},
        {"default-quotes", "[2001] DefaultValue=\"hello\"", "[2001] DefaultValue=a \"b\" c"},
        {"default-node-id-form", "[1014] DefaultValue=$NODEID*2", "[1014] DefaultValue=$NODEID"},
        {"default-node-id-order", "[1014] DefaultValue=0x80+$NODEID", "[1014] DefaultValue=$NODEID + 0x80"},
        {"default-node-id-case", "[1014] DefaultValue=$NodeId+0x80", ""},
        {"default-outside-limits", "[2000] DefaultValue=101", "[2000] DefaultValue=0xFF9C"},  // -100, the low limit
        {"number-octal", "[2000] DefaultValue=010", "[2000] DefaultValue=0"},
        {"number-suffix", "[1005] DefaultValue=0x80UL", ""},
        {"limit-no-number", "[2003] HighLimit=high", "[2003] HighLimit=1e3"},
        {"limit-outside-type", "[2000] HighLimit=32768", "[2000] HighLimit=32767"},
        {"limit-order", "[2000] LowLimit=101", "[2000] LowLimit=-100"},
        {"limit-type", "[2001] LowLimit=0", "[2001] LowLimit="},
    };
}

}  // namespace canproof::host::test
