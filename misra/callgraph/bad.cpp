// SPDX-License-Identifier: Apache-2.0
// Faults that the check of the call graph must report: recursion, an unlisted indirect call, a deep stack.
struct Memory {
    virtual int read(int at) = 0;

  protected:
    ~Memory() = default;
};

int ask(Memory& place) {
    return place.read(1);
}

int again(int count);
[[gnu::noinline]] int once(const int count) {
    return (count > 0) ? (again(count - 1) * 3) : 0;
}
[[gnu::noinline]] int again(const int count) {
    return once(count) + 1;
}

int deep(volatile int* const where) {
    volatile int bytes[1000]{};
    bytes[*where] = 1;
    return bytes[*where + 1];
}
