// Nothing here may be flagged.
namespace own {
inline constexpr int step{1};
}
