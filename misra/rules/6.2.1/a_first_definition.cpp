// The first definition stands here; the other file defines the same otherwise.
namespace odr {
struct Point {  // the one kept
    int across;
};
}  // namespace odr
int odr_marker();
