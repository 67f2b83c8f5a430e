// Each marked line must be flagged.
namespace {  // flagged
inline constexpr int step{1};
}
