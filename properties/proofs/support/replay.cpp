// SPDX-License-Identifier: Apache-2.0
// Runs a theorem natively on one counterexample. CANPROOF_COUNTEREXAMPLE names a file. It has one line for each value
// that the harness leaves open, with the bytes of the value as numbers; -1 leaves a byte unchanged. CANPROOF_SEEDS,
// when set, names a folder of corpora. A seed for the fuzz target TARGET is then written to TARGET/CANPROOF_SEED in
// this folder.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "properties/proofs/support/proof.hpp"

namespace {

constexpr int claim_fails = 10;
constexpr int assumption_fails = 11;
constexpr int file_ends = 12;

std::vector<int> next_input() {
    static std::ifstream file{std::getenv("CANPROOF_COUNTEREXAMPLE")};
    std::string line;
    if (!std::getline(file, line)) {
        std::fputs("the counterexample has no more values\n", stderr);
        std::_Exit(file_ends);
    }
    std::istringstream numbers{line};
    std::vector<int> bytes;
    for (int byte = 0; numbers >> byte;) {
        bytes.push_back(byte);
    }
    return bytes;
}

void put(std::uint8_t* const at, const std::size_t size) {
    const std::vector<int> bytes = next_input();
    for (std::size_t i = 0; i < size && i < bytes.size(); ++i) {
        if (bytes[i] >= 0) {
            at[i] = static_cast<std::uint8_t>(bytes[i]);
        }
    }
}

}  // namespace

extern "C" {

void canproof_any(void* at, std::size_t bytes) noexcept {
    put(static_cast<std::uint8_t*>(at), bytes);
}

void canproof_any_state(void* at, std::size_t bytes) noexcept {
    put(static_cast<std::uint8_t*>(at), bytes);
}

std::uint8_t canproof_each(std::size_t /*count*/) noexcept {
    std::uint8_t number{0U};
    put(&number, sizeof(number));
    return number;
}

// The operating system releases the memory at the end of the program, which runs only one theorem.
std::uint8_t* canproof_any_memory(std::size_t bytes) noexcept {
    constexpr std::size_t room = 16;
    auto* const memory = static_cast<std::uint8_t*>(std::calloc(bytes == 0 ? room : bytes, 1));
    if (memory == nullptr) {
        std::fputs("the counterexample needs more memory than there is\n", stderr);
        std::_Exit(file_ends);
    }
    put(memory, bytes);
    return bytes == 0 ? memory + room : memory;  // for no bytes, returns the end of the block, so that the sanitizer
                                                 // reports any read
}

void canproof_assume(bool holds, const char* file, unsigned line) noexcept {
    if (!holds) {
        std::fprintf(stderr, "the assumption in %s:%u excludes the counterexample\n", file, line);
        std::_Exit(assumption_fails);
    }
}

void canproof_claim(bool holds, unsigned line) noexcept {
    if (!holds) {
        std::fprintf(stderr, "the claim in line %u does not hold\n", line);
        std::_Exit(claim_fails);
    }
}

void canproof_seed(const char* target, const std::uint8_t* input, std::size_t bytes) noexcept {
    const char* const corpora = std::getenv("CANPROOF_SEEDS");
    const char* const name = std::getenv("CANPROOF_SEED");
    if (corpora == nullptr || name == nullptr) {
        return;
    }
    const std::filesystem::path corpus = std::filesystem::path{corpora} / target;
    std::filesystem::create_directories(corpus);
    std::ofstream file{corpus / name, std::ios::binary};
    file.write(reinterpret_cast<const char*>(input), static_cast<std::streamsize>(bytes));
    file.close();
    if (!file) {
        std::fputs("the seed cannot be written\n", stderr);
        std::_Exit(file_ends);
    }
}

// A run executes the loop and the function itself.
void canproof_loop(const char* /*function*/, std::size_t /*number*/, const char* /*variables*/, std::size_t /*most*/,
                   void* /*changed*/, std::size_t /*bytes*/,
                   bool (* /*holds*/)(const void*, std::size_t, std::uint64_t, std::uint64_t),
                   const void* /*context*/) noexcept {}
void canproof_contract(const char* /*function*/, const char* /*theorem*/, void (* /*stands_for*/)()) noexcept {}

void canproof_shows(const char* /*statement*/) noexcept {}
void canproof_proves(const char* /*requirement*/) noexcept {}

}  // extern "C"
