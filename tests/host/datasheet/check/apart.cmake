# SPDX-License-Identifier: Apache-2.0
# This source has no tests. Alone it is an object that tests/seeded/run can link to any one test.
set(apart good_sheet.cpp)
