# SPDX-License-Identifier: Apache-2.0
# Each of these sources names something as another one of its folder does: canproof_join() compiles it by itself.
set(apart arbitrated_load_test.cpp candump_forms_test.cpp socketcan_rules_test.cpp)
