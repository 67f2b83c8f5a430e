// SPDX-License-Identifier: Apache-2.0
// Checks that the AX130751 uses no outdated result of an earlier calculation. The property changes one parameter and
// changes it back, then changes one input. The device must agree with the naive model, which keeps no results.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax130751/requirements.hpp"
#include "properties/devices/ax130751/model_steps.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Sets pairs of extra received values (2500h) to a high value, to 0 and to a third value, so that a wrong effect of
/// the earlier parameter change would show.
void move_inputs(ModelPair& pair) {
    for (const int value : {300, 0, one_of({50, 100, 300})}) {
        const int first = draw(rc::gen::inRange(1, 7));
        pair.write(0x2500, first, value);
        pair.pass(1);
        pair.write(0x2500, first % 6 + 1, value);
        pair.pass(one_of({1, 2, 6}));
    }
}

/// Returns a random value for the entry that differs from `present`. After eight attempts without success, returns
/// `present`.
int another_value(int index, int sub, int present) {
    int value = present;
    for (int attempt = 0; attempt < 8 && value == present; ++attempt) {
        value = some_value(index, sub);
    }
    return value;
}

void change_one_key(ModelPair& pair, const Focus& focus) {
    const auto [index, sub] = some_address(pair, focus);
    const int before = *pair.model().entries().at({index, sub}).value;
    pair.write(index, sub, another_value(index, sub, before));
    pair.pass(1);
    move_inputs(pair);
    pair.write(index, sub, before);
    pair.pass(1);
}

void change_one_input(ModelPair& pair) {
    naive_ax130751::Inputs inputs = pair.model().inputs;
    switch (draw(rc::gen::inRange(0, 4))) {
        case 0:
            inputs.supply = draw(rc::gen::element(24.0F, 24.1F, 12.0F, 35.1F));
            break;
        case 1:
            inputs.temperature = draw(rc::gen::element(35.0F, 35.1F, 60.0F, 85.1F));
            break;
        case 2:
            inputs.load[0] = draw(rc::gen::element(250.0F, 1000.0F, 1.0e6F));
            break;
        default:
            inputs.load[1] = draw(rc::gen::element(250.0F, 1000.0F, 1.0e6F));
            break;
    }
    pair.inputs(inputs.supply, inputs.temperature, inputs.load[0], inputs.load[1]);
    pair.pass(2);
}

}  // namespace

RC_GTEST_PROP(Ax130751Cache, DeviceAgreesWithTheNaiveModelAfterAParameterIsChangedAndRestored, ()) {
    verifies<req::AOR_OUT_005, req::AOR_SRC_007, req::AOR_SRC_009, req::AOR_LT_007, req::AOR_LT_008, req::AOR_LT_018,
             req::AOR_MATH_001, req::AOR_MATH_008, req::AOR_MATH_020, req::AOR_MATH_025, req::AOR_LT_038,
             req::AOR_LT_039>("property");
    const Focus focus{Group::output, Group::output, Group::relay, Group::table, Group::table,
                      Group::extra,  Group::math,   Group::math,  Group::logic, Group::diagnostics};
    ModelPair pair;
    wire(pair, focus);
    pair.command(1);
    const int keys = draw(rc::gen::inRange(5, 40));
    for (int key = 0; key < keys && !pair.differs(); ++key) {
        change_one_key(pair, focus);
        change_one_input(pair);
    }
    pair.compare_parameters();
    if (pair.differs()) {
        RC_FAIL(pair.report());
    }
}

}  // namespace canproof::test
