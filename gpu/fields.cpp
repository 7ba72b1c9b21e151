#include "gpu/fields.h"

namespace seaglass {

bool isRead(const FieldTable& table, const Field& field, const void* desc) {
    const auto kind = static_cast<uint32_t>(table.fields[0].get(desc, 0));
    return field.readBy == 0 || (kind < 32 && (field.readBy >> kind & 1u) != 0);
}

FieldError refused(const char* owner, const Field& field) {
    FieldError line;
    line.add(owner).add(".").add(field.name).add(" is out of range, expected ");
    addExpected(line, field);
    return line;
}

FieldError badField(const FieldTable& table, const void* desc) {
    const Field* bad = outOfRange(table, desc);
    return bad ? refused(table.desc, *bad) : FieldError();
}

} // namespace seaglass
