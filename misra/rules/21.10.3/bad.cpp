// Each marked line must be flagged.
#include <csignal>  // flagged
int shout() {
    return std::raise(SIGINT);  // flagged
}
