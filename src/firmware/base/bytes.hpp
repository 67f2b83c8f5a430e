// SPDX-License-Identifier: Apache-2.0
// Views of bytes that cannot overrun, and little-endian access (CiA 301 sends the least significant byte first).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace canproof {

// Numbers in memory have the byte order of the bus, so that one access reads or writes them.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "a processor that puts the least significant byte first");

/// Reads the N (1…8) bytes at `bytes` as a number, least significant byte first; store_le() writes them. The caller
/// ensures that N bytes exist there.
template <std::size_t N>
inline std::uint64_t load_le(const std::uint8_t* const bytes) noexcept {
    std::conditional_t<(N == sizeof(std::uint32_t)), std::uint32_t, std::uint64_t> value{0U};
    static_cast<void>(std::memcpy(&value, bytes, N));
    return value;
}
template <std::size_t N>
inline void store_le(std::uint8_t* const bytes, const std::uint64_t value) noexcept {
    static_cast<void>(std::memcpy(bytes, &value, N));
}

/// Reads N (1…8) bytes of an array from position `at` on as a number, least significant byte first; set_field_le()
/// writes them. The compiler checks that the N bytes lie within the array.
template <std::size_t at, std::size_t N, std::size_t size>
inline std::uint64_t field_le(const std::array<std::uint8_t, size>& bytes) noexcept {
    static_assert((at + N) <= size, "the field ends behind the array");
    return load_le<N>(&std::get<at>(bytes));
}
template <std::size_t at, std::size_t N, std::size_t size>
inline void set_field_le(std::array<std::uint8_t, size>& bytes, const std::uint64_t value) noexcept {
    static_assert((at + N) <= size, "the field ends behind the array");
    store_le<N>(&std::get<at>(bytes), value);
}

/// Read-only view of bytes. Reading past its end by the index operator gives zero, never memory beside it. The
/// alignment lets a 32-bit processor pass a view in a pair of registers instead of on the stack; MutableBytes has the
/// same alignment.
class alignas(std::uint64_t) ByteView {
  public:
    constexpr ByteView() noexcept = default;
    constexpr ByteView(const std::uint8_t* const data, const std::size_t size) noexcept : data_{data}, size_{size} {}
    template <std::size_t N>
    constexpr explicit ByteView(const std::array<std::uint8_t, N>& bytes) noexcept : data_{bytes.data()}, size_{N} {}

    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0U; }
    constexpr const std::uint8_t* data() const noexcept { return data_; }
    constexpr std::uint8_t operator[](const std::size_t at) const noexcept {
        return (at < size_) ? data_[at] : std::uint8_t{0U};
    }
    /// Returns at most `count` bytes from `from` on; fewer when the view ends earlier.
    constexpr ByteView part(const std::size_t from, const std::size_t count) const noexcept {
        const std::size_t start = (from < size_) ? from : size_;
        const std::size_t rest = size_ - start;
        return ByteView{data_ + start, (count < rest) ? count : rest};
    }

  private:
    const std::uint8_t* data_{nullptr};
    std::size_t size_{0U};
};

/// Writable view of bytes. Writing past its end does nothing.
class alignas(std::uint64_t) MutableBytes {
  public:
    constexpr MutableBytes() noexcept = default;
    constexpr MutableBytes(std::uint8_t* const data, const std::size_t size) noexcept : data_{data}, size_{size} {}
    template <std::size_t N>
    constexpr explicit MutableBytes(std::array<std::uint8_t, N>& bytes) noexcept : data_{bytes.data()}, size_{N} {}

    constexpr std::size_t size() const noexcept { return size_; }
    constexpr ByteView view() const noexcept { return ByteView{data_, size_}; }
    constexpr std::uint8_t operator[](const std::size_t at) const noexcept {
        return (at < size_) ? data_[at] : std::uint8_t{0U};
    }
    constexpr void set(const std::size_t at, const std::uint8_t value) noexcept {
        if (at < size_) {
            data_[at] = value;
        }
    }
    /// Copies `source` to `at`; bytes that would not fit are dropped.
    void copy(const std::size_t at, const ByteView source) noexcept {
        const std::size_t room = (at < size_) ? (size_ - at) : std::size_t{0U};
        const std::size_t count = (source.size() < room) ? source.size() : room;
        if (count != 0U) {
            static_cast<void>(std::copy_n(source.data(), count, data_ + at));
        }
    }
    /// Writes the low N (1…8) bytes of `value` at `at`, least significant byte first; bytes that do not fit are
    /// dropped.
    template <std::size_t N>
    void put_le(const std::size_t at, const std::uint64_t value) noexcept {
        if ((at <= size_) && (N <= (size_ - at))) {
            store_le<N>(data_ + at, value);
        } else {
            put_each(at, N, value);
        }
    }
    /// Writes the low `count` (0…8) bytes of `value` at `at`, as put_le() does.
    void set_le(const std::size_t at, const std::size_t count, const std::uint64_t value) noexcept {
        const bool fits = (at <= size_) && (count <= (size_ - at));
        switch (fits ? count : 0U) {
            case 1U:
                store_le<1U>(data_ + at, value);
                break;
            case 2U:
                store_le<2U>(data_ + at, value);
                break;
            case 4U:
                store_le<4U>(data_ + at, value);
                break;
            default:
                put_each(at, count, value);
                break;
        }
    }
    /// Writes `value` to the `count` (0…8) bytes at `at`, as put_le() does, if they contain another number. Returns
    /// whether it wrote them. `value` must be below 2^(8 * count), and all bytes must lie within the view.
    bool exchange_le(const std::size_t at, const std::size_t count, const std::uint64_t value) noexcept {
        const bool fits = (at <= size_) && (count <= (size_ - at));
        switch (fits ? count : 0U) {
            case 1U:
                return exchange<1U>(data_ + at, value);
            case 2U:
                return exchange<2U>(data_ + at, value);
            case 4U:
                return exchange<4U>(data_ + at, value);
            default:
                return exchange_each(at, count, value);
        }
    }
    constexpr MutableBytes part(const std::size_t from, const std::size_t count) const noexcept {
        const std::size_t start = (from < size_) ? from : size_;
        const std::size_t rest = size_ - start;
        return MutableBytes{data_ + start, (count < rest) ? count : rest};
    }

  private:
    template <std::size_t N>
    static bool exchange(std::uint8_t* const bytes, const std::uint64_t value) noexcept {
        const bool differs = load_le<N>(bytes) != value;
        if (differs) {
            store_le<N>(bytes, value);
        }
        return differs;
    }
    // These functions are not inlined, because the inlined functions call them in rare cases only: some of the bytes
    // lie outside the view, or their number is unusual.
    [[gnu::noinline]] void put_each(std::size_t at, std::size_t count, std::uint64_t value) noexcept;
    [[gnu::noinline]] bool exchange_each(std::size_t at, std::size_t count, std::uint64_t value) noexcept;

    std::uint8_t* data_{nullptr};
    std::size_t size_{0U};
};

/// Returns `count` (0…8) bytes from `at` on as a number, least significant byte first; bytes beyond the view read as
/// zero. Works for every `at`, because it reads byte by byte.
[[gnu::noinline]] std::uint64_t join_each(ByteView bytes, std::size_t at, std::size_t count) noexcept;

/// Reads N (1…8) bytes of a view from `at` on as a number. The caller ensures that the view has these bytes.
template <std::size_t N>
inline std::uint64_t load_le(const ByteView bytes, const std::size_t at) noexcept {
    return load_le<N>(bytes.data() + at);
}

/// Returns N (1…8) bytes from `at` on as a number, as join_each() does, but with a single access if all of them lie in
/// the view.
template <std::size_t N>
inline std::uint64_t get_le(const ByteView bytes, const std::size_t at) noexcept {
    const bool whole = (at <= bytes.size()) && (N <= (bytes.size() - at));
    return whole ? load_le<N>(bytes, at) : join_each(bytes, at, N);
}
/// Returns the number that a view of at most eight bytes contains, least significant byte first; zero for an empty
/// view.
inline std::uint64_t number_in(const ByteView bytes) noexcept {
    switch (bytes.size()) {
        case 1U:
            return load_le<1U>(bytes.data());
        case 2U:
            return load_le<2U>(bytes.data());
        case 4U:
            return load_le<4U>(bytes.data());
        default:
            return join_each(bytes, 0U, bytes.size());
    }
}
/// Returns `count` (0…8) bytes from `at` on as a number, as join_each() does.
inline std::uint64_t read_le(const ByteView bytes, const std::size_t at, const std::size_t count) noexcept {
    const bool whole = (at <= bytes.size()) && (count <= (bytes.size() - at));
    return whole ? number_in(ByteView{bytes.data() + at, count}) : join_each(bytes, at, count);
}

inline std::uint16_t read_u16(const ByteView bytes, const std::size_t at) noexcept {
    return static_cast<std::uint16_t>(get_le<2U>(bytes, at));
}
inline std::uint32_t read_u32(const ByteView bytes, const std::size_t at) noexcept {
    return static_cast<std::uint32_t>(get_le<4U>(bytes, at));
}

/// Writes the low `count` (0…8) bytes of `value` at `at`, least significant byte first; bytes that do not fit are
/// dropped.
inline void write_le(MutableBytes bytes, const std::size_t at, const std::size_t count,
                     const std::uint64_t value) noexcept {
    bytes.set_le(at, count, value);
}

/// Returns the value of type To with the same bit pattern (C++20 calls this std::bit_cast).
template <typename To, typename From>
To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From), "a bit pattern keeps its size");
    To to{};
    static_cast<void>(std::memcpy(&to, &from, sizeof(To)));
    return to;
}

}  // namespace canproof
