# SPDX-License-Identifier: Apache-2.0
# CMake toolchain: Cortex-A53 of a Zynq UltraScale+ in its 32-bit state (AArch32), which newlib of arm-none-eabi serves.
# The memory management unit is off, so no access may be unaligned.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-a53)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT
    "-mcpu=cortex-a53 -mthumb -mfpu=auto -mfloat-abi=hard -mno-unaligned-access -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_MINSIZEREL_INIT "-Os")
