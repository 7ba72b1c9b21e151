// Within a struct: the specialisation constants that the file CONSTANTS lists, with their usual values. It is a line
// CONSTANT(number, type, name, usual value) for each, number 0 first; shaders read it by shaders/gpu/constant.glsl.
#define CONSTANT(number, type, name, usual) type name = usual;
#include CONSTANTS
#undef CONSTANT

    /// As pipelines take them.
    auto constants() const {
        constexpr uint32_t numbers[] = {
#define CONSTANT(number, type, name, usual) number,
#include CONSTANTS
#undef CONSTANT
        };
        static_assert(seaglass::gpu::areCounted(numbers));
        return std::array{
#define CONSTANT(number, type, name, usual) static_cast<uint32_t>(name),
#include CONSTANTS
#undef CONSTANT
        };
    }
#undef CONSTANTS
