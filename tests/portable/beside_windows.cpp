// The public headers behind Windows' own, whose macros are all over the place.
#include <windows.h>

// As Microsoft's debug heap has them (crtdbg.h, _CRTDBG_MAP_ALLOC).
#undef malloc
#undef free
#define malloc(size) _malloc_dbg(size, 1, __FILE__, __LINE__)
#define free(block) _free_dbg(block, 1)

#include <seaglass/water.h>
#include <seaglass/water_type.h>

int main() {
    const seaglass::BodyDesc desc;
    const seaglass::DeviceDesc device;
    const seaglass::MemoryPiece piece;
    if (device.memory.release) device.memory.release(device.memory.user, &piece);
    return desc.waves ? 1 : 0;
}
