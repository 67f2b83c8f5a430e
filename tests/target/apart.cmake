# SPDX-License-Identifier: Apache-2.0
# Each of these sources defines a name that another source of its folder defines too. So canproof_join() does not join
# it with other sources, but compiles it by itself.
set(apart can_receiver_test.cpp flash_registers_test.cpp parameter_journal_test.cpp)
