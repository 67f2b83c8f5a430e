// Each marked line must be flagged.
#include <cstdio>  // flagged
int tell() {
    return std::puts("x");  // flagged
}
