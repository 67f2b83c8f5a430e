// SPDX-License-Identifier: Apache-2.0
// Reset node restarts the function blocks, also when one block is the input of another.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805FunctionsAfterReset : public InclinometerTest {};

}  // namespace

TEST_F(Ax060805FunctionsAfterReset, FunctionFedByALaterFunctionHasNoInputInTheFirstPass) {
    verifies<req::INC_BIN_016, req::INC_SIG_002>();
    write_real(0x4070, 0, 5.0F);
    write(0x3020, 1, 24, 1);  // function 2 is 4070h + 0
    write(0x3020, 2, 25, 1);
    write(0x300A, 2, 1, 1);
    write(0x3010, 1, 11, 1);  // function 1 adds 1 to source 11, the result of function 2
    write(0x3010, 2, 26, 1);
    write(0x300A, 1, 1, 1);
    write(0x1010, 1, 0x65766173, 4);
    pass(10);
    EXPECT_EQ(value(0x3000, 1), 6);
    EXPECT_EQ(send("000#8100"), (Frames{"77F#00"}));
    EXPECT_EQ(value(0x3000, 1), 0);
    EXPECT_EQ(value(0x3000, 2), 5);
    pass(5);
    EXPECT_EQ(value(0x3000, 1), 6);
}

}  // namespace canproof::test
