// No firmware: schemata.py writes no mutant of it.
namespace canproof {

bool of_a_simulation(const unsigned a, const unsigned b) noexcept {
    return a < b;
}

}  // namespace canproof
