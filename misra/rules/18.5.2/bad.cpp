// Each marked line must be flagged.
#include <cstdlib>
void stop() {
    std::abort();  // flagged
}
