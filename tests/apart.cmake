# SPDX-License-Identifier: Apache-2.0
# Each of these tests names something as another test of its folder does: canproof_join() compiles it by itself.
set(tests_apart can_transmitter can_receiver parameter_journal ax060805/dictionary undefined_angles math_block broken_register ax060805/filters run_cases request_guard arbitrated_load blocks/ramp
          host/register/fingerprint conform/report panel/panel cbx-ao412/output socketcan_rules candump_forms own_xdd
          ax188001/storage blocks/relay blocks/lookup_table blocks/limit_fault
          blocks/digital_output blocks/linear_scaling object_sheet)
list(JOIN tests_apart "_test|" tests_apart)
string(APPEND tests_apart "_test")
