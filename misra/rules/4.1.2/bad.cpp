// Each marked line must be flagged.
#include <stdint.h>  // flagged
[[deprecated]] int old_way();
int now() {
    return old_way();  // flagged
}
