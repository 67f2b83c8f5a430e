// Defines what another file defines, otherwise.
namespace odr {
struct Point {  // flagged
    long across;
};
}  // namespace odr
