# SPDX-License-Identifier: Apache-2.0
# Each of these sources uses a name that another source of the folder uses for something else. canproof_join(), which
# compiles several sources as one, compiles each of these by itself.
set(apart digital_output_test.cpp limit_fault_test.cpp linear_scaling_test.cpp lookup_table_test.cpp math_block_test.cpp ramp_test.cpp relay_test.cpp)
