// SPDX-License-Identifier: Apache-2.0
// Sends requests of an image in QEMU to the host.
#pragma once

namespace canproof::target {

/// Sends a request to the debugger by Arm semihosting 2.0 in Thumb state. r0 has the operation, and r1 the address of
/// its arguments. The instruction is BKPT ABh on a microcontroller (M profile) and SVC ABh on other cores.
inline int semihost(const int operation, const void* const block) {
    register int r0 asm("r0") = operation;
    register const void* r1 asm("r1") = block;
#if defined(__ARM_ARCH_PROFILE) && (__ARM_ARCH_PROFILE == 'M')
    asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
#else
    asm volatile("svc 0xAB" : "+r"(r0) : "r"(r1) : "memory", "lr");
#endif
    return r0;
}

}  // namespace canproof::target
