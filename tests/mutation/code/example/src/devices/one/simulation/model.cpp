// SPDX-License-Identifier: Apache-2.0
// Simulation code, of which schemata.py writes no mutant.
namespace canproof {

bool of_a_simulation(const unsigned a, const unsigned b) noexcept {
    return a < b;
}

}  // namespace canproof
