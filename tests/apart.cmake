# SPDX-License-Identifier: Apache-2.0
# Each of these tests defines a name that another test of its folder defines too, so canproof_join() compiles it separately. A name in a
# test body is not changed for that, because reports/kills.csv knows the body.
set(tests_apart can_transmitter can_receiver parameter_journal ax060805/dictionary blocks/analogue_output cbx-ao412/output
                ax188001/simulation/replay host/register/broken_register)
list(JOIN tests_apart "_test|" tests_apart)
string(APPEND tests_apart "_test")
# The same for the images of the target, whose smaller groups put other tests together.
set(target_apart can_transmitter undefined_angles math_block broken_register ax060805/filters run_cases request_guard
                 arbitrated_load blocks/ramp host/register/fingerprint conform/report panel/panel cbx-ao412/output
                 socketcan_rules candump_forms own_xdd ax188001/storage blocks/relay blocks/lookup_table
                 blocks/limit_fault blocks/digital_output blocks/linear_scaling object_sheet)
list(JOIN target_apart "_test|" target_apart)
string(APPEND target_apart "_test")
