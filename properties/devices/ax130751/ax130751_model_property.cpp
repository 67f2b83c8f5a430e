// SPDX-License-Identifier: Apache-2.0
// Compares the AX130751 with a naive model, a simple implementation that is written from the manual: outputs, process
// values, TPDOs, emergency messages, 1001h (error register) and 1003h (error list), after every step.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax130751/requirements.hpp"
#include "properties/devices/ax130751/model_steps.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

void hold(ModelPair& pair, const Focus& focus) {
    live(pair, focus);
    if (pair.differs()) {
        RC_FAIL(pair.report());
    }
}

}  // namespace

RC_GTEST_PROP(Ax130751Model, OutputsAgreeWithTheNaiveModel, ()) {
    verifies<req::AOR_OUT_007, req::AOR_OUT_009, req::AOR_OUT_010, req::AOR_OUT_011, req::AOR_OUT_014, req::AOR_OUT_028,
             req::AOR_OUT_029, req::AOR_OUT_033, req::AOR_DO_003, req::AOR_DO_004, req::AOR_DO_010, req::AOR_DO_005,
             req::AOR_DO_006, req::AOR_DO_011, req::AOR_DO_012, req::AOR_DO_008, req::AOR_DO_013, req::AOR_DO_015,
             req::AOR_DO_016, req::AOR_OUT_042, req::AOR_DO_018, req::AOR_DO_019, req::AOR_DO_020, req::AOR_DO_021>(
        "property");
    ModelPair pair;
    hold(pair, {Group::output, Group::output, Group::extra});
}

RC_GTEST_PROP(Ax130751Model, RelayAgreesWithTheNaiveModel, ()) {
    verifies<req::AOR_RELAY_003, req::AOR_RELAY_004, req::AOR_RELAY_005, req::AOR_RELAY_020, req::AOR_RELAY_006,
             req::AOR_RELAY_021, req::AOR_RELAY_009, req::AOR_RELAY_010, req::AOR_RELAY_012, req::AOR_RELAY_013,
             req::AOR_RELAY_022, req::AOR_RELAY_014, req::AOR_RELAY_023, req::AOR_RELAY_015, req::AOR_RELAY_017,
             req::AOR_RELAY_025, req::AOR_RELAY_027>("property");
    ModelPair pair;
    hold(pair, {Group::relay});
}

RC_GTEST_PROP(Ax130751Model, TablesLogicAndMathAgreeWithTheNaiveModel, ()) {
    verifies<req::AOR_LT_001, req::AOR_LT_010, req::AOR_LT_021, req::AOR_LT_013, req::AOR_LT_016, req::AOR_LT_025,
             req::AOR_LT_026, req::AOR_LT_018, req::AOR_LT_027, req::AOR_LT_028, req::AOR_LOGIC_006, req::AOR_LOGIC_007,
             req::AOR_LOGIC_012, req::AOR_LOGIC_008, req::AOR_LOGIC_013, req::AOR_MATH_001, req::AOR_MATH_008,
             req::AOR_MATH_014, req::AOR_MATH_019, req::AOR_MATH_024, req::AOR_LOGIC_014>("property");
    ModelPair pair;
    hold(pair, {Group::table, Group::table, Group::logic, Group::math, Group::extra});
}

RC_GTEST_PROP(Ax130751Model, DeviceAgreesWithTheNaiveModel, ()) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_030, req::AOR_SRC_004, req::AOR_SRC_005, req::AOR_DIAG_006,
             req::AOR_DIAG_007, req::AOR_DIAG_012, req::AOR_DIAG_013, req::AOR_ERR_003, req::AOR_ERR_013,
             req::AOR_ERR_008, req::AOR_ERR_010, req::AOR_ERR_016, req::AOR_PDO_004, req::AOR_PDO_009, req::AOR_ERR_019,
             req::AOR_DIAG_019, req::AOR_OUT_038>("property");
    ModelPair pair;
    set_up_network(pair);
    hold(pair, {Group::output, Group::output, Group::output, Group::relay, Group::relay, Group::table, Group::logic,
                Group::math, Group::extra, Group::diagnostics});
}

}  // namespace canproof::test
