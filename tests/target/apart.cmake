# SPDX-License-Identifier: Apache-2.0
# Each of these sources names something as another one of its folder does: canproof_join() compiles it by itself.
set(apart can_receiver_test.cpp can_transmitter_test.cpp parameter_journal_test.cpp)
