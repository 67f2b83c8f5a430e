// SPDX-License-Identifier: Apache-2.0
// Firmware of one device, mutated like the shared firmware.
namespace canproof {

bool of_a_device(const unsigned a, const unsigned b) noexcept {
    return a != b;
}

}  // namespace canproof
