# SPDX-License-Identifier: Apache-2.0
# This source has no tests. Compiled alone, it is an object file that tests/seeded/run can link to any single test.
set(apart good_sheet.cpp)
