// The public headers behind Windows' own, whose macros are all over the place.
#include <windows.h>

#include <seaglass/foam.h>
#include <seaglass/water.h>
#include <seaglass/water_type.h>

int main() {
    const seaglass::BodyDesc desc;
    return desc.waves ? 1 : 0;
}
