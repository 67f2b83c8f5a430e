// SPDX-License-Identifier: Apache-2.0
#include "target/faults/record.hpp"

extern "C" {
extern std::uint8_t vectors_begin[];
extern std::uint8_t vectors_end[];
extern std::uint8_t image_begin[];
extern std::uint8_t image_end[];
}

namespace canproof::faults {

namespace {

constexpr std::size_t most_vectors = 1024;
constexpr std::size_t most_image = 114688;

[[gnu::section(".bss.harness_record")]] std::uint8_t kept_vectors[most_vectors];
[[gnu::section(".bss.harness_record")]] std::uint8_t kept_image[most_image];

/// Copies only words that differ, because a store makes the emulator translate the code again.
void copy_changed(std::uint8_t* to, const std::uint8_t* from, std::size_t count) {
    auto* const target = reinterpret_cast<volatile std::uint32_t*>(to);
    const auto* const source = reinterpret_cast<const volatile std::uint32_t*>(from);
    for (std::size_t i = 0; i < (count + 3U) / 4U; ++i) {
        if (target[i] != source[i]) {
            target[i] = source[i];
        }
    }
}

}  // namespace

std::uint32_t flash_bytes() {
    return static_cast<std::uint32_t>((vectors_end - vectors_begin) + (image_end - image_begin));
}

std::uint8_t& flash_byte(std::uint32_t at) {
    const auto vectors = static_cast<std::uint32_t>(vectors_end - vectors_begin);
    return at < vectors ? vectors_begin[at] : image_begin[at - vectors];
}

void keep_flash() {
    copy_changed(kept_vectors, vectors_begin, static_cast<std::size_t>(vectors_end - vectors_begin));
    copy_changed(kept_image, image_begin, static_cast<std::size_t>(image_end - image_begin));
}

void restore_flash() {
    copy_changed(vectors_begin, kept_vectors, static_cast<std::size_t>(vectors_end - vectors_begin));
    copy_changed(image_begin, kept_image, static_cast<std::size_t>(image_end - image_begin));
    asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace canproof::faults
