// The AX130751 does what a naive model of it does, which is written from the manual's sentences: outputs, process
// values, TPDOs, emergency messages, 1001h and 1003h, after every step.
#include <gtest/gtest.h>
// rapidcheck's GoogleTest support needs gtest first
#include <rapidcheck/gtest.h>

#include "generated/ax130751/requirements.hpp"
#include "properties/devices/ax130751/model_steps.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

RC_GTEST_PROP(Ax130751Model, TheDeviceDoesWhatTheNaiveOneDoes, ()) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_007>("property");
    ModelPair pair;
    set_up_network(pair);
    wire(pair);
    const int changes = draw(rc::gen::inRange(0, 8));
    for (int i = 0; i < changes; ++i) {
        write_some(pair);
    }
    if (draw(rc::gen::arbitrary<bool>())) {
        pair.store();
    }
    pair.command(1);
    const int steps = draw(rc::gen::inRange(5, 60));
    for (int step = 0; step < steps && !pair.differs(); ++step) {
        do_something(pair);
        switch (draw(rc::gen::inRange(0, 60))) {
            case 0:
                pair.command(one_of({128, 129}));
                break;
            case 1:
                pair.store();
                break;
            default:
                break;
        }
        if (pair.model().state != naive_ax130751::Nmt::operational) {
            pair.pass(one_of({0, 1, 5}));
            pair.command(1);
        }
        pair.pass(one_of({0, 1, 1, 1, 2, 3, 4, 5, 6, 9, 10, 11, 20, 25}));
    }
    if (pair.differs()) {
        RC_FAIL(pair.report());
    }
}

}  // namespace canproof::test
