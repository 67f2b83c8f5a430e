// Nothing here may be flagged.
namespace own {
inline constexpr int count{0};
}
