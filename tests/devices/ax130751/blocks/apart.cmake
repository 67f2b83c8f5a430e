# SPDX-License-Identifier: Apache-2.0
# Each of these sources names something as another one of its folder does: canproof_join() compiles it by itself.
set(apart digital_output_test.cpp limit_fault_test.cpp linear_scaling_test.cpp lookup_table_test.cpp math_block_test.cpp ramp_test.cpp relay_test.cpp)
