# SPDX-License-Identifier: Apache-2.0
# Each of these sources uses a name that another source of the folder uses for something else. canproof_join(), which
# compiles several sources as one, compiles each of these by itself.
set(apart dictionary_test.cpp filters_test.cpp object_sheet_test.cpp undefined_angles_test.cpp)
