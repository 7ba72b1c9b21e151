// A program with a floor or a mirror and no water: everything that it calls is there, and refuses what is
// null.
#include <seaglass/reflection.h>

int main() {
    using seaglass::Status;
    const seaglass::Requirements needed = seaglass::requirements();
    seaglass::Context* context = nullptr;
    seaglass::Reflector* reflector = nullptr;
    const seaglass::DeviceDesc device;
    const seaglass::ReflectorDesc floor;
    const seaglass::ViewDesc view;
    const bool refused = seaglass::createContext(&device, &context) == Status::invalidArgument &&
                         seaglass::createReflector(nullptr, &floor, &reflector) == Status::invalidArgument &&
                         seaglass::reflect(VK_NULL_HANDLE, &reflector, 1, &view) == Status::invalidArgument &&
                         seaglass::reflectionImages(nullptr, 0).color == VK_NULL_HANDLE;
    seaglass::destroyReflector(reflector);
    seaglass::destroyContext(context);
    const bool listed =
        seaglass::fieldsOf(device).count > 0 && seaglass::fieldsOf(floor.reflection).count > 0;
    return refused && listed && needed.apiVersion > 0 ? 0 : 1;
}
