// Firmware of a device: mutated as the shared firmware is.
namespace canproof {

bool of_a_device(const unsigned a, const unsigned b) noexcept {
    return a != b;
}

}  // namespace canproof
