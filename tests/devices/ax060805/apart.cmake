# SPDX-License-Identifier: Apache-2.0
# Each of these sources names something as another one of its folder does: canproof_join() compiles it by itself.
set(apart dictionary_test.cpp filters_test.cpp object_sheet_test.cpp undefined_angles_test.cpp)
